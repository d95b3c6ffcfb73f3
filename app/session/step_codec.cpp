#include "app/session/step_codec.h"

#include <bit>
#include <cmath>

namespace halsted::app {
namespace {

using Bytes = std::vector<std::uint8_t>;

void appendInteger(std::uint64_t value, int width, Bytes& bytes) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}
void appendReal(double value, Bytes& bytes) { appendInteger(std::bit_cast<std::uint64_t>(value), 8, bytes); }   // any unit

/// Reads forward through a span of the right size.
struct Cursor {
  std::span<const std::uint8_t> bytes;
  std::size_t at = 0;

  std::uint64_t integer(int width) {
    std::uint64_t value = 0;
    for (int i = 0; i < width; ++i) value |= static_cast<std::uint64_t>(bytes[at++]) << (8 * i);
    return value;
  }
  double real() { return std::bit_cast<double>(integer(8)); }
  Vec3 vector() {
    Vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = real();
    return v;
  }
  Pose pose() {
    Pose pose;
    pose.position = vector();
    for (int i = 0; i < 4; ++i) pose.orientation.coeffs()[i] = real();
    return pose;
  }
};

}  // namespace

void appendWord(std::uint64_t value, Bytes& bytes) { appendInteger(value, 8, bytes); }

void appendPose(const Pose& pose, Bytes& bytes) {
  for (int i = 0; i < 3; ++i) appendReal(pose.position[i], bytes);
  for (int i = 0; i < 4; ++i) appendReal(pose.orientation.coeffs()[i], bytes);
}

void appendStepInput(const StepInput& input, Bytes& bytes) {
  for (const ToolSample& tool : input.tools) {
    appendInteger(tool.tick, 8, bytes);
    appendPose(tool.pose, bytes);
    for (int i = 0; i < 3; ++i) appendReal(tool.velocity[i], bytes);
    appendReal(tool.jaw, bytes);
    appendInteger(tool.presses, 4, bytes);
  }
  appendInteger(static_cast<std::uint8_t>(input.command.kind), 1, bytes);
  appendReal(input.command.value, bytes);
}

std::uint64_t decodeWord(std::span<const std::uint8_t> bytes) { return Cursor{bytes}.integer(8); }
Pose decodePose(std::span<const std::uint8_t> bytes) { return Cursor{bytes}.pose(); }

StepInput decodeStepInput(std::span<const std::uint8_t> bytes) {
  Cursor in{bytes};
  StepInput input;
  for (ToolSample& tool : input.tools) {
    tool.tick = in.integer(8);
    tool.pose = in.pose();
    tool.velocity = in.vector();
    tool.jaw = in.real();
    tool.presses = static_cast<std::uint32_t>(in.integer(4));
  }
  input.command.kind = static_cast<Command::Kind>(in.integer(1));
  input.command.value = in.real();
  return input;
}

std::string flaw(const Pose& pose) {
  constexpr double kReach = 10.0;              // [m] no device stands farther from the patient
  if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite()) return "a pose that is not finite";
  if (pose.position.norm() > kReach) return "a position out of reach";
  if (std::abs(pose.orientation.squaredNorm() - 1.0) > 1e-6) return "an orientation that is not a rotation";
  return {};
}

std::string flaw(const StepInput& input) {
  constexpr double kFastest = 1e3;             // [m/s]
  for (const ToolSample& tool : input.tools) {
    const std::string poseFlaw = flaw(tool.pose);
    if (!poseFlaw.empty()) return poseFlaw;
    if (!tool.velocity.allFinite() || tool.velocity.norm() > kFastest) return "an impossible velocity";
    if (!(tool.jaw >= 0.0 && tool.jaw <= 1.0)) return "a jaw opening outside 0 to 1";
  }
  if (input.command.kind > Command::Kind::kHandOver || !std::isfinite(input.command.value)) return "an unknown command";
  return {};
}

}  // namespace halsted::app
