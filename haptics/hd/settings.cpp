#include "haptics/hd/settings.h"

#include <HD/hdDefines.h>
#include <strings.h>

#include <cstdlib>
#include <string_view>

namespace halsted::haptics::hd {

namespace {

DeviceSettings named(std::string name, std::vector<std::string> aliases, std::size_t index) {
  DeviceSettings device;
  device.name = std::move(name);
  device.aliases = std::move(aliases);
  device.serial = "HALSTED-VIRTUAL-" + std::to_string(index + 1);
  device.calibrationStyle = HD_CALIBRATION_ENCODER_RESET | HD_CALIBRATION_INKWELL;
  return device;
}

/// What a program finds on a machine where nobody configured anything.
Settings builtIn() {
  Settings settings;
  settings.devices = {named("Default Device", {"Default PHANToM"}, 0), named("left", {"Left Device", "phantom1"}, 1),
                      named("right", {"Right Device", "phantom2"}, 2)};
  return settings;
}

const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : nullptr;
}

std::vector<std::string> listed(std::string_view text, char separator) {
  std::vector<std::string> items;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(separator, at), text.size());
    std::string_view item = text.substr(at, end - at);
    while (!item.empty() && item.front() == ' ') item.remove_prefix(1);
    while (!item.empty() && item.back() == ' ') item.remove_suffix(1);
    if (!item.empty()) items.emplace_back(item);
    at = end + 1;
  }
  return items;
}

/// HALSTED_HD_DEVICES="left,right": these names, and the first is the default device too.
Settings fromNames(const char* text) {
  Settings settings;
  for (const std::string& name : listed(text, ',')) {
    const std::size_t index = settings.devices.size();
    std::vector<std::string> aliases;
    if (index == 0) aliases = {"Default Device", "Default PHANToM"};
    settings.devices.push_back(named(name, aliases, index));
  }
  if (settings.devices.empty()) throw SettingsError("HALSTED_HD_DEVICES: no name in it");
  return settings;
}

/// HALSTED_HD_MOTION="hand.csv" for the default device, or "left=a.csv;right=b.csv".
void applyMotion(const char* text, Settings& settings) {
  for (const std::string& item : listed(text, ';')) {
    const std::size_t equals = item.find('=');
    const std::string name = equals == std::string::npos ? settings.devices.front().name : item.substr(0, equals);
    const DeviceSettings* device = findDevice(settings, name.c_str());
    if (!device) throw SettingsError("HALSTED_HD_MOTION: no device '" + name + "'");
    settings.devices[device - settings.devices.data()].motion = equals == std::string::npos ? item : item.substr(equals + 1);
  }
}

}  // namespace

const DeviceSettings* findDevice(const Settings& settings, const char* name) {
  if (settings.devices.empty()) return nullptr;
  if (!name) return &settings.devices.front();
  const auto same = [name](const std::string& known) { return strcasecmp(known.c_str(), name) == 0; };
  for (const DeviceSettings& device : settings.devices) {
    if (same(device.name)) return &device;
    for (const std::string& alias : device.aliases)
      if (same(alias)) return &device;
  }
  return nullptr;
}

Settings readSettings() {
  const char* file = variable("HALSTED_HD_CONFIG");
  const char* names = variable("HALSTED_HD_DEVICES");
  Settings settings = file ? readSettingsFile(file) : names ? fromNames(names) : builtIn();
  if (const char* motion = variable("HALSTED_HD_MOTION")) applyMotion(motion, settings);
  if (const char* loop = variable("HALSTED_HD_MOTION_LOOP"))
    for (DeviceSettings& device : settings.devices) device.loop = std::string_view(loop) != "0";
  return settings;
}

}  // namespace halsted::haptics::hd
