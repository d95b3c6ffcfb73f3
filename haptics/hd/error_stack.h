#pragma once
/// The error stack of the process: hdGetError pops the last one. Any thread.
#include <HD/hdDefines.h>

#include <array>

#include "haptics/hd/lock.h"

namespace halsted::haptics::hd {

class ErrorStack {
 public:
  /// A program that never asks loses the oldest ones.
  static constexpr int kDepth = 64;

  void push(HDerror code, HHD device) noexcept;
  HDErrorInfo pop() noexcept;

 private:
  InheritingMutex mutex_;
  std::array<HDErrorInfo, kDepth> ring_{};
  int top_ = 0;                                // where the next one goes
  int count_ = 0;
};

/// "HD_ILLEGAL_BEGIN: ..." for every code of the API; never null.
const char* errorText(HDerror code) noexcept;

}  // namespace halsted::haptics::hd
