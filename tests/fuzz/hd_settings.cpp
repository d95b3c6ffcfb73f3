/// Any bytes as the file of devices: refused in one line, or devices that can be told apart from nothing.
#include <cstdint>

#include "haptics/hd/settings.h"
#include "tests/fuzz/accepted.h"

using namespace halsted;
using namespace halsted::haptics::hd;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Settings settings;
  try {
    settings = readSettingsText(text, "/folder/hd.toml");
  } catch (const SettingsError& refusal) {
    const std::string line = refusal.what();
    fuzz::require(line.starts_with("/folder/hd.toml:") && line.find('\n') == std::string::npos && line.size() < 400);
    return 0;
  }
  fuzz::require(!settings.devices.empty() && findDevice(settings, nullptr) == settings.devices.data());
  for (const DeviceSettings& device : settings.devices) {
    fuzz::require(!device.name.empty() && device.calibrationStyle >= 1 && device.calibrationStyle <= 7);
    fuzz::require(device.start.allFinite() && device.start.cwiseAbs().maxCoeff() <= 0.25);
    fuzz::require(device.motion.empty() || device.motion.front() == '/');
    fuzz::require(findDevice(settings, device.name.c_str()) != nullptr || device.name.find('\0') != std::string::npos);
  }
  return 0;
}
