#include "scenes/materials.h"

#include <array>

#include "scenes/toml_input.h"

namespace halsted::scenes {
namespace {

constexpr std::size_t kLargestFile = 1 << 20;  // [bytes]

struct MaterialField {
  const char* key;
  double Material::*value;  // unit as in Material
  double min, max;          // same unit
  bool isRequired;
};
constexpr std::array<MaterialField, 5> kFields = {{{"youngs_modulus", &Material::youngsModulus, 100, 1e9, true},
                                                   {"poisson_ratio", &Material::poissonRatio, 0, 0.495, true},
                                                   {"density", &Material::density, 100, 20e3, true},
                                                   {"stiffening", &Material::stiffening, 1, 20, false},
                                                   {"toe_strain", &Material::toeStrain, 1e-3, 10, false}}};

bool isNumberKey(std::string_view key) {
  for (const MaterialField& field : kFields)
    if (key == field.key) return true;
  return false;
}

Material readMaterial(const std::string& name, const toml::table& table, const std::string& origin) {
  Material material;
  material.name = name;
  for (const auto& [key, node] : table) {
    const std::string where = whereIs(origin, node, name + "." + std::string(key.str()));
    if (key == "source") material.source = requireText(node, where);
    else if (!isNumberKey(key.str())) throw InputError(where + ": unknown key");
  }
  for (const MaterialField& field : kFields) {
    const toml::node* node = table.get(field.key);
    if (!node && !field.isRequired) continue;
    if (!node) throw InputError(whereIs(origin, table, name) + ": has no " + field.key);
    const std::string where = whereIs(origin, *node, name + "." + field.key);
    const double value = requireNumber(*node, where);  // unit as in Material
    if (!(value >= field.min && value <= field.max))
      throw InputError(where + ": must be " + plainNumber(field.min) + " to " + plainNumber(field.max));
    material.*field.value = value;
  }
  if (material.source.empty()) throw InputError(whereIs(origin, table, name) + ": has no source");
  return material;
}

}  // namespace

std::vector<Material> parseMaterials(const std::string& text, const std::string& origin) {
  const toml::table root = parseToml(text, origin);
  std::vector<Material> materials;
  for (const auto& [key, node] : root) {
    const std::string name(key.str());
    if (!node.is_table()) throw InputError(whereIs(origin, node, name) + ": must be a table, is " + kindOf(node));
    materials.push_back(readMaterial(name, *node.as_table(), origin));
  }
  return materials;
}

std::vector<Material> readMaterials() {
  const std::string path = scenesDirectory() + "/materials.toml";
  return parseMaterials(readTextFile(path, kLargestFile), path);
}

}  // namespace halsted::scenes
