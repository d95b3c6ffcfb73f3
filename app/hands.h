#pragma once
/// A hand: its device, the servo loop that renders force on it, and who moves it when nobody holds it.
/// Lives on the haptic thread; in lockstep on the only one.
#include <array>
#include <memory>
#include <string>

#include "app/hardware.h"
#include "haptics/device.h"
#include "haptics/hand_loop.h"

namespace halsted::app {

enum class Mover { kNobody, kMouse, kScript };

/// What `--left` and `--right` ask for.
struct DeviceChoice {
  std::string text = "virtual";                // as given: virtual, mouse, script:FILE
  Mover mover = Mover::kNobody;
  std::string scriptPath;
  HardwareChoice hardware;                     // no driver: a hand in software
};
/// A person's hand is on it: whether anything is left to do is for that person to say.
bool heldByPerson(const DeviceChoice&);
/// Throws scenes::InputError for a name that no device answers to.
DeviceChoice parseDevice(const std::string& option, const std::string& text);

struct Hand {
  std::unique_ptr<haptics::Device> device;
  haptics::HandLoopConfig config;
  haptics::HandLoopState state;
  haptics::HandLoopOutput output;
};
using Hands = std::array<Hand, kHands>;

inline constexpr double kHapticPeriod = 1e-3;  // [s]

/// The device at `start`, which is in the world. Throws SystemFault for hardware that cannot be had.
Hand makeHand(const DeviceChoice&, const Pose& start);

}  // namespace halsted::app
