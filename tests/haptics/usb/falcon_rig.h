#pragma once
/// A Falcon model on a loopback bus, its driver, and the tick of a hand that holds it: virtual time, one thread.
#include <memory>

#include "haptics/falcon/falcon_model.h"
#include "haptics/falcon/falcon_protocol.h"
#include "haptics/hand_loop.h"
#include "haptics/usb/loopback_bus.h"
#include "haptics/usb/usb_device.h"

namespace halsted::haptics {

/// Bytes that only the model takes for firmware: the real one belongs to the device's maker and is never shipped.
inline std::vector<std::uint8_t> modelFirmware() {
  std::vector<std::uint8_t> bytes(7900);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 37 + i / 251);
  return bytes;
}

/// Shared ownership of something that the rig owns.
template <typename T>
std::shared_ptr<UsbBus> borrowed(T& bus) { return {&bus, [](UsbBus*) {}}; }

struct FalconRig {
  explicit FalconRig(const FalconModelOptions& options = homedFalcon(), std::vector<std::uint8_t> firmware = {}, const UsbBinding& binding = {})
      : model(options), device(borrowed(bus), std::make_unique<FalconProtocol>(std::move(firmware)), binding) {
    port = bus.plug(model);
    contact.touching = true;
  }
  static FalconModelOptions homedFalcon() {
    FalconModelOptions options;
    options.homed = true;
    return options;
  }
  /// A spring of 400 N/m that pulls the grip to `anchor`, felt at once.
  void spring(const Vec3& anchor, double stiffness = 400.0) {     // [m] [N/m]
    contact.step = ++steps;
    contact.position = anchor;
    contact.force = Vec3::Zero();
    contact.stiffness = Mat3::Identity() * stiffness;
    contact.touching = true;
  }
  /// One millisecond: the cable, the driver, the tick.
  void tick() {
    bus.advance(1e-3);
    device.serviceOnce();
    contact.step = ++steps;
    haptics::tick(device, config, contact, target, ++index, state, output);
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }

  LoopbackBus bus;
  FalconModel model;
  UsbDevice device;
  int port = 0;
  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  HandTarget target;
  std::uint64_t index = 0, steps = 0;
};

}  // namespace halsted::haptics
