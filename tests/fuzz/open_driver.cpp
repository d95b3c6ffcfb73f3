/// Any bytes as what an open device sends: the host's reader and its blocking bring-up.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "haptics/open_device/open_protocol.h"

using namespace halsted;
using namespace halsted::haptics;

namespace {

/// A cable on which the fuzzer's bytes arrive, packet by packet.
class FuzzLink final : public UsbLink {
 public:
  explicit FuzzLink(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  UsbStatus control(const UsbControl&, std::span<std::uint8_t>, double) override { return UsbStatus::kOk; }
  UsbStatus write(std::uint8_t, std::span<const std::uint8_t>, double) override { return UsbStatus::kOk; }
  UsbStatus read(std::uint8_t, std::span<std::uint8_t> into, std::size_t& got, double) override {
    if (bytes_.empty()) return UsbStatus::kTimeout;
    got = std::min({into.size(), bytes_.size() - 1, static_cast<std::size_t>(bytes_[0])});
    std::copy_n(bytes_.begin() + 1, got, into.begin());
    bytes_ = bytes_.subspan(got + 1);
    return UsbStatus::kOk;
  }
  UsbStatus startStream(std::uint8_t, std::uint8_t, UsbStreamOwner&) override { return UsbStatus::kOk; }
  bool send(std::span<const std::uint8_t>) noexcept override { return true; }
  void clearHalt(std::uint8_t) noexcept override {}
  void stopStream() noexcept override {}

 private:
  std::span<const std::uint8_t> bytes_;
};

/// Half of the inputs get a true checksum, so that the readers behind it are reached.
void sealWhole(std::span<std::uint8_t> frame) {
  if (frame.size() < kOpenHeader + kOpenCheck) return;
  frame[0] = 0xc3;
  frame[1] = 0x5a;
  frame[5] = static_cast<std::uint8_t>(std::min<std::size_t>(frame.size() - kOpenHeader - kOpenCheck, kOpenMaxPayload));
  const std::size_t end = kOpenHeader + frame[5];
  const std::uint16_t check = openChecksum(frame.subspan(2, end - 2));
  frame[end] = static_cast<std::uint8_t>(check & 0xff);
  frame[end + 1] = static_cast<std::uint8_t>(check >> 8);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  std::vector<std::uint8_t> bytes(data + 1, data + size);
  if (data[0] & 1) sealWhole(bytes);
  OpenProtocol driver;
  FuzzLink link(bytes);
  driver.bringUp(link);
  const DeviceLimits limits = driver.limits();
  if (!(limits.continuousForce <= limits.peakForce && limits.peakForce < 66.0)) std::abort();
  UsbMeasurement measurement;
  for (std::size_t at = 0; at < bytes.size(); at += 1 + data[0] % 64) {
    const std::span<const std::uint8_t> rest(bytes.data() + at, std::min<std::size_t>(1 + data[0] % 64, bytes.size() - at));
    if (!driver.received(rest, measurement).reading) continue;
    const double length = measurement.pose.orientation.squaredNorm();  // [1]
    if (!(length > 0.99 && length < 1.01) || !measurement.pose.position.allFinite()) std::abort();
    if (!(measurement.jaw >= 0.0 && measurement.jaw <= 1.0)) std::abort();
  }
  return 0;
}
