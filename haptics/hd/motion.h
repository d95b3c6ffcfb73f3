#pragma once
/// What a hand did, as a list of samples in time: a script or a recording, read from a text file. Reading: client threads, at
/// hdInitDevice. Playing: pure, no heap.
#include <istream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted::haptics::hd {

struct MotionSample {
  double time = 0.0;                           // [s] from the start of the motion
  Pose pose;                                   // device frame
  unsigned buttons = 0;                        // bit mask, as HD_CURRENT_BUTTONS
  bool inkwell = false;                        // the stylus is in the inkwell
};

struct Motion {
  std::vector<MotionSample> samples;           // in order of time; empty: no motion

  double duration() const noexcept { return samples.empty() ? 0.0 : samples.back().time; }  // [s]
};

/// One line: file, line and what is wrong with it.
class MotionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads either form (README): a table with a header line that names its columns, or a tool dynamometer trace ('%' comments, 1 ms a
/// row). Throws MotionError.
Motion readMotion(const std::string& path);
/// The same from a stream; `path` is for the messages.
Motion readMotion(std::istream& in, const std::string& path);

/// Between samples: position on the line, orientation on the chord; before the first and after the last: those.
/// `cursor` remembers where the last call was; begin with 0.
MotionSample sampleAt(const Motion&, double time, std::size_t& cursor) noexcept;  // [s]

}  // namespace halsted::haptics::hd
