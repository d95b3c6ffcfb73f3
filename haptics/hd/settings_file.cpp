/// The TOML file of HALSTED_HD_CONFIG.
#include <HD/hdDefines.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "haptics/hd/settings.h"

namespace halsted::haptics::hd {
[[noreturn]] void tomlAssertionFailed(const char* expression) { throw std::logic_error(expression); }
}  // namespace halsted::haptics::hd

// toml++ 3.3 asserts on some bad input (a table header "[!"). Whatever the build type, that must be a refusal, not the end.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) ((expression) ? static_cast<void>(0) : ::halsted::haptics::hd::tomlAssertionFailed(#expression))
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace halsted::haptics::hd {

namespace {

constexpr std::size_t kLargestFile = 1 << 20;  // bytes

/// What a file says may hold anything; a message is one line of it.
std::string oneLine(std::string text) {
  for (char& letter : text)
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) letter = ' ';
  return text.substr(0, 300);
}

/// What toml++ 3.3 must not see: it reaches code that it declares unreachable on many letters outside ASCII. Lines that are comments lose
/// their text; elsewhere such a letter is refused.
std::string plainText(std::string_view text, const std::string& path) {
  std::string plain;
  int line = 1;
  bool comment = false, blank = true;            // of this line so far
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    const bool white = letter == ' ' || letter == '\t' || letter == '\r';
    if (blank && letter == '#') comment = true;
    blank = letter == '\n' || (blank && white);
    if (letter == '\n') {
      ++line;
      comment = false;
    } else if (comment) {
      continue;
    } else if (code >= 0x7f || (code < 0x20 && !white)) {
      throw SettingsError(path + ":" + std::to_string(line) + ": a letter outside ASCII");
    }
    plain.push_back(letter);
  }
  return plain;
}

struct Reader {
  std::string path;

  [[noreturn]] void fail(const toml::node& node, const std::string& what) const {
    throw SettingsError(path + ":" + std::to_string(node.source().begin.line) + ": " + oneLine(what));
  }

  template <class T> T value(const toml::node& node, const char* key, const char* kind) const {
    const auto found = node.value_exact<T>();
    if (!found) fail(node, std::string(key) + ": must be " + kind);
    return *found;
  }

  std::string text(const toml::node& node, const char* key) const { return value<std::string>(node, key, "text"); }
};

constexpr std::array<std::pair<const char*, unsigned>, 3> kStyles{
    {{"encoder-reset", HD_CALIBRATION_ENCODER_RESET}, {"auto", HD_CALIBRATION_AUTO}, {"inkwell", HD_CALIBRATION_INKWELL}}};

unsigned styleOf(const Reader& reader, const toml::node& node) {
  const std::string name = reader.text(node, "calibration");
  for (const auto& [known, style] : kStyles)
    if (name == known) return style;
  reader.fail(node, "calibration: 'encoder-reset', 'auto' or 'inkwell'");
}

unsigned stylesOf(const Reader& reader, const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list) return styleOf(reader, node);
  unsigned mask = 0;
  for (const toml::node& item : *list) mask |= styleOf(reader, item);
  if (mask == 0) reader.fail(node, "calibration: at least one style");
  return mask;
}

Vec3 startOf(const Reader& reader, const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list || list->size() != 3) reader.fail(node, "start_mm: three numbers");
  Vec3 start;
  for (int axis = 0; axis < 3; ++axis) {
    const auto millimetres = list->get(axis)->value<double>();
    if (!millimetres || !(std::abs(*millimetres) <= 250.0)) reader.fail(node, "start_mm: three numbers from -250 to 250");
    start[axis] = *millimetres * 1e-3;
  }
  return start;
}

HandKind handOf(const Reader& reader, const toml::node& node) {
  const std::string name = reader.text(node, "hand");
  if (name == "firm") return HandKind::kFirm;
  if (name == "light") return HandKind::kLight;
  if (name == "none") return HandKind::kNone;
  reader.fail(node, "hand: 'firm', 'light' or 'none'");
}

/// An absolute path is the user's word; any other stays inside the folder of this file.
std::string motionOf(const Reader& reader, const toml::node& node) {
  const std::filesystem::path file = reader.text(node, "motion");
  if (file.is_absolute()) return file.string();
  for (const std::filesystem::path& part : file)
    if (part == "..") reader.fail(node, "motion: a file beside this one, or an absolute path");
  return (std::filesystem::path(reader.path).parent_path() / file).string();
}

void readKey(const Reader& reader, std::string_view key, const toml::node& node, DeviceSettings& device) {
  if (key == "name") device.name = reader.text(node, "name");
  else if (key == "serial") device.serial = reader.text(node, "serial");
  else if (key == "model") device.model = reader.text(node, "model");
  else if (key == "motion") device.motion = motionOf(reader, node);
  else if (key == "loop") device.loop = reader.value<bool>(node, "loop", "true or false");
  else if (key == "calibrated") device.calibrated = reader.value<bool>(node, "calibrated", "true or false");
  else if (key == "calibration") device.calibrationStyle = stylesOf(reader, node);
  else if (key == "hand") device.hand = handOf(reader, node);
  else if (key == "start_mm") device.start = startOf(reader, node);
  else if (key == "aliases") {
    const toml::array* list = node.as_array();
    if (!list) reader.fail(node, "aliases: a list of names");
    for (const toml::node& item : *list) device.aliases.push_back(reader.text(item, "aliases"));
  } else reader.fail(node, "unknown key '" + std::string(key) + "'");
}

DeviceSettings readDevice(const Reader& reader, const toml::node& node, std::size_t index) {
  const toml::table* table = node.as_table();
  if (!table) reader.fail(node, "device: a table");
  DeviceSettings device;
  device.serial = "HALSTED-VIRTUAL-" + std::to_string(index + 1);
  device.calibrationStyle = HD_CALIBRATION_ENCODER_RESET | HD_CALIBRATION_INKWELL;
  for (const auto& [key, value] : *table) readKey(reader, key.str(), value, device);
  if (device.name.empty()) reader.fail(node, "device: no name");
  if (index == 0) device.aliases.insert(device.aliases.end(), {"Default Device", "Default PHANToM"});
  return device;
}

}  // namespace

Settings readSettingsText(std::string_view text, const std::string& path) {
  const Reader reader{path};
  toml::table file;
  try {
    file = toml::parse(plainText(text, path), path);
  } catch (const toml::parse_error& error) {
    throw SettingsError(path + ":" + std::to_string(error.source().begin.line) + ": " + oneLine(std::string(error.description())));
  } catch (const std::logic_error&) {
    throw SettingsError(path + ": is not TOML");
  }
  Settings settings;
  const toml::array* devices = file["device"].as_array();
  if (!devices || devices->empty()) throw SettingsError(path + ": no [[device]]");
  for (const toml::node& node : *devices) settings.devices.push_back(readDevice(reader, node, settings.devices.size()));
  return settings;
}

Settings readSettingsFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  for (std::istreambuf_iterator<char> at(in), end; at != end && text.size() <= kLargestFile; ++at) text.push_back(*at);
  if (!in.is_open()) throw SettingsError(path + ": cannot be read");
  if (text.size() > kLargestFile) throw SettingsError(path + ": larger than 1 MiB");
  return readSettingsText(text, path);
}

}  // namespace halsted::haptics::hd
