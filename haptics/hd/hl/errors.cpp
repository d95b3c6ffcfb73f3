#include "haptics/hd/hl/errors.h"

#include <array>

#include "haptics/hd/lock.h"

namespace halsted::haptics::hl {
namespace {

constexpr unsigned kDepth = 64;

struct Stack {
  hd::InheritingMutex mutex;
  std::array<HLerror, kDepth> entries;
  unsigned top = 0, count = 0;                 // `top`: where the next one goes
};

/// Never destroyed: a program may ask while it exits.
Stack& stack() {
  static Stack& only = *new Stack;
  return only;
}

}  // namespace

void raise(HLenum code, const HDErrorInfo& device) noexcept {
  Stack& errors = stack();
  const hd::Hold hold(errors.mutex);
  errors.entries[errors.top] = {code, device};
  errors.top = (errors.top + 1) % kDepth;
  if (errors.count < kDepth) ++errors.count;
}

HLerror popError() noexcept {
  Stack& errors = stack();
  const hd::Hold hold(errors.mutex);
  if (errors.count == 0) return {HL_NO_ERROR, {}};
  --errors.count;
  errors.top = (errors.top + kDepth - 1) % kDepth;
  return errors.entries[errors.top];
}

}  // namespace halsted::haptics::hl
