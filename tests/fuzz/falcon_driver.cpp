/// Any bytes as what a Falcon's chip sends: dropped or read as a finite position that a grip can have, never a crash; and whatever was
/// read, the command that follows stays within the motors' limit.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "haptics/falcon/falcon_protocol.h"

using namespace halsted;
using namespace halsted::haptics;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FalconProtocol driver({});
  UsbMeasurement measurement;
  // The first byte of each piece says how long it is, so that frames are cut anywhere.
  while (size > 0) {
    const std::size_t length = std::min<std::size_t>(data[0] % 130, size - 1);
    const PacketOutcome outcome = driver.received({data + 1, length}, measurement);
    data += 1 + length;
    size -= 1 + length;
    const Vec3& at = measurement.pose.position;
    if (outcome.reading && !(at.norm() < 0.5)) std::abort();
    std::uint8_t packet[64];
    const std::size_t used = driver.command(Vec3(3.0, -8.0, 1e6), true, packet);
    const auto command = decodeFalconCommand({packet, used});
    if (!command) std::abort();
    for (const int motor : command->motors)
      if (std::abs(motor) > kFalconMotorLimit) std::abort();
  }
  return 0;
}
