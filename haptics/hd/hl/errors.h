#pragma once
/// The errors of the HL API: a stack for the process, the last one first, the oldest lost when it is full. Any thread.
#include <HL/hl.h>

namespace halsted::haptics::hl {

void raise(HLenum code, const HDErrorInfo& device = {}) noexcept;
HLerror popError() noexcept;

}  // namespace halsted::haptics::hl
