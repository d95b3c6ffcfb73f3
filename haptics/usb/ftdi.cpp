#include "haptics/usb/ftdi.h"

#include <algorithm>
#include <array>

namespace halsted::haptics {
namespace {

constexpr double kControlTimeout = 0.2;        // [s]

}  // namespace

UsbStatus ftdiSet(UsbLink& link, FtdiRequest request, std::uint16_t value) {
  return link.control({kFtdiRequestType, request, value, 0}, {}, kControlTimeout);
}

UsbStatus ftdiPurge(UsbLink& link) {
  const UsbStatus in = ftdiSet(link, kFtdiReset, kFtdiPurgeIn);
  return in == UsbStatus::kOk ? ftdiSet(link, kFtdiReset, kFtdiPurgeOut) : in;
}

UsbStatus ftdiRead(UsbLink& link, const FtdiIn& in, std::span<std::uint8_t> bytes, std::size_t& got) {
  got = 0;
  int empty = 0;
  std::array<std::uint8_t, kFtdiPacket> packet;
  while (got < bytes.size()) {
    std::size_t length = 0;
    const UsbStatus status = link.read(in.endpoint, packet, length, in.timeout);
    if (status != UsbStatus::kOk) return status;
    if (length <= kFtdiStatusBytes) {
      if (++empty >= in.patience) return UsbStatus::kTimeout;
      continue;
    }
    empty = 0;
    const std::size_t taken = std::min(length - kFtdiStatusBytes, bytes.size() - got);
    std::copy_n(packet.begin() + kFtdiStatusBytes, taken, bytes.begin() + static_cast<std::ptrdiff_t>(got));
    got += taken;
  }
  return UsbStatus::kOk;
}

}  // namespace halsted::haptics
