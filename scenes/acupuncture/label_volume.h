#pragma once
/// A mask from a CT: NIfTI-1, one file, plain or gzip (.nii, .nii.gz), axes along the patient's (RAS: right, front, head are +).
#include <cstdint>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted::scenes {

struct LabelVolume {
  std::array<int, 3> size{};
  Vec3 origin = Vec3::Zero(), spacing = Vec3::Ones();   // [m] centre of the first voxel; between voxels
  std::vector<std::uint8_t> inside;            // 1 where the label is set; x runs fastest

  bool at(const Vec3& place) const;            // place [m]; false outside the volume
  Vec3 centre(int x, int y, int z) const { return origin + Vec3(x, y, z).cwiseProduct(spacing); }   // [m]
};

/// Throws InputError "path: ..." for what is no such file, is too large, cut short or turned against the patient's axes.
LabelVolume readLabels(const std::string& path);

}  // namespace halsted::scenes
