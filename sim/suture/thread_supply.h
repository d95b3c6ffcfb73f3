#pragma once
/// Needled threads on the table, and what had been counted when the one in use was handed. Part of `State` in a scene with
/// `thread.spare`; written by sim/suture/fresh_thread.
#include <cstdint>

namespace halsted {

/// Why the assistant hands no thread. kNone: the last one asked for was handed.
enum class ThreadRefusal : std::int32_t { kNone, kNoneLeft, kHandsFull, kNotTied, kNoRoom, kInTheWay, kNoDriver };

/// In a sentence, for the surgeon.
inline const char* name(ThreadRefusal r) {
  switch (r) {
    case ThreadRefusal::kNone: return "handed";
    case ThreadRefusal::kNoneLeft: return "no needled thread is left on the table";
    case ThreadRefusal::kHandsFull: return "let go of needle and thread first";
    case ThreadRefusal::kNotTied: return "the stitch is not tied and its needle not cut off";
    case ThreadRefusal::kNoRoom: return "this stitch has more holes than can be kept, or there are too many stitches";
    case ThreadRefusal::kNoDriver: return "take the needle driver in the right hand first";
    case ThreadRefusal::kInTheWay: return "hold the needle driver clear of the wound, where the thread can hang free";
  }
  return "unknown";
}

struct ThreadSupply {
  std::int32_t left = 0, handed = 0;           // on the table; after the first
  std::int32_t refusal = 0;                    // ThreadRefusal, of the last one asked for
  // Bites, full-thickness bites and tears before the thread in use: the procedure's quantities count those of the thread in use.
  std::int32_t bitesBefore = 0, fullThicknessBefore = 0, tearsBefore = 0;
};

}  // namespace halsted
