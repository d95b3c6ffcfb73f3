#pragma once
/// Events and records between two threads: nothing is lost without being counted.
#include <atomic>
#include <cstdint>
#include <vector>

namespace halsted::app {

/// Bounded first-in first-out queue from one writer thread to one reader thread; wait-free, no heap after construction.
/// A full ring drops the new value and counts it: the writer (a real-time thread) never waits for the reader.
template <typename T>
class SpscRing {
 public:
  explicit SpscRing(std::size_t capacity) : slots_(capacity + 1) {}
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  bool push(const T& value) noexcept {                           // writer: false when full
    const std::size_t tail = tail_.load(std::memory_order_relaxed), next = following(tail);
    if (next == head_.load(std::memory_order_acquire)) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    slots_[tail] = value;
    tail_.store(next, std::memory_order_release);
    return true;
  }

  bool pop(T& value) noexcept {                                  // reader: false when empty
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head == tail_.load(std::memory_order_acquire)) return false;
    value = slots_[head];
    head_.store(following(head), std::memory_order_release);
    return true;
  }

  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }   // any thread

 private:
  std::size_t following(std::size_t index) const noexcept { return index + 1 == slots_.size() ? 0 : index + 1; }

  std::vector<T> slots_;                                         // one slot stays free: full and empty differ
  alignas(64) std::atomic<std::size_t> head_{0};                 // reader's
  alignas(64) std::atomic<std::size_t> tail_{0};                 // writer's
  alignas(64) std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace halsted::app
