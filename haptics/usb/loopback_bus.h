#pragma once
/// A bus in software and in virtual time: device models plug in and out of it, and every fault of a cable can be made to happen.
/// Deterministic; one thread. `wait` and the blocking calls of a link advance the clock of every model, 50 us at a time: a full-speed
/// bus moves a packet of 64 bytes in about that.
#include <deque>

#include "haptics/usb/usb.h"
#include "haptics/usb/usb_model.h"

namespace halsted::haptics {

/// What goes wrong on the wire of one device. Counters count down packet by packet.
struct UsbFaults {
  double silentFor = 0.0;                      // [s] the device does not answer and takes nothing: a stall
  int corruptPackets = 0;                      // IN packets of more than two bytes with one bit turned over
  int shortPackets = 0;                        // IN packets that lose their second half
  int failedTransfers = 0;                     // IN transfers that end with `failure`
  UsbStatus failure = UsbStatus::kStalled;
  UsbStatus refuseOpen = UsbStatus::kOk;       // kNoPermission, kBusy
  unsigned where = 0;                          // walks through the packet: each broken one breaks elsewhere
};

class LoopbackBus final : public UsbBus {
 public:
  /// The model must outlive the bus. Returns the port it sits in.
  int plug(UsbModel&);
  void unplug(int port);
  void replug(int port);
  UsbFaults& faults(int port);

  std::vector<UsbDeviceInfo> list() override;
  std::unique_ptr<UsbLink> open(const UsbDeviceInfo&, int interfaces, UsbStatus&) override;
  void wait(double longest) noexcept override { advance(longest); }  // [s]
  std::uint64_t plugEvents() const noexcept override { return plugEvents_; }
  double now() const noexcept override { return time_; }

  void advance(double dt) noexcept;                                // [s]

 private:
  friend class LoopbackLink;
  struct Port {
    UsbModel* model = nullptr;
    UsbFaults faults;
    class LoopbackLink* link = nullptr;        // who has it open
    bool attached = false;
  };
  void advanceOnce(double dt) noexcept;                            // [s]

  std::deque<Port> ports_;                     // never moves: links point into it
  std::uint64_t plugEvents_ = 0;
  double time_ = 0.0;                          // [s]
};

}  // namespace halsted::haptics
