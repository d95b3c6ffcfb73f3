#include "tests/usb/usb_emulation.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>

namespace halsted::testing {
namespace {

using haptics::UsbControl;
using haptics::UsbStatus;

constexpr useconds_t kNothingYet = 100;        // us that an empty reap takes: libusb asks again at once, since the fake file is always ready

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::string hexadecimal(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    char pair[3];
    std::snprintf(pair, sizeof pair, "%02x", byte);
    text += pair;
  }
  return text;
}

usbdevfs_urb& urbOf(UMockdevIoctlData* data) { return *reinterpret_cast<usbdevfs_urb*>(data->data); }

int errnoOf(UsbStatus status) {
  switch (status) {
    case UsbStatus::kOk: return 0;
    case UsbStatus::kStalled: return -EPIPE;
    case UsbStatus::kGone: return -ESHUTDOWN;
    case UsbStatus::kOverflow: return -EOVERFLOW;
    default: return -EPROTO;
  }
}

}  // namespace

UsbEmulation::UsbEmulation() : testbed_(umockdev_testbed_new()) {
  umockdev_testbed_add_from_string(testbed_,
                                   "P: /devices/usb1\nN: bus/usb/001/001\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DEVNAME=/dev/bus/usb/001/001\n"
                                   "E: BUSNUM=001\nE: DEVNUM=001\nE: MAJOR=189\nE: MINOR=0\nA: busnum=1\\n\nA: devnum=1\\n\nA: speed=480\\n\n"
                                   "A: bConfigurationValue=1\\n\n"
                                   "H: descriptors=12010002090001406b1d020000020302010109021900010100e0000904000001090000000705810304000c\n",
                                   nullptr);
}

UsbEmulation::~UsbEmulation() {
  for (auto& port : ports_)
    if (port->attached) umockdev_testbed_detach_ioctl(testbed_, port->node.c_str(), nullptr);
  g_clear_object(&testbed_);
  for (auto& port : ports_) g_clear_object(&port->handler);
}

bool UsbEmulation::available() {
  const char* preload = getenv("LD_PRELOAD");
  return preload && std::strstr(preload, "umockdev");
}

int UsbEmulation::plug(haptics::UsbModel& model) {
  const int number = static_cast<int>(ports_.size()) + 1;
  auto port = std::make_unique<Port>();
  port->owner = this;
  port->model = &model;
  port->number = number;
  port->handler = umockdev_ioctl_base_new();
  g_signal_connect(port->handler, "handle-ioctl", G_CALLBACK(onIoctl), port.get());
  ports_.push_back(std::move(port));
  replug(number - 1);
  return number - 1;
}

void UsbEmulation::addDevice(Port& port) {
  char node[40];
  std::snprintf(node, sizeof node, "/dev/bus/usb/001/%03d", nextAddress_);
  port.node = node;
  port.sysfs = "/sys/devices/usb1/1-" + std::to_string(port.number);
  const haptics::UsbDeviceInfo info = port.model->info();
  const std::string number = std::to_string(nextAddress_), padded = node + std::string("/dev/bus/usb/001/").size();
  const std::string text = "P: /devices/usb1/1-" + std::to_string(port.number) + "\nN: " + (node + 5) +
                           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DEVNAME=" + node + "\nE: BUSNUM=001\nE: DEVNUM=" + padded +
                           "\nE: MAJOR=189\nE: MINOR=" + std::to_string(nextAddress_ - 1) + "\nA: busnum=1\\n\nA: devnum=" + number +
                           "\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\nA: product=" + info.productName + "\\n\n" +
                           (info.serial.empty() ? "" : "A: serial=" + info.serial + "\\n\n") +
                           "H: descriptors=" + hexadecimal(port.model->descriptors()) + "\n";
  g_autoptr(GError) error = nullptr;
  if (!umockdev_testbed_attach_ioctl(testbed_, node, port.handler, &error)) g_error("attach: %s", error->message);
  if (!umockdev_testbed_add_from_string(testbed_, text.c_str(), &error)) g_error("add: %s", error->message);
  ++nextAddress_;
}

void UsbEmulation::unplug(int port) {
  Port& gone = *ports_[static_cast<std::size_t>(port)];
  {
    const std::lock_guard guard(lock_);
    gone.attached = false;
    gone.model->detach();
  }
  umockdev_testbed_uevent(testbed_, gone.sysfs.c_str(), "remove");
  umockdev_testbed_remove_device(testbed_, gone.sysfs.c_str());
}

void UsbEmulation::replug(int port, haptics::UsbModel& other) {
  {
    const std::lock_guard guard(lock_);
    ports_[static_cast<std::size_t>(port)]->model = &other;
  }
  replug(port);
}

void UsbEmulation::replug(int port) {
  Port& back = *ports_[static_cast<std::size_t>(port)];
  {
    const std::lock_guard guard(lock_);
    back.model->attach();
    back.attached = true;
    back.lastTime = seconds();
  }
  addDevice(back);
}

gboolean UsbEmulation::onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data) {
  Port& port = *static_cast<Port*>(data);
  {
    const std::lock_guard guard(port.owner->lock_);
    port.owner->advance(port);
    port.owner->handle(port, client);
  }
  return TRUE;
}

void UsbEmulation::advance(Port& port) {
  constexpr double kSlice = 100e-6, kLongest = 50e-3;            // [s]
  const double now = seconds();
  double span = std::min(now - port.lastTime, kLongest);         // [s]
  port.lastTime = now;
  port.faults.silentFor = std::max(0.0, port.faults.silentFor - span);
  for (; span > 0.0; span -= kSlice) port.model->advance(std::min(span, kSlice));
}

