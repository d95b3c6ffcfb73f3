#include "scenes/acupuncture/ct_layers.h"

#include <algorithm>
#include <filesystem>

#include "scenes/acupuncture/label_volume.h"
#include "scenes/input_text.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kStride = 0.25e-3;            // [m] along a ray
constexpr double kGap = 4e-3;                  // [m] of neither that still belongs to the layer: a mask has holes of a voxel
constexpr double kReach = 0.5;                 // [m]

/// Middle of the fat's outline in one slice; false when the slice has none.
bool middle(const LabelVolume& v, int z, Vec3& centre) {
  int count = 0;
  Vec3 low = v.centre(v.size[0], v.size[1], z), high = v.centre(0, 0, z);   // [m]
  for (int y = 0; y < v.size[1]; ++y)
    for (int x = 0; x < v.size[0]; ++x) {
      const Vec3 p = v.centre(x, y, z);
      if (!v.at(p)) continue;
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      ++count;
    }
  centre = 0.5 * (low + high);
  centre.z() = v.centre(0, 0, z).z();
  return count > 0;
}

/// Length of a mask along a ray from `from` on, until it has ended for good; `from` moves to its end.  [m]
double run(const LabelVolume& mask, const Vec3& outer, const Vec3& inward, double& from) {   // from [m]
  double first = -1.0, last = -1.0;            // [m]
  for (double s = from; s < kReach; s += kStride) {
    if (mask.at(outer + s * inward)) {
      if (first < 0.0) first = s;
      last = s;
    } else if (last >= 0.0 && s - last > kGap) {
      break;
    }
  }
  if (first < 0.0) return 0.0;
  from = last;
  return last - first + kStride;
}

double median(std::vector<double>& values) {   // [m]
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

CtLayers measureLayers(const std::string& fatMask, double angleDegrees, const std::string& where) {
  const LabelVolume fat = readLabels(fatMask), muscle = readLabels((std::filesystem::path(fatMask).parent_path() / "skeletal_muscle.nii.gz").string());
  std::vector<double> fats, muscles;           // [m]
  for (int z = 0; z < fat.size[2]; ++z) {
    Vec3 centre = Vec3::Zero();                // [m]
    if (!middle(fat, z, centre)) continue;
    for (int k = -5; k <= 5; ++k) {
      const double angle = (angleDegrees + k) * kPi / 180.0;             // [rad]
      const Vec3 outward(-sine(angle), cosine(angle), 0.0);              // RAS: the patient's left is -x
      double at = 0.0;                         // [m]
      const double f = run(fat, centre + kReach * outward, -outward, at), m = f > 0.0 ? run(muscle, centre + kReach * outward, -outward, at) : 0.0;
      if (f > 0.0 && m > 0.0) { fats.push_back(f); muscles.push_back(m); }
    }
  }
  if (fats.size() < 20) throw InputError(where + ": the CT shows no fat over muscle there");
  return {median(fats), median(muscles)};
}

}  // namespace halsted::scenes
