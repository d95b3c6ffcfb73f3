#include "haptics/hd/operation_table.h"

namespace halsted::haptics::hd {

OperationTable::OperationTable() noexcept {
  pthread_condattr_t kind;
  pthread_condattr_init(&kind);
  pthread_condattr_setclock(&kind, CLOCK_MONOTONIC);
  pthread_cond_init(&finished_, &kind);
  pthread_condattr_destroy(&kind);
}

int OperationTable::slotOf(HDSchedulerHandle handle) const noexcept {
  for (int i = 0; i < count_; ++i)
    if (slots_[order_[i]].handle == handle) return order_[i];
  return -1;
}

HDSchedulerHandle OperationTable::add(const Operation& operation) noexcept {
  const Hold hold(mutex_);
  if (count_ == kCapacity) return 0;
  int slot = 0;
  while (slots_[slot].handle != 0) ++slot;
  slots_[slot] = {operation, next_++, false, false};

  int place = count_++;
  for (; place > 0 && slots_[order_[place - 1]].operation.priority < operation.priority; --place) order_[place] = order_[place - 1];
  order_[place] = slot;
  return slots_[slot].handle;
}

int OperationTable::copyOrder(Order& order) noexcept {
  const Hold hold(mutex_);
  for (int i = 0; i < count_; ++i) order[i] = {order_[i], slots_[order_[i]].handle};
  return count_;
}

bool OperationTable::begin(const Ticket& ticket, Operation& operation) noexcept {
  const Hold hold(mutex_);
  Slot& slot = slots_[ticket.slot];
  if (slot.handle != ticket.handle || slot.removed) return false;
  slot.running = true;
  operation = slot.operation;
  return true;
}

void OperationTable::end(const Ticket& ticket, HDCallbackCode code, HHD deviceNow) noexcept {
  const Hold hold(mutex_);
  Slot& slot = slots_[ticket.slot];
  slot.running = false;
  slot.operation.device = deviceNow;
  if (code == HD_CALLBACK_CONTINUE && !slot.removed) return;
  left_[ticket.slot] = {ticket.handle, deviceNow};
  free(ticket.slot);
  pthread_cond_broadcast(&finished_);
}

void OperationTable::free(int slot) noexcept {
  --count_;
  int place = 0;
  while (order_[place] != slot) ++place;
  for (; place < count_; ++place) order_[place] = order_[place + 1];
  slots_[slot].handle = 0;
}

bool OperationTable::remove(HDSchedulerHandle handle, Nanoseconds patience) noexcept {
  const Hold hold(mutex_);
  const int slot = slotOf(handle);
  if (slot < 0 || slots_[slot].removed) return false;
  slots_[slot].removed = true;
  if (!slots_[slot].running) {
    free(slot);
    pthread_cond_broadcast(&finished_);
    return true;
  }
  const timespec until = asTimespec(monotonicNow() + patience);
  while (patience > 0 && slots_[slot].handle == handle)
    if (pthread_cond_timedwait(&finished_, mutex_.native(), &until) != 0) break;
  return true;
}

bool OperationTable::isScheduled(HDSchedulerHandle handle) noexcept {
  const Hold hold(mutex_);
  const int slot = slotOf(handle);
  return slot >= 0 && !slots_[slot].removed;
}

bool OperationTable::wasIssued(HDSchedulerHandle handle) noexcept {
  const Hold hold(mutex_);
  return handle > 0 && handle < next_;
}

bool OperationTable::waitFor(HDSchedulerHandle handle, HHD* device) noexcept {
  const Hold hold(mutex_);
  const int slot = slotOf(handle);
  if (slot < 0) return true;
  while (served_ && slots_[slot].handle == handle) pthread_cond_wait(&finished_, mutex_.native());
  if (slots_[slot].handle == handle) return false;
  if (device && left_[slot].handle == handle) *device = left_[slot].device;
  return true;
}

void OperationTable::setServed(bool served) noexcept {
  const Hold hold(mutex_);
  served_ = served;
  pthread_cond_broadcast(&finished_);
}

}  // namespace halsted::haptics::hd
