#pragma once
/// What is scheduled. Client threads add, remove and wait; the servo thread takes them in order of decreasing priority, equal ones in
/// the order in which they came. A fixed table: no heap. Each call holds the lock for its own length, never over a callback.
#include <HD/hdScheduler.h>

#include <array>

#include "haptics/hd/clock.h"
#include "haptics/hd/lock.h"

namespace halsted::haptics::hd {

struct Operation {
  HDSchedulerCallback callback = nullptr;
  void* userData = nullptr;
  HDushort priority = 0;
  bool synchronous = false;
  HHD device = HD_INVALID_HANDLE;              // current one of the thread that waits, passed on to the callback and back
};

class OperationTable {
 public:
  static constexpr int kCapacity = 512;

  struct Ticket {
    int slot = -1;
    HDSchedulerHandle handle = 0;
  };
  using Order = std::array<Ticket, kCapacity>;

  OperationTable() noexcept;

  /// 0 when the table is full. Handles start at 1 and never come twice.
  HDSchedulerHandle add(const Operation&) noexcept;
  /// What is scheduled now, in order; servo thread, at the start of a tick.
  int copyOrder(Order&) noexcept;
  /// False when it was removed meanwhile.
  bool begin(const Ticket&, Operation&) noexcept;
  void end(const Ticket&, HDCallbackCode, HHD deviceNow) noexcept;

  /// False when it had already finished. `patience`: how long to wait for a callback that is running now.
  bool remove(HDSchedulerHandle, Nanoseconds patience) noexcept;
  bool isScheduled(HDSchedulerHandle) noexcept;
  bool wasIssued(HDSchedulerHandle) noexcept;
  /// Until it has finished, or until `release` was called. True: it has finished; then `device` is what its callback left current.
  bool waitFor(HDSchedulerHandle, HHD* device) noexcept;
  /// The servo loop runs, or has stopped: in the second case whoever waits is let go.
  void setServed(bool served) noexcept;

 private:
  struct Slot {
    Operation operation;
    HDSchedulerHandle handle = 0;              // 0: free
    bool running = false, removed = false;
  };

  int slotOf(HDSchedulerHandle) const noexcept;
  void free(int slot) noexcept;

  InheritingMutex mutex_;
  pthread_cond_t finished_;
  std::array<Slot, kCapacity> slots_;
  std::array<int, kCapacity> order_{};         // slots in use, by priority
  int count_ = 0;
  HDSchedulerHandle next_ = 1;
  bool served_ = false;
  struct Left {
    HDSchedulerHandle handle = 0;
    HHD device = HD_INVALID_HANDLE;
  };
  std::array<Left, kCapacity> left_;           // by slot, of the last operation that finished there
};

}  // namespace halsted::haptics::hd
