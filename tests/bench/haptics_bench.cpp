/// Cost of one haptic tick: device, coupling and limits of one hand. The budget of two hands is 1 ms.
#include <benchmark/benchmark.h>

#include "haptics/hand_loop.h"
#include "haptics/kinematics.h"
#include "haptics/virtual_device.h"

namespace halsted::haptics {
namespace {

LocalContact pressed(std::uint64_t step, int planes) {
  LocalContact contact;
  contact.step = step;
  contact.touching = true;
  contact.force = Vec3(0.1, 0.8, -0.2);
  contact.stiffness = 400.0 * Mat3::Identity();
  contact.damping = 0.5 * Mat3::Identity();
  contact.planeCount = planes;
  for (int i = 0; i < planes; ++i) contact.planes[i].normal = Vec3(0.2 * i, 1.0, -0.1 * i).normalized();
  return contact;
}

/// The whole tick with the Touch in software and a new model every time.
void hapticTick(benchmark::State& run) {
  VirtualDevice device;
  const HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  HandTarget target;
  target.valid = true;
  target.pose.position = Vec3(0.002, -0.003, 0.001);
  LocalContact contact = pressed(0, static_cast<int>(run.range(0)));
  std::uint64_t index = 0;
  for (auto _ : run) {
    contact.step = ++index;
    tick(device, config, contact, target, index, state, output);
    benchmark::DoNotOptimize(output);
  }
}
BENCHMARK(hapticTick)->Arg(0)->Arg(4)->Unit(benchmark::kNanosecond);

void virtualDeviceRead(benchmark::State& run) {
  VirtualDevice device;
  for (auto _ : run) {
    DeviceReading reading = device.read(1e-3);
    benchmark::DoNotOptimize(reading);
    device.write(Vec3(0.1, 0.2, 0.3));
  }
}
BENCHMARK(virtualDeviceRead)->Unit(benchmark::kNanosecond);

void touchInverseKinematics(benchmark::State& run) {
  Vec3 position(0.01, 0.02, -0.01);
  for (auto _ : run) {
    auto joints = touchJoints(position);
    benchmark::DoNotOptimize(joints);
  }
}
BENCHMARK(touchInverseKinematics)->Unit(benchmark::kNanosecond);

}  // namespace
}  // namespace halsted::haptics
