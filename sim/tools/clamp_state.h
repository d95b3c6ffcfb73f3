#pragma once
/// Clamps in the assistant's hands. Part of `State` in a scene that lays some out; written by sim/tools/standing_clamps.
#include <array>
#include <cstdint>

#include "sim/exchange.h"
#include "sim/tools/tool_state.h"
#include "sim/types.h"

namespace halsted {

/// Why the assistant does not take a clamp over. kNone: the last one offered was taken.
enum class ClampRefusal : std::int32_t { kNone, kNoClamp, kHoldsNothing, kNoneLeft };

/// In a sentence, for the surgeon.
inline const char* name(ClampRefusal r) {
  switch (r) {
    case ClampRefusal::kNone: return "taken";
    case ClampRefusal::kNoClamp: return "only an Allis clamp is taken over";
    case ClampRefusal::kHoldsNothing: return "the clamp holds no tissue";
    case ClampRefusal::kNoneLeft: return "no other clamp is left for this hand";
  }
  return "unknown";
}

struct StandingClamp {
  std::int32_t hand = 0;                       // that closed it: it is this one's instrument
  std::int32_t second = 0;                     // 1: its second instrument
  double jaw = 0.0;                            // [1]
  Pose held;                                   // where the assistant would keep it
  Pose pose;                                   // where the tissue has drawn it
  TissueGrasp grasp;                           // `local` in the frame of `pose`
};

struct StandingClamps {
  std::array<StandingClamp, kMostClamps> clamp;
  std::int32_t count = 0;
  std::int32_t left = 0;                       // not handed out yet
  std::int32_t refusal = 0;                    // ClampRefusal, of the last clamp offered
};

}  // namespace halsted
