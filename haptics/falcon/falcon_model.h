#pragma once
/// A Falcon in software, held by a simulated hand: FTDI chip, boot loader, firmware, encoders, motors, and a grip that really moves.
/// What public drivers do not tell is chosen the unkind way: unhomed encoders are off by an offset, and the motors keep their last
/// command for as long as nobody sends another.
#include <deque>
#include <vector>

#include "haptics/falcon/falcon_wire.h"
#include "haptics/usb/usb_model.h"
#include "haptics/virtual_device.h"

namespace halsted::haptics {

struct FalconModelOptions {
  std::string serial = "FALCON0";
  std::vector<std::uint8_t> firmware;          // what it accepts as firmware; empty: it has some and runs
  bool homed = false;
};

class FalconModel final : public UsbModel {
 public:
  explicit FalconModel(const FalconModelOptions& = {});

  UsbDeviceInfo info() const override;
  std::vector<std::uint8_t> descriptors() const override;
  void attach() override;
  UsbStatus control(const UsbControl&, std::span<std::uint8_t> data) override;
  void out(std::uint8_t endpoint, std::span<const std::uint8_t>) override;
  std::size_t in(std::uint8_t endpoint, std::span<std::uint8_t>) override;
  void advance(double dt) override;                              // [s]

  /// The hand on the grip; device frame.
  VirtualDevice& grip() { return grip_; }
  void moveHand(const Vec3& position);                           // [m]
  void setButtons(std::uint8_t buttons) { buttons_ = buttons; }
  Vec3 motorForce() const;                                       // [N] on the hand, device frame
  bool homed() const { return homed_ == kFalconAllHomed; }
  std::uint8_t lights() const { return command_.lights; }
  bool running() const { return mode_ == Mode::kRunning; }
  std::uint64_t commands() const { return commands_; }

 private:
  enum class Mode { kWaiting, kGreeted, kLoading, kRunning };
  void serialByte(std::uint8_t byte);
  void bootByte(std::uint8_t byte);
  void runByte(std::uint8_t byte);
  void home(const Vec3& legs);                                   // [rad]
  FalconReply reply() const;

  FalconModelOptions options_;
  VirtualDevice grip_;
  Mode mode_ = Mode::kWaiting;
  // FTDI chip.
  std::deque<std::uint8_t> toDevice_, toHost_;
  double bytesPerSecond_ = 960.0;              // [1/s]
  double credit_ = 0.0;                        // [1] bytes that the line has had time for
  double latency_ = 16e-3, sincePacket_ = 0.0; // [s]
  std::uint16_t divisor_ = 0;
  bool dtr_ = false, resetPulse_ = false;
  // Boot loader and firmware.
  std::vector<std::uint8_t> greeting_, loaded_;
  FalconFramer framer_;
  FalconCommand command_;
  std::array<int, 3> offset_{};                // counts: what an unhomed encoder is off by
  std::uint8_t homed_ = 0, buttons_ = 0;
  std::uint64_t commands_ = 0;
};

}  // namespace halsted::haptics
