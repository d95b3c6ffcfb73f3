#include "haptics/open_device/open_model.h"

#include <algorithm>
#include <cmath>

#include "haptics/usb/known_devices.h"

namespace halsted::haptics {
namespace {

constexpr double kPeriod = 1e-3;               // [s] of the firmware's servo loop
constexpr std::size_t kQueue = 4;              // packets that wait for the host; the oldest go first

HodIdentity identityOf(const OpenModelOptions& options) {
  HodIdentity identity{};
  identity.firmware = 0x0100;
  identity.rate = 1000;
  identity.peakForce = 4000;
  identity.continuousForce = 1000;
  identity.stiffness = 1500;
  identity.positionStep = 200;                 // 20 um
  std::copy_n(options.serial.begin(), std::min<std::size_t>(options.serial.size(), sizeof identity.serial), identity.serial);
  return identity;
}

TouchDynamics openDynamics() {
  TouchDynamics dynamics;
  dynamics.mass = 0.08;
  dynamics.friction = 0.2;
  dynamics.positionStep = 20e-6;
  dynamics.peakForce = 4.0 * std::sqrt(3.0);   // every axis on its own
  return dynamics;
}

}  // namespace

OpenModel::OpenModel(const OpenModelOptions& options) : options_(options), stylus_({}, openDynamics(), {}, "open model") {
  moveHand(Vec3::Zero());
  attach();
}

UsbDeviceInfo OpenModel::info() const {
  UsbDeviceInfo info;
  info.vendor = kOpenDeviceVendor;
  info.product = kOpenDeviceProduct;
  info.serial = options_.serial;
  info.productName = kOpenDeviceName;
  return info;
}

std::vector<std::uint8_t> OpenModel::descriptors() const {
  return bulkDescriptors({kOpenDeviceVendor, kOpenDeviceProduct, 0x0100, 0xff, 0x81, 0x01, true});
}

/// Powered by the cable: a plug starts it anew.
void OpenModel::attach() {
  const HodIdentity identity = identityOf(options_);
  hodBegin(&firmware_, &identity);
  toHost_.clear();
  force_.setZero();
  powered_ = true;
}

void OpenModel::detach() {
  powered_ = false;
  force_.setZero();
}

void OpenModel::out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) {
  if (endpoint != 0x01) return;
  std::vector<std::uint8_t> heard(bytes.begin(), bytes.end());
  // A device of another version takes our frames for foreign ones, as ours would take its.
  if (options_.version != kHodVersion && heard.size() > 4) {
    heard[2] = static_cast<std::uint8_t>(kHodVersion + 1);
    const std::uint16_t check = hodChecksum(heard.data() + 2, heard.size() - 4);
    heard[heard.size() - 2] = static_cast<std::uint8_t>(check & 0xff);
    heard[heard.size() - 1] = static_cast<std::uint8_t>(check >> 8);
  }
  hodReceive(&firmware_, heard.data(), heard.size(), static_cast<std::uint32_t>(time_ * 1e6));
}

std::size_t OpenModel::in(std::uint8_t endpoint, std::span<std::uint8_t> bytes) {
  if (endpoint != 0x81 || toHost_.empty()) return 0;
  const std::vector<std::uint8_t> packet = std::move(toHost_.front());
  toHost_.pop_front();
  const std::size_t size = std::min(packet.size(), bytes.size());
  std::copy_n(packet.begin(), size, bytes.begin());
  return size;
}

void OpenModel::advance(double dt) {           // [s]
  time_ += dt;
  if (time_ >= nextServo_) {
    nextServo_ += kPeriod;
    if (powered_) servo();
  }
  stylus_.write(force_);
  stylus_.read(dt);
}

void OpenModel::servo() {
  const auto now = static_cast<std::uint32_t>(time_ * 1e6);
  const DeviceReading reading = stylus_.read(0.0);
  HodSample sample{};
  for (int i = 0; i < 3; ++i) sample.position[i] = static_cast<std::int32_t>(std::lround(reading.pose.position[i] * 1e7));
  const Quat& q = reading.pose.orientation;
  const double parts[4] = {q.w(), q.x(), q.y(), q.z()};
  for (int i = 0; i < 4; ++i) sample.orientation[i] = static_cast<std::int16_t>(std::lround(parts[i] * 32767.0));
  sample.jaw = 65535;
  sample.buttons = buttons_;
  sample.status = options_.homed ? kHodHomed : 0;
  std::vector<std::uint8_t> packet(kHodMaxFrame);
  packet.resize(hodState(&firmware_, &sample, now, packet.data()));
  if (!packet.empty()) toHost_.push_back(packet);
  if (toHost_.size() > kQueue) toHost_.pop_front();
  std::int16_t force[3];
  hodForce(&firmware_, now, force);
  force_ = Vec3(force[0], force[1], force[2]) * 1e-3;
}

void OpenModel::moveHand(const Vec3& position) {
  HandTarget target;
  target.pose.position = position;
  target.valid = true;
  stylus_.setTarget(target);
}

}  // namespace halsted::haptics
