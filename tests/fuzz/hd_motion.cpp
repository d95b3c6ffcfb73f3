/// Any bytes as a recorded hand: refused in one line, or a motion whose every moment is a pose.
#include <cmath>
#include <cstdint>
#include <sstream>

#include "haptics/hd/motion.h"
#include "tests/fuzz/accepted.h"

using namespace halsted;
using namespace halsted::haptics::hd;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
  Motion motion;
  try {
    motion = readMotion(in, "hand.csv");
  } catch (const MotionError& refusal) {
    const std::string line = refusal.what();
    fuzz::require(line.starts_with("hand.csv:") && line.find('\n') == std::string::npos && line.size() < 400);
    return 0;
  }
  fuzz::require(!motion.samples.empty() && motion.samples.front().time == 0.0 && std::isfinite(motion.duration()));
  std::size_t cursor = 0;
  for (int i = -1; i <= 20; ++i) {
    const MotionSample now = sampleAt(motion, motion.duration() * i / 19.0, cursor);
    const double length = now.pose.orientation.squaredNorm();  // [1]
    fuzz::require(now.pose.position.allFinite() && now.pose.position.norm() < 2.0 && length > 0.99 && length < 1.01 && now.buttons < 16);
  }
  return 0;
}
