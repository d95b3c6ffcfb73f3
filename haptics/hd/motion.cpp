#include "haptics/hd/motion.h"

#include <cmath>

namespace halsted::haptics::hd {

namespace {

Quat blend(const Quat& a, const Quat& b, double share) noexcept {  // [1]
  const double side = a.dot(b) < 0.0 ? -1.0 : 1.0;
  Quat mixed;
  mixed.coeffs() = a.coeffs() * (1.0 - share) + b.coeffs() * (side * share);
  const double size = std::sqrt(mixed.squaredNorm());
  if (!(size > 1e-6)) return a;
  mixed.coeffs() /= size;
  return mixed;
}

}  // namespace

MotionSample sampleAt(const Motion& motion, double time, std::size_t& cursor) noexcept {  // [s]
  const auto& samples = motion.samples;
  if (samples.empty()) return {};
  if (cursor >= samples.size() || samples[cursor].time > time) cursor = 0;
  while (cursor + 1 < samples.size() && samples[cursor + 1].time <= time) ++cursor;
  MotionSample now = samples[cursor];
  if (time <= now.time || cursor + 1 == samples.size()) return now;

  const MotionSample& next = samples[cursor + 1];
  const double share = (time - now.time) / (next.time - now.time);  // [1]
  now.pose.position += (next.pose.position - now.pose.position) * share;
  now.pose.orientation = blend(now.pose.orientation, next.pose.orientation, share);
  now.time = time;
  return now;
}

}  // namespace halsted::haptics::hd
