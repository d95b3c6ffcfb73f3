#pragma once
/// The bytes of one consumed StepInput in a session file: little-endian, fixed size, every bit kept. Any thread.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/step.h"

namespace halsted::app {

inline constexpr std::size_t kPoseBytes = 7 * 8;                                   // position, quaternion x y z w
inline constexpr std::size_t kSampleBytes = 8 + kPoseBytes + 3 * 8 + 8 + 4;        // tick, pose, velocity, jaw, presses
inline constexpr std::size_t kStepInputBytes = kHands * kSampleBytes + 1 + 8;      // both hands, command kind and value

void appendPose(const Pose&, std::vector<std::uint8_t>& bytes);
void appendStepInput(const StepInput&, std::vector<std::uint8_t>& bytes);
void appendWord(std::uint64_t value, std::vector<std::uint8_t>& bytes);

/// `bytes` must hold the fixed size. Decoding takes any bytes; `flaw` says what no device could have sent, empty when nothing.
Pose decodePose(std::span<const std::uint8_t> bytes);
StepInput decodeStepInput(std::span<const std::uint8_t> bytes);
std::uint64_t decodeWord(std::span<const std::uint8_t> bytes);
std::string flaw(const StepInput&);
std::string flaw(const Pose&);

}  // namespace halsted::app
