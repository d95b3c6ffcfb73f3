#pragma once
/// Tissue presets with their sources, from scenes/materials.toml.
#include <string>
#include <vector>

namespace halsted::scenes {

struct Material {
  std::string name, source;
  double youngsModulus = 0.0;   // [Pa]
  double poissonRatio = 0.0;    // [1]
  double density = 0.0;         // [kg/m^3]
  double stiffening = 1.0;      // [1] optional in the file, as the toe
  double toeStrain = 0.2;       // [1]
};

/// In the file's order of names. Throws InputError naming file, line and key.
std::vector<Material> parseMaterials(const std::string& text, const std::string& origin);
/// The file beside the scenes.
std::vector<Material> readMaterials();

}  // namespace halsted::scenes
