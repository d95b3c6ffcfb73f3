#pragma once
/// What a session file (.halsted, SQLite) holds. Replay needs nothing else: scene, parameters and anatomy are inside.
///   meta(key, value)                      scene, dt, seed, program, created, trainee, devices, closed, state_hash (of the last step, once closed)
///   parameter(key, value)                 every number and text of the scene, resolved, as `--set` takes it; early files have no texts
///   anatomy(content, hash)                mesh_codec
///   start(hand, pose)                     where the tools began
///   chunk(first_step, count, inputs, hashes)   consumed StepInputs (step_codec) and the state hash after each
///   event(step, kind, hand, idx, value)   what happened
///   state(step, content)                  a whole state now and then: where a replay can begin, and which field differs when a hash does
///   haptic(first_tick, count, records)    what the devices were sent, real time only
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/anatomy.h"
#include "sim/step.h"

namespace halsted::app {

inline constexpr std::int64_t kSessionMagic = 0x48535444;      // "HSTD", SQLite's application_id
inline constexpr std::int64_t kSessionFormat = 1;              // SQLite's user_version
inline constexpr std::uint64_t kStateInterval = 5000;          // steps between whole states

struct SessionHeader {
  std::string scene;                           // folder name
  std::string sceneText, expertText;           // as read
  std::vector<std::string> overrides;          // as given
  std::vector<std::string> parameters;         // "key=value", resolved
  std::string program, created, trainee;
  std::array<std::string, kHands> devices;
  double dt = 1e-3;                            // [s]
  std::uint64_t seed = 1;
  std::array<Pose, kHands> start;
  Anatomy anatomy;
};

/// One haptic tick as recorded: what was late and what was felt.
struct HapticRecord {
  std::uint64_t tick = 0;
  float latenessMicroseconds = 0.0f;           // [us] wake-up after the scheduled time
  std::array<std::array<float, 3>, kHands> force{};   // [N] sent
  std::array<std::uint32_t, kHands> faults{};  // haptics/limits.h
};

}  // namespace halsted::app
