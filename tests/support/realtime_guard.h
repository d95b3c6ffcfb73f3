#pragma once
/// Counts what real-time code must not call while it runs on this thread: the heap, locks, waits, sleeps, files and the terminal.
/// Linked into test programs only; it stands in front of the C library's functions. Not under sanitizers, which do the same.
/// Blind to: raw futex waits (std::atomic::wait), page faults, and calls that the C library resolves inside itself.
#include <cstdint>

namespace halsted::test {

/// While one lives, calls on its thread are counted. May be nested; each sees the calls made since it began.
class RealtimeGuard {
 public:
  RealtimeGuard() noexcept;
  ~RealtimeGuard();
  RealtimeGuard(const RealtimeGuard&) = delete;
  RealtimeGuard& operator=(const RealtimeGuard&) = delete;

  std::uint64_t calls() const noexcept;        // forbidden calls since this guard began
  const char* first() const noexcept;          // name of the first of them, or "none"
  static bool available() noexcept;            // false under a sanitizer: nothing is counted

 private:
  std::uint64_t before_;
};

}  // namespace halsted::test
