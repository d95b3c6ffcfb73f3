#pragma once
/// What every fuzz target of a reader allows: the input is accepted, or refused with one InputError line. Anything else is a find.
#include <cstdlib>
#include <string>

#include "scenes/scene.h"

namespace halsted::fuzz {

/// Stops the run, so that the fuzzer keeps the input.
inline void require(bool law) {
  if (!law) std::abort();
}

/// True when `read` accepted its input.
template <typename Read>
bool accepted(const Read& read) {
  try {
    read();
    return true;
  } catch (const scenes::InputError& refusal) {
    const std::string line = refusal.what();
    require(!line.empty() && line.find('\n') == std::string::npos && line.size() < 4000);
    return false;
  }
}

}  // namespace halsted::fuzz
