#include "app/hardware.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "app/errors.h"
#include "haptics/falcon/falcon_protocol.h"
#include "haptics/open_device/open_protocol.h"
#include "haptics/usb/known_devices.h"
#include "haptics/usb/libusb_bus.h"
#include "haptics/vendor/vendor_device.h"
#include "scenes/scene.h"

namespace halsted::app {
namespace {

using haptics::DeviceProblem;
using haptics::DeviceStage;

constexpr std::uint64_t kSettled = 10;         // readings until a device that says it is not homed is believed
constexpr double kBringUp = 8.0;               // [s] an upload of firmware takes one
constexpr std::uintmax_t kLargestFirmware = 1 << 20;

std::vector<std::uint8_t> readFirmware(const std::string& given) {
  const char* variable = std::getenv("HALSTED_FALCON_FIRMWARE");
  const std::string path = !given.empty() ? given : variable ? variable : "";
  if (path.empty()) return {};
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes;
  for (std::istreambuf_iterator<char> at(file), end; at != end && bytes.size() <= kLargestFirmware; ++at) bytes.push_back(static_cast<std::uint8_t>(*at));
  if (bytes.empty()) throw scenes::InputError(path + ": no firmware: the file cannot be read or is empty");
  if (bytes.size() > kLargestFirmware) throw scenes::InputError(path + ": no firmware: larger than 1 MiB");
  return bytes;
}

[[noreturn]] void refuse(const std::string& what, DeviceProblem problem) {
  throw SystemFault(what + ": " + haptics::problemText(problem) + "; " + haptics::remedyText(problem));
}

}  // namespace

HardwareChoice parseHardware(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string driver = text.substr(0, colon);
  if (driver != "falcon" && driver != "open" && driver != "vendor") return {};
  return {driver, colon == std::string::npos ? "" : text.substr(colon + 1), ""};
}

std::vector<std::string> attachedHardware() {
  std::vector<std::string> names;
  haptics::LibusbBus bus;
  for (const haptics::UsbDeviceInfo& usb : bus.list())
    if (const haptics::KnownDevice* known = haptics::knownDevice(usb); known && known->drive == haptics::Drive::kDriven)
      names.push_back(std::string(known->driver) + (usb.serial.empty() ? "" : ":" + usb.serial));
  return names;
}

void takeAttached(std::vector<std::string> attached, std::string& left, std::string& right) {
  for (const std::string* named : {&left, &right}) {             // `falcon` alone takes the first Falcon, as its driver will
    const auto answersTo = [&](const std::string& device) { return device == *named || device.starts_with(*named + ":"); };
    if (const auto it = std::find_if(attached.begin(), attached.end(), answersTo); !named->empty() && it != attached.end()) attached.erase(it);
  }
  for (std::string* free : {&right, &left}) {
    if (!free->empty() || attached.empty()) continue;
    *free = attached.front();
    attached.erase(attached.begin());
  }
}

std::unique_ptr<haptics::UsbProtocol> usbProtocol(const HardwareChoice& choice) {
  if (choice.driver == "falcon") return std::make_unique<haptics::FalconProtocol>(readFirmware(choice.firmware));
  if (choice.driver == "open") return std::make_unique<haptics::OpenProtocol>();
  return nullptr;
}

haptics::DeviceStatus bringUp(haptics::UsbDevice& device, haptics::UsbBus& bus, double longest) {  // [s]
  const double until = bus.now() + longest;    // [s]
  do {
    device.serviceOnce();
    bus.wait(5e-3);
    const haptics::DeviceStatus status = device.status();
    if (status.stage == DeviceStage::kReady) return status;
    if (status.stage == DeviceStage::kHoming && device.counters().readings >= kSettled) return status;
    if (status.stage == DeviceStage::kSearching && status.problem != DeviceProblem::kNone) return status;
  } while (bus.now() < until);
  return device.status();
}

std::unique_ptr<haptics::Device> openHardware(const HardwareChoice& choice) {
  const std::string what = choice.driver + (choice.name.empty() ? "" : ":" + choice.name);
  if (choice.driver == "vendor") {
    auto device = haptics::VendorDevice::open(choice.name);
    if (!device.device) refuse(what, device.problem);
    return std::move(device.device);
  }
  auto bus = std::make_shared<haptics::LibusbBus>();
  if (!bus->available()) refuse(what, DeviceProblem::kNoUsb);
  auto device = std::make_unique<haptics::UsbDevice>(bus, usbProtocol(choice), haptics::UsbBinding{choice.name, ""});
  const haptics::DeviceStatus status = bringUp(*device, *bus, kBringUp);
  if (status.stage == DeviceStage::kSearching || status.stage == DeviceStage::kStarting) refuse(what, status.problem);
  return device;
}

}  // namespace halsted::app
