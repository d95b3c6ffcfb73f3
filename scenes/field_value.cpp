#include "scenes/field_value.h"

#include <array>
#include <utility>

#include "scenes/materials.h"
#include "scenes/mesh_path.h"

namespace halsted::scenes {
namespace {

template <typename T>
using Names = std::array<std::pair<const char*, T>, 3>;

constexpr Names<TissueSolver> kSolvers = {{{"projective", TissueSolver::kProjective},
                                           {"xpbd", TissueSolver::kXpbd},
                                           {"shape_matching", TissueSolver::kShapeMatching}}};
constexpr std::array<std::pair<const char*, ThreadAssist>, 2> kAssists = {{{"none", ThreadAssist::kNone}, {"knot", ThreadAssist::kKnot}}};
constexpr std::array<std::pair<const char*, ToolKind>, 7> kTools = {{{"needle_driver", ToolKind::kNeedleDriver},
                                                                     {"forceps", ToolKind::kForceps},
                                                                     {"acupuncture_needle", ToolKind::kAcupunctureNeedle},
                                                                     {"finger", ToolKind::kFinger},
                                                                     {"electrocautery", ToolKind::kElectrocautery},
                                                                     {"allis", ToolKind::kAllis},
                                                                     {"none", ToolKind::kNone}}};
constexpr std::array<std::pair<const char*, ModelKind>, 2> kModels = {{{"suture", ModelKind::kSuture}, {"needling", ModelKind::kNeedling}}};
constexpr std::array<std::pair<const char*, NetProfile>, 2> kProfiles = {
    {{"inverse_distance", NetProfile::kInverseDistance}, {"cone", NetProfile::kCone}}};

/// One overload per kind of slot.
struct Setter {
  const SceneField& field;
  const toml::node& node;
  const ValueSource& source;

  double ranged(double value) const {  // [field.unit]
    if (value >= field.min && value <= field.max) return value;
    throw InputError(source.where + ": must be " + plainNumber(field.min) + " to " + plainNumber(field.max) +
                     (*field.unit ? std::string(" ") + field.unit : "") + ", is " + plainNumber(value));
  }
  std::int64_t integer() const {
    if (!node.is_integer()) throw InputError(source.where + ": must be an integer, is " + kindOf(node));
    const std::int64_t value = *node.value<std::int64_t>();
    ranged(static_cast<double>(value));
    return value;
  }
  std::string text() const {
    std::string value = requireText(node, source.where);
    if (static_cast<double>(value.size()) > field.max)
      throw InputError(source.where + ": longer than " + plainNumber(field.max) + " characters");
    for (unsigned char c : value)
      if (c < 0x20 || c == 0x7f) throw InputError(source.where + ": contains a control character");
    return value;
  }
  template <typename Table, typename T>
  void named(const Table& names, T& out) const {
    const std::string value = requireText(node, source.where);
    std::string known;
    for (const auto& [name, meaning] : names) {
      if (value == name) {
        out = meaning;
        return;
      }
      known += (known.empty() ? "" : ", ") + std::string(name);
    }
    throw InputError(source.where + ": '" + quoted(value) + "' is not one of " + known);
  }

  void operator()(double* out) const { *out = ranged(requireNumber(node, source.where)); }
  void operator()(int* out) const { *out = static_cast<int>(integer()); }
  void operator()(std::uint64_t* out) const { *out = static_cast<std::uint64_t>(integer()); }
  void operator()(std::string* out) const { *out = text(); }
  void operator()(TissueSolver* out) const { named(kSolvers, *out); }
  void operator()(ThreadAssist* out) const { named(kAssists, *out); }
  void operator()(ToolKind* out) const { named(kTools, *out); }
  void operator()(ModelKind* out) const { named(kModels, *out); }
  void operator()(NetProfile* out) const { named(kProfiles, *out); }
  void operator()(bool* out) const {
    if (!node.is_boolean()) throw InputError(source.where + ": must be true or false, is " + kindOf(node));
    *out = *node.value<bool>();
  }
  void operator()(Vec3* out) const {
    const toml::array* list = node.as_array();
    if (!list || list->size() != 3)
      throw InputError(source.where + ": must be a list of three numbers, is " + (list ? "a list of another length" : kindOf(node)));
    Vec3 value;
    for (int i = 0; i < 3; ++i) value[i] = ranged(requireNumber((*list)[static_cast<std::size_t>(i)], source.where));
    *out = value;
  }
  void operator()(const MaterialName& out) const {
    const std::string value = requireText(node, source.where);
    std::string known;
    for (const Material& material : readMaterials()) {
      known += (known.empty() ? "" : ", ") + material.name;
      if (material.name != value) continue;
      out.tissue->youngsModulus = material.youngsModulus;
      out.tissue->poissonRatio = material.poissonRatio;
      out.tissue->density = material.density;
      out.tissue->stiffening = material.stiffening;
      out.tissue->toeStrain = material.toeStrain;
      return;
    }
    throw InputError(source.where + ": '" + quoted(value) + "' is not one of " + known);
  }
  void operator()(const MeshPath& out) const {
    const std::string value = text();
    if (value.empty()) out.path->clear();
    else if (source.trustedPath) *out.path = meshPathFromUser(value, source.where);
    else *out.path = meshPathInFile(value, source.folder, source.where);
  }
};

bool takesText(const FieldSlot& slot) {
  return std::holds_alternative<std::string*>(slot) || std::holds_alternative<TissueSolver*>(slot) || std::holds_alternative<ThreadAssist*>(slot) ||
         std::holds_alternative<ToolKind*>(slot) || std::holds_alternative<ModelKind*>(slot) || std::holds_alternative<NetProfile*>(slot) || std::holds_alternative<MaterialName>(slot) ||
         std::holds_alternative<MeshPath>(slot);
}

}  // namespace

void setField(const SceneField& field, const toml::node& node, const ValueSource& source) {
  std::visit(Setter{field, node, source}, field.slot);
}

void setFieldFromText(const SceneField& field, const std::string& text, const ValueSource& source) {
  if (takesText(field.slot)) {
    const bool inQuotes = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    setField(field, toml::value<std::string>(inQuotes ? text.substr(1, text.size() - 2) : text), source);
    return;
  }
  for (unsigned char c : text)
    if (c < 0x20 || c == '#') throw InputError(source.where + ": is not a value");
  toml::table parsed;
  try {
    parsed = parseToml("value = " + text, "");
  } catch (const InputError&) {
    throw InputError(source.where + ": is not a value");
  }
  setField(field, *parsed.get("value"), source);
}

}  // namespace halsted::scenes
