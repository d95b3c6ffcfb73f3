#pragma once
/// Levels between two threads: the newest value wins.
#include <atomic>
#include <cstdint>

namespace halsted {

/// Wait-free hand-over of the newest value from one writer thread to one reader thread.
/// The writer owns a slot, the reader owns a slot, the third waits in `middle_`; each call is one atomic exchange.
/// T is copied only at construction: vectors inside it keep their capacity, so filling `back()` need not allocate.
template <typename T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial = T{}) : slots_{{initial}, {initial}, {initial}} {}
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  T& back() noexcept { return slots_[back_].value; }             // writer: fill every field, old contents are unspecified
  void publish() noexcept { back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & kIndex; }

  bool acquire() noexcept {                                      // reader: true if there is a newer value
    if (!(middle_.load(std::memory_order_relaxed) & kFresh)) return false;
    front_ = middle_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }
  const T& front() const noexcept { return slots_[front_].value; }

 private:
  static constexpr std::uint32_t kIndex = 3, kFresh = 4;
  struct alignas(64) Slot { T value; };                          // 64 B: one cache line each
  Slot slots_[3];
  alignas(64) std::atomic<std::uint32_t> middle_{1};
  alignas(64) std::uint32_t back_ = 0;                           // writer's
  alignas(64) std::uint32_t front_ = 2;                          // reader's
};

}  // namespace halsted