void UsbEmulation::handle(Port& port, UMockdevIoctlClient* client) {
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  switch (umockdev_ioctl_client_get_request(client)) {
    case USBDEVFS_GET_CAPABILITIES: {
      g_autoptr(UMockdevIoctlData) bits = umockdev_ioctl_data_resolve(argument, 0, sizeof(guint32), nullptr);
      *reinterpret_cast<guint32*>(bits->data) = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
      return umockdev_ioctl_client_complete(client, 0, 0);
    }
    case USBDEVFS_SUBMITURB: return submit(port, client, argument);
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY: return reap(port, client, argument);
    case USBDEVFS_DISCARDURB: return discard(port, client, argument);
    case USBDEVFS_CLAIMINTERFACE:
    case USBDEVFS_DISCONNECT_CLAIM:
      return port.faults.refuseOpen == UsbStatus::kBusy ? umockdev_ioctl_client_complete(client, -1, EBUSY) : umockdev_ioctl_client_complete(client, 0, 0);
    case USBDEVFS_RELEASEINTERFACE:
    case USBDEVFS_CLEAR_HALT:
    case USBDEVFS_RESETEP:
    case USBDEVFS_RESET: return umockdev_ioctl_client_complete(client, 0, 0);
    default: return umockdev_ioctl_client_complete(client, -1, ENODATA);   // no kernel driver is bound
  }
}

void UsbEmulation::submit(Port& port, UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  if (!port.attached) return umockdev_ioctl_client_complete(client, -1, ENODEV);
  UMockdevIoctlData* urb = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
  UMockdevIoctlData* buffer =
      umockdev_ioctl_data_resolve(urb, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(urbOf(urb).buffer_length), nullptr);
  port.flying.push_back({urb, buffer});
  umockdev_ioctl_client_complete(client, 0, 0);
}

/// Lets the model take or give the bytes of one request; false: it has nothing yet.
bool UsbEmulation::answer(Port& port, const Urb& flying, int& status) {
  usbdevfs_urb& urb = urbOf(flying.urb);
  std::uint8_t* bytes = flying.buffer->data;
  const auto length = static_cast<std::size_t>(urb.buffer_length);
  status = -ESHUTDOWN;
  if (!port.attached) return true;
  if (port.faults.silentFor > 0.0) return false;
  status = 0;
  urb.actual_length = urb.buffer_length;
  if (urb.type == USBDEVFS_URB_TYPE_CONTROL) {
    const UsbControl request{bytes[0], bytes[1], static_cast<std::uint16_t>(bytes[2] | bytes[3] << 8), static_cast<std::uint16_t>(bytes[4] | bytes[5] << 8)};
    status = errnoOf(port.model->control(request, {bytes + 8, length - 8}));
    urb.actual_length = static_cast<int>(length) - 8;
    return true;
  }
  if (!(urb.endpoint & 0x80)) {
    port.model->out(urb.endpoint, {bytes, length});
    return true;
  }
  const std::size_t got = port.model->in(urb.endpoint, {bytes, length});
  if (got == 0) return false;
  urb.actual_length = static_cast<int>(got);
  haptics::UsbFaults& faults = port.faults;
  if (faults.failedTransfers > 0) {
    --faults.failedTransfers;
    status = errnoOf(faults.failure);
  } else if (got > 2 && faults.shortPackets > 0) {
    --faults.shortPackets;
    urb.actual_length /= 2;
  } else if (got > 2 && faults.corruptPackets > 0) {
    --faults.corruptPackets;
    bytes[2 + faults.where++ % (got - 2)] ^= 0x10;
  }
  return true;
}

void UsbEmulation::reap(Port& port, UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  if (!port.discarded.empty()) {
    const Urb urb = port.discarded.front();
    port.discarded.pop_front();
    return finish(client, argument, urb, -ENOENT);
  }
  bool waitingIn = false;                      // the first IN request is served first
  for (std::size_t i = 0; i < port.flying.size(); ++i) {
    const Urb urb = port.flying[i];
    const bool incoming = urbOf(urb.urb).type == USBDEVFS_URB_TYPE_BULK && (urbOf(urb.urb).endpoint & 0x80);
    int status = 0;
    if ((incoming && waitingIn) || !answer(port, urb, status)) {
      waitingIn = waitingIn || incoming;
      continue;
    }
    port.flying.erase(port.flying.begin() + static_cast<std::ptrdiff_t>(i));
    return finish(client, argument, urb, status);
  }
  usleep(kNothingYet);
  umockdev_ioctl_client_complete(client, -1, EAGAIN);
}

void UsbEmulation::finish(UMockdevIoctlClient* client, UMockdevIoctlData* argument, Urb urb, int status) {
  urbOf(urb.urb).status = status;
  g_autoptr(UMockdevIoctlData) pointer = umockdev_ioctl_data_resolve(argument, 0, sizeof(gpointer), nullptr);
  umockdev_ioctl_data_set_ptr(pointer, 0, urb.urb);
  umockdev_ioctl_client_complete(client, 0, 0);
  umockdev_ioctl_data_unref(urb.buffer);
  umockdev_ioctl_data_unref(urb.urb);
}

void UsbEmulation::discard(Port& port, UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  const gulong wanted = *reinterpret_cast<gulong*>(argument->data);
  for (std::size_t i = 0; i < port.flying.size(); ++i) {
    if (port.flying[i].urb->client_addr != wanted) continue;
    port.discarded.push_back(port.flying[i]);
    port.flying.erase(port.flying.begin() + static_cast<std::ptrdiff_t>(i));
    return umockdev_ioctl_client_complete(client, 0, 0);
  }
  umockdev_ioctl_client_complete(client, -1, EINVAL);
}

}  // namespace halsted::testing
