#include "app/hands.h"

#include "haptics/virtual_device.h"
#include "scenes/scene.h"

namespace halsted::app {
namespace {

/// Both devices stand before the opening, as beside a patient: their workspaces overlap in the operating field. Motion is magnified
/// 1.5 times so that the 160 x 120 x 70 mm of a Touch cover a pull of the thread (design).
haptics::WorkspaceMapping operatingField() {
  haptics::WorkspaceMapping mapping;
  mapping.origin.position = Vec3(0.0, 10e-3, 30e-3);             // [m] world
  mapping.scale = 1.5;                                           // [1]
  return mapping;
}

}  // namespace

bool heldByPerson(const DeviceChoice& choice) { return choice.mover == Mover::kMouse || !choice.hardware.driver.empty(); }

DeviceChoice parseDevice(const std::string& option, const std::string& text) {
  if (text == "virtual") return {text, Mover::kNobody, "", {}};
  if (text == "mouse") return {text, Mover::kMouse, "", {}};
  if (text.rfind("script:", 0) == 0 && text.size() > 7) return {text, Mover::kScript, text.substr(7), {}};
  if (HardwareChoice hardware = parseHardware(text); !hardware.driver.empty()) return {text, Mover::kNobody, "", hardware};
  throw scenes::InputError(option + " " + text + ": unknown device; virtual, mouse, script:FILE, falcon[:SERIAL], open[:SERIAL] or vendor[:NAME]");
}

Hand makeHand(const DeviceChoice& choice, const Pose& start) {
  Hand hand;
  hand.config.period = kHapticPeriod;
  hand.config.mapping = operatingField();
  hand.state.lastPosition = start.position;      // where the tool waits until the device is ready
  hand.state.lastOrientation = start.orientation;
  if (!choice.hardware.driver.empty()) {
    hand.device = openHardware(choice.hardware);
    return hand;
  }
  const char* kind = choice.mover == Mover::kMouse ? "mouse" : choice.mover == Mover::kScript ? "script" : "virtual";
  hand.device = std::make_unique<haptics::VirtualDevice>(haptics::toDevice(hand.config.mapping, start), haptics::TouchDynamics{},
                                                         haptics::HandDynamics{}, kind);
  return hand;
}

}  // namespace halsted::app
