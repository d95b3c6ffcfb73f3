#pragma once
/// Which virtual devices there are: built in, from a TOML file, from the environment. Read at every hdInitDevice, on the caller's thread.
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sim/types.h"

namespace halsted::haptics::hd {

enum class HandKind { kFirm, kLight, kNone };

struct DeviceSettings {
  std::string name;
  std::vector<std::string> aliases;
  std::string serial;
  std::string model = "Touch";
  std::string motion;                          // path of a motion file; empty: the hand holds still
  bool loop = false;                           // the motion starts again at its end
  HandKind hand = HandKind::kFirm;
  Vec3 start = Vec3::Zero();                   // [m] where the hand holds the stylus when there is no motion
  unsigned calibrationStyle = 0;               // mask of HD_CALIBRATION_*
  bool calibrated = true;                      // false: as after power-on, hdUpdateCalibration has work to do
};

struct Settings {
  std::vector<DeviceSettings> devices;         // the first is the default device
};

/// One line: file or variable, and what is wrong with it.
class SettingsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// HALSTED_HD_CONFIG, HALSTED_HD_DEVICES, HALSTED_HD_MOTION as in README.md. Throws SettingsError.
Settings readSettings();
/// The [[device]] tables of a TOML file. Throws SettingsError.
Settings readSettingsFile(const std::string& path);
/// The same from its text; `path` is for the messages, and motion files are beside it.
Settings readSettingsText(std::string_view text, const std::string& path);

/// Letter case does not matter: programs spell the default device's name in several ways. Null: the default device.
const DeviceSettings* findDevice(const Settings&, const char* name);

}  // namespace halsted::haptics::hd
