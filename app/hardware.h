#pragma once
/// Real devices by the name that the command line gives them. Main thread; may take seconds, since devices are brought up here.
#include <memory>
#include <string>
#include <vector>

#include "haptics/device.h"
#include "haptics/usb/usb_device.h"

namespace halsted::app {

struct HardwareChoice {
  std::string driver;                          // falcon, open, vendor; empty: none
  std::string name;                            // serial number, or the vendor's name for it; empty: the first there is
  std::string firmware;                        // file with the Falcon's firmware; empty: HALSTED_FALCON_FIRMWARE, or none
};
/// Understands `falcon[:SERIAL]`, `open[:SERIAL]`, `vendor[:NAME]`; an empty driver for anything else.
HardwareChoice parseHardware(const std::string& text);

/// What is attached and can be driven, as the command line would name it, in order of bus and port.
std::vector<std::string> attachedHardware();

/// Fills the hands that were given no device (empty) with what is attached and not named for the other one: the right hand first. A hand
/// for which there is nothing stays empty.
void takeAttached(std::vector<std::string> attached, std::string& left, std::string& right);

/// The driver of a USB device; null where `driver` has none. Throws scenes::InputError for a firmware file that cannot be read.
std::unique_ptr<haptics::UsbProtocol> usbProtocol(const HardwareChoice&);

/// Finds the device and brings it up. Throws SystemFault in one line: what, why, remedy.
std::unique_ptr<haptics::Device> openHardware(const HardwareChoice&);

/// Serves a device on this thread until it stands still (ready, or waiting for a hand, or not to be had), at most `longest` [s].
haptics::DeviceStatus bringUp(haptics::UsbDevice&, haptics::UsbBus&, double longest);

}  // namespace halsted::app
