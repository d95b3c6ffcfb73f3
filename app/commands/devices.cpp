/// `halsted devices`: what is attached, what can drive it, and in one line each what keeps it from working and what to do.
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/commands/devices_bench.h"
#include "app/errors.h"
#include "app/force_check.h"
#include "app/hands.h"
#include "haptics/limits.h"
#include "haptics/touch/touch_identity.h"
#include "haptics/usb/known_devices.h"
#include "haptics/usb/libusb_bus.h"
#include "haptics/vendor/hd_library.h"
#include "scenes/scene.h"

namespace halsted::app {
namespace {

using haptics::DeviceProblem;
using haptics::DeviceStage;
using haptics::Drive;
using nlohmann::ordered_json;

constexpr double kLook = 3.0;                  // [s] for one device to say how it is
constexpr double kHomingPatience = 60.0;       // [s] for the user of --test

std::string idText(const haptics::UsbDeviceInfo& usb) {
  char text[16];
  std::snprintf(text, sizeof text, "%04x:%04x", usb.vendor, usb.product);
  return text;
}

/// What keeps a device from working that its user's hand or a firmware file would not mend: exit code 3.
bool isFault(DeviceProblem problem) {
  switch (problem) {
    case DeviceProblem::kUnplugged:
    case DeviceProblem::kNoPermission:
    case DeviceProblem::kBusy:
    case DeviceProblem::kNotAnswering:
    case DeviceProblem::kFirmwareRefused:
    case DeviceProblem::kTransferFailed:
    case DeviceProblem::kMemoryShort: return true;
    default: return false;
  }
}

void explain(ordered_json& row, DeviceProblem problem) {
  row["fault"] = isFault(problem);
  row["problem"] = problem == DeviceProblem::kNone ? "" : haptics::problemText(problem);
  row["remedy"] = haptics::remedyText(problem);
}

/// Brings it up as a session would, without any force, and lets it go again.
void lookAtDriven(const haptics::UsbDeviceInfo& usb, const HardwareChoice& choice, ordered_json& row) {
  auto bus = std::make_shared<haptics::LibusbBus>();
  haptics::UsbDevice device(bus, usbProtocol(choice), {usb.serial, usb.serial.empty() ? usb.port : ""});
  const haptics::DeviceStatus status = bringUp(device, *bus, kLook);
  row["state"] = haptics::name(status.stage);
  row["ready"] = status.stage == DeviceStage::kReady;
  explain(row, status.problem);
}

DeviceProblem problemOfOpening(haptics::UsbStatus status) {
  switch (status) {
    case haptics::UsbStatus::kNoPermission: return DeviceProblem::kNoPermission;
    case haptics::UsbStatus::kBusy: return DeviceProblem::kBusy;
    case haptics::UsbStatus::kGone:
    case haptics::UsbStatus::kNotFound: return DeviceProblem::kUnplugged;
    default: return DeviceProblem::kNotAnswering;
  }
}

/// A Touch: asked for firmware and serial number over its public frames; nothing more is public.
void lookAtTouch(const haptics::UsbDeviceInfo& usb, ordered_json& row) {
  haptics::LibusbBus bus;
  haptics::UsbStatus status = haptics::UsbStatus::kOk;
  const auto link = bus.open(usb, haptics::kTouchInterfaces, status);
  haptics::TouchIdentity identity;
  if (link) status = haptics::identifyTouch(*link, identity);
  row["state"] = status == haptics::UsbStatus::kOk ? "identified" : "listed";
  row["firmware"] = identity.firmware;
  if (!identity.serial.empty()) row["serial"] = identity.serial;
  explain(row, DeviceProblem::kServoNotPublic);
  if (status == haptics::UsbStatus::kOk) return;
  const DeviceProblem problem = problemOfOpening(status);
  row["note"] = std::string(haptics::problemText(problem)) + "; " + haptics::remedyText(problem);
  row["fault"] = isFault(problem);
}

ordered_json rowOf(const haptics::UsbDeviceInfo& usb, const haptics::KnownDevice& known, const std::string& firmware) {
  ordered_json row{{"title", known.title}, {"id", idText(usb)}, {"port", usb.port}, {"serial", usb.serial}, {"driver", known.driver},
                   {"drivable", known.drive == Drive::kDriven}, {"ready", false}, {"state", "listed"}};
  if (known.drive == Drive::kDriven) lookAtDriven(usb, {std::string(known.driver), "", firmware}, row);
  else if (known.drive == Drive::kIdentified) lookAtTouch(usb, row);
  else explain(row, DeviceProblem::kServoNotPublic);
  return row;
}

ordered_json vendorRow() {
  haptics::HdLoad loaded = haptics::HdLoad::kLoaded;
  const auto library = haptics::HdLibrary::load(loaded);
  ordered_json row{{"found", library != nullptr}, {"path", library ? library->path() : ""}};
  explain(row, library ? DeviceProblem::kNone
                       : loaded == haptics::HdLoad::kMissing ? DeviceProblem::kVendorLibraryMissing : DeviceProblem::kVendorLibraryUnusable);
  return row;
}

ordered_json survey(const std::string& firmware) {
  ordered_json attached = ordered_json::array();
  haptics::LibusbBus bus;
  for (const haptics::UsbDeviceInfo& usb : bus.list())
    if (const haptics::KnownDevice* known = haptics::knownDevice(usb)) attached.push_back(rowOf(usb, *known, firmware));
  return {{"usb", bus.available()}, {"attached", attached}, {"vendor_library", vendorRow()}};
}

void printRow(const ordered_json& row) {
  const auto text = [&](const char* key) { return row.value(key, std::string()); };
  std::printf("%s  %s  port %s%s%s%s%s\n", text("title").c_str(), text("id").c_str(), text("port").c_str(),
              text("serial").empty() ? "" : "  serial ", text("serial").c_str(), text("firmware").empty() ? "" : "  firmware ", text("firmware").c_str());
  if (row["ready"]) std::printf("  ready: --left %s\n", text("driver").c_str());
  else std::printf("  %s: %s\n", text("problem").c_str(), text("remedy").c_str());
  if (row.contains("note")) std::printf("  not asked for its identity, %s\n", text("note").c_str());
}

void print(const ordered_json& found) {
  if (!found["usb"]) std::printf("%s: %s\n", haptics::problemText(DeviceProblem::kNoUsb), haptics::remedyText(DeviceProblem::kNoUsb));
  else if (found["attached"].empty()) std::printf("No haptic device is attached: %s.\n", haptics::remedyText(DeviceProblem::kNotAttached));
  for (const ordered_json& row : found["attached"]) printRow(row);
  const ordered_json& vendor = found["vendor_library"];
  if (vendor["found"]) std::printf("Vendor library %s: --left vendor\n", vendor["path"].get<std::string>().c_str());
  else std::printf("%s: %s\n", vendor["problem"].get<std::string>().c_str(), vendor["remedy"].get<std::string>().c_str());
  std::printf("Always there: virtual, mouse, script:FILE\n");
}

ordered_json jsonOf(const std::string& device, const ForceCheck& check) {
  ordered_json pushes = ordered_json::array();
  for (const Push& push : check.pushes)
    pushes.push_back({{"axis", push.axis}, {"force_n", push.force.norm()}, {"moved_mm", {push.moved.x() * 1e3, push.moved.y() * 1e3, push.moved.z() * 1e3}},
                      {"right", push.right}});
  std::string faults;
  for (std::uint32_t bit = 1; bit <= haptics::kFaultCutMask; bit <<= 1)
    if (check.faults & bit) faults += (faults.empty() ? "" : ", ") + std::string(haptics::faultName(static_cast<haptics::FaultCode>(bit)));
  ordered_json json{{"device", device}, {"passed", check.passed}, {"ready", check.ready}, {"state", haptics::name(check.status.stage)}};
  explain(json, check.status.problem);
  json.update({{"faults", faults}, {"tick_rate_hz", check.seconds > 0.0 ? static_cast<double>(check.ticks) / check.seconds : 0.0},
               {"interruptions", check.interruptions}, {"rest_noise_mm", check.restNoise * 1e3}, {"largest_force_n", check.largestForce}, {"largest_speed_mm_s", check.largestSpeed * 1e3},
               {"pushes", pushes}});
  return json;
}

int test(const DevicesOptions& options) {
  DeviceChoice choice = parseDevice("--test", options.test);
  choice.hardware.firmware = options.firmware;
  if (choice.mover != Mover::kNobody) throw scenes::InputError("--test " + options.test + ": a device that pushes back: virtual, falcon, open or vendor");
  Hand hand = makeHand(choice, {});
  if (hand.device->status().stage == DeviceStage::kHoming)
    std::fprintf(stderr, "halsted: %s: %s\n", options.test.c_str(), haptics::remedyText(hand.device->status().problem));
  const ForceCheck check = checkForces(*hand.device, kHomingPatience);
  const ordered_json json = jsonOf(options.test, check);
  if (options.json) std::printf("%s\n", json.dump(2).c_str());
  else {
    for (const Push& push : check.pushes)
      std::printf("%s %.2f N: moved %+.2f %+.2f %+.2f mm%s\n", push.axis.c_str(), push.force.norm(), push.moved.x() * 1e3, push.moved.y() * 1e3,
                  push.moved.z() * 1e3, push.right ? "" : "  <- not the way it was pushed");
    if (check.interruptions > 0) std::printf("begun again %d times: no reading for 10 ms\n", check.interruptions);
    std::printf("rest noise %.3f mm, largest force %.2f N, largest speed %.0f mm/s, %.0f ticks a second\n%s\n", check.restNoise * 1e3,
                check.largestForce, check.largestSpeed * 1e3, json["tick_rate_hz"].get<double>(), check.passed ? "passed" : "FAILED");
  }
  if (!check.ready) throw SystemFault(options.test + ": " + haptics::problemText(check.status.problem) + "; " + haptics::remedyText(check.status.problem));
  return check.passed ? kDone : kCheckFailed;
}

}  // namespace

int devices(const DevicesOptions& options) {
  if (options.bench) return benchDevices(options.json);
  if (!options.test.empty()) return test(options);
  const ordered_json found = survey(options.firmware);
  if (options.json) std::printf("%s\n", found.dump(2).c_str());
  else print(found);
  const ordered_json& attached = found["attached"];
  const bool faulty = std::any_of(attached.begin(), attached.end(), [](const ordered_json& row) { return row["fault"].get<bool>(); });
  return faulty ? kSystemFault : kDone;
}

}  // namespace halsted::app
