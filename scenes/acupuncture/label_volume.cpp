#include "scenes/acupuncture/label_volume.h"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

constexpr int kHeader = 348;                   // [bytes] NIfTI-1
constexpr int kLargestSide = 1024;             // [voxels]
constexpr std::size_t kMostVoxels = 64u << 20;
constexpr double kMetres = 1e-3;               // [m/mm]

/// A run of the decompressed file; zlib reads plain files as they are.
class Input {
 public:
  explicit Input(const std::string& path) : path_(path), file_(gzopen(path.c_str(), "rb"), gzclose) {
    if (!file_) throw InputError(quoted(path) + ": cannot be opened");
  }
  void read(void* to, std::size_t length) {
    if (gzread(file_.get(), to, static_cast<unsigned>(length)) != static_cast<int>(length)) throw InputError(quoted(path_) + ": is cut short");
  }
  void skip(long length) {
    if (length > 0 && gzseek(file_.get(), length, SEEK_CUR) < 0) throw InputError(quoted(path_) + ": is cut short");
  }

 private:
  std::string path_;
  std::unique_ptr<gzFile_s, int (*)(gzFile)> file_;
};

template <class T> T field(const std::uint8_t* header, int at) {
  T value{};
  std::memcpy(&value, header + at, sizeof value);
  return value;
}

int bytesOf(int type) {                        // NIfTI data types whose zero is all bits zero
  switch (type) {
    case 2: case 256: return 1;                // unsigned and signed char
    case 4: case 512: return 2;
    case 8: case 768: case 16: return 4;
    default: return 0;
  }
}

void readFrame(const std::uint8_t* header, const std::string& path, LabelVolume& v) {
  if (field<std::int32_t>(header, 0) != kHeader || std::memcmp(header + 344, "n+1", 4) != 0)
    throw InputError(quoted(path) + ": is not a NIfTI-1 file of this machine's byte order");
  if (field<std::int16_t>(header, 40) < 3) throw InputError(quoted(path) + ": is not a volume");
  std::size_t voxels = 1;
  for (int a = 0; a < 3; ++a) {
    v.size[a] = field<std::int16_t>(header, 42 + 2 * a);
    if (v.size[a] < 1 || v.size[a] > kLargestSide) throw InputError(quoted(path) + ": has a side of " + std::to_string(v.size[a]) + " voxels");
    voxels *= static_cast<std::size_t>(v.size[a]);
  }
  if (voxels > kMostVoxels) throw InputError(quoted(path) + ": has too many voxels");
  if (field<std::int16_t>(header, 254) <= 0) throw InputError(quoted(path) + ": does not say how it lies in the patient (sform)");
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      const double value = field<float>(header, 280 + 16 * row + 4 * column);   // [mm]
      if (!std::isfinite(value)) throw InputError(quoted(path) + ": has a frame that is not finite");
      if (column == 3) v.origin[row] = kMetres * value;
      else if (column == row) v.spacing[row] = kMetres * value;
      else if (std::fabs(value) > 1e-3) throw InputError(quoted(path) + ": is turned against the patient's axes");
    }
  if (!(v.spacing.minCoeff() > 1e-5)) throw InputError(quoted(path) + ": its axes do not run right, front, head");
}

}  // namespace

bool LabelVolume::at(const Vec3& place) const {
  std::size_t index = 0;
  for (int a = 2; a >= 0; --a) {
    const double k = std::floor((place[a] - origin[a]) / spacing[a] + 0.5);   // [1]
    if (!(k >= 0.0 && k < size[a])) return false;
    index = index * static_cast<std::size_t>(size[a]) + static_cast<std::size_t>(k);
  }
  return inside[index] != 0;
}

LabelVolume readLabels(const std::string& path) {
  Input input(path);
  std::uint8_t header[kHeader];
  input.read(header, kHeader);
  LabelVolume v;
  readFrame(header, path, v);
  const int width = bytesOf(field<std::int16_t>(header, 70));
  if (width == 0) throw InputError(quoted(path) + ": its voxels are of a type that is not read here");
  const float offset = field<float>(header, 108);   // [bytes]
  if (!(offset >= kHeader && offset < 1e6f)) throw InputError(quoted(path) + ": its data begin nowhere");
  input.skip(static_cast<long>(offset) - kHeader);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(v.size[0] * width));
  for (int k = 0; k < v.size[1] * v.size[2]; ++k) {
    input.read(row.data(), row.size());
    for (int x = 0; x < v.size[0]; ++x) {
      bool set = false;
      for (int b = 0; b < width; ++b) set = set || row[static_cast<std::size_t>(x * width + b)] != 0;
      v.inside.push_back(set);
    }
  }
  return v;
}

}  // namespace halsted::scenes
