#pragma once
/// Which instrument each hand holds. Part of `State` in a scene that lays out a second one; written by sim/tools/instrument.
#include <array>
#include <cstdint>

#include "sim/types.h"

namespace halsted {

/// Why the assistant does not change an instrument. kNone: the last one asked for was changed.
enum class InstrumentRefusal : std::int32_t { kNone, kNoOther, kHandFull, kInTheWay };

/// In a sentence, for the surgeon.
inline const char* name(InstrumentRefusal r) {
  switch (r) {
    case InstrumentRefusal::kNone: return "changed";
    case InstrumentRefusal::kNoOther: return "no other instrument is laid out for this hand";
    case InstrumentRefusal::kHandFull: return "let go of what the instrument holds first";
    case InstrumentRefusal::kInTheWay: return "hold the instrument clear of the tissue and of the other one";
  }
  return "unknown";
}

struct InstrumentState {
  std::array<std::int32_t, kHands> second{};   // 1: the hand holds its second instrument
  std::int32_t refusal = 0;                    // InstrumentRefusal, of the last change asked for
};

}  // namespace halsted
