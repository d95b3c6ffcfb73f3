/// Any bytes as what a host sends: the reference firmware stays within its memory, its peak force and its watchdog.
#include <cstdint>
#include <cstdlib>

#include "haptics/open_device/firmware/open_device.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  HodIdentity identity{};
  identity.peakForce = 4000;
  HodDevice device;
  hodBegin(&device, &identity);
  HodSample sample{};
  std::uint32_t now = 0;                       // us
  while (size > 0) {
    std::size_t length = data[0] % 70;
    if (length > size - 1) length = size - 1;
    std::uint8_t piece[70] = {};
    for (std::size_t i = 0; i < length; ++i) piece[i] = data[1 + i];
    if ((data[0] & 0x80) && length >= 8) {     // half of them with a true frame round them
      piece[0] = kHodSync0;
      piece[1] = kHodSync1;
      piece[2] = piece[2] & 1 ? kHodVersion : piece[2];
      piece[5] = static_cast<std::uint8_t>(length - 8 > kHodMaxPayload ? kHodMaxPayload : length - 8);
      const std::size_t end = static_cast<std::size_t>(kHodHeader) + piece[5];
      const std::uint16_t check = hodChecksum(piece + 2, end - 2);
      piece[end] = static_cast<std::uint8_t>(check & 0xff);
      piece[end + 1] = static_cast<std::uint8_t>(check >> 8);
    }
    hodReceive(&device, piece, length, now);
    data += 1 + length;
    size -= 1 + length;
    now += 500u * (1u + (size & 31u));
    sample.status = size & 2 ? kHodHomed : 0;
    std::uint8_t packet[kHodMaxFrame];
    if (hodState(&device, &sample, now, packet) > kHodMaxFrame) std::abort();
    std::int16_t force[3];
    const int allowed = hodForce(&device, now, force);
    for (const std::int16_t axis : force)
      if (axis > 4000 || axis < -4000 || (axis != 0 && (!allowed || !(sample.status & kHodHomed)))) std::abort();
    if (now - device.lastCommand > kHodWatchdogMicroseconds && (force[0] || force[1] || force[2])) std::abort();
  }
  return 0;
}
