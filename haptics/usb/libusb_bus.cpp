#include "haptics/usb/libusb_bus.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <tuple>

#include "haptics/usb/libusb_link.h"

namespace halsted::haptics {
namespace {

int LIBUSB_CALL onPlug(libusb_context*, libusb_device*, libusb_hotplug_event, void* bus) {
  static_cast<LibusbBus*>(bus)->countPlugEvent();
  return 0;
}

/// "1-2.3", as the kernel names the device's folder.
std::string portOf(libusb_device* device) {
  std::array<std::uint8_t, 8> numbers{};
  const int depth = libusb_get_port_numbers(device, numbers.data(), static_cast<int>(numbers.size()));
  std::string port = std::to_string(libusb_get_bus_number(device));
  for (int i = 0; i < depth; ++i) port += (i == 0 ? "-" : ".") + std::to_string(numbers[static_cast<std::size_t>(i)]);
  return port;
}

/// The kernel read the strings when the device was plugged in: no permission is needed for them.
std::string attributeOf(const std::string& port, const char* attribute) {
  std::ifstream file("/sys/bus/usb/devices/" + port + "/" + attribute);
  std::string text;
  std::getline(file, text);
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.pop_back();
  return text;
}

UsbDeviceInfo infoOf(libusb_device* device) {
  UsbDeviceInfo info;
  libusb_device_descriptor descriptor{};
  libusb_get_device_descriptor(device, &descriptor);
  info.vendor = descriptor.idVendor;
  info.product = descriptor.idProduct;
  info.bus = libusb_get_bus_number(device);
  info.address = libusb_get_device_address(device);
  info.port = portOf(device);
  info.serial = attributeOf(info.port, "serial");
  info.productName = attributeOf(info.port, "product");
  return info;
}

/// Calls `use` with each attached device.
template <typename Use>
void forEachDevice(libusb_context* context, Use&& use) {
  libusb_device** devices = nullptr;
  const auto count = libusb_get_device_list(context, &devices);
  for (long i = 0; i < static_cast<long>(count); ++i) use(devices[i]);
  if (count >= 0) libusb_free_device_list(devices, 1);
}

}  // namespace

LibusbBus::LibusbBus() {
  if (libusb_init(&context_) != 0) {
    context_ = nullptr;
    return;
  }
  constexpr int kEvents = LIBUSB_HOTPLUG_EVENT_DEVICE_ARRIVED | LIBUSB_HOTPLUG_EVENT_DEVICE_LEFT;
  if (libusb_has_capability(LIBUSB_CAP_HAS_HOTPLUG) == 0) return;
  if (libusb_hotplug_register_callback(context_, kEvents, 0, LIBUSB_HOTPLUG_MATCH_ANY, LIBUSB_HOTPLUG_MATCH_ANY,
                                       LIBUSB_HOTPLUG_MATCH_ANY, onPlug, this, &hotplug_) != 0)
    hotplug_ = -1;
}

LibusbBus::~LibusbBus() {
  if (!context_) return;
  if (hotplug_ >= 0) libusb_hotplug_deregister_callback(context_, hotplug_);
  libusb_exit(context_);
}

std::vector<UsbDeviceInfo> LibusbBus::list() {
  std::vector<UsbDeviceInfo> found;
  if (context_) forEachDevice(context_, [&](libusb_device* device) { found.push_back(infoOf(device)); });
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return std::tie(a.bus, a.port) < std::tie(b.bus, b.port); });
  return found;
}

std::unique_ptr<UsbLink> LibusbBus::open(const UsbDeviceInfo& info, int interfaces, UsbStatus& status) {
  status = UsbStatus::kNotFound;
  if (!context_) return nullptr;
  libusb_device_handle* handle = nullptr;
  forEachDevice(context_, [&](libusb_device* device) {
    if (handle || libusb_get_bus_number(device) != info.bus || libusb_get_device_address(device) != info.address) return;
    status = statusOfLibusb(libusb_open(device, &handle));
  });
  if (!handle) return nullptr;
  libusb_set_auto_detach_kernel_driver(handle, 1);               // the kernel's own serial driver steps aside and comes back
  auto link = std::make_unique<LibusbLink>(context_, handle);
  for (int i = 0; i < interfaces; ++i)
    if ((status = link->claim(i)) != UsbStatus::kOk) return nullptr;
  return link;
}

void LibusbBus::wait(double longest) noexcept {  // [s]
  timeval turn{static_cast<time_t>(longest), static_cast<suseconds_t>((longest - static_cast<double>(static_cast<time_t>(longest))) * 1e6)};
  if (context_ && libusb_handle_events_timeout_completed(context_, &turn, nullptr) == 0) return;
  const timespec pause{0, 1'000'000};          // no USB, or its event loop is broken: do not spin
  nanosleep(&pause, nullptr);
}

double LibusbBus::now() const noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace halsted::haptics
