#include "scenes/acupuncture/body_table.h"

#include <algorithm>
#include <filesystem>

#include "scenes/toml_input.h"

namespace halsted::scenes {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = 1 << 20;  // [bytes]
constexpr std::size_t kMostPoints = 200;

/// One TOML table and where it stands, for values that are looked up by name.
struct Reader {
  const toml::table& table;
  const std::string& origin;
  std::string prefix;                          // "point."

  const toml::node* find(const char* key) const { return table.get(key); }
  std::string where(const char* key) const {
    const toml::node* node = find(key);
    return whereIs(origin, node ? *node : static_cast<const toml::node&>(table), prefix + key);
  }
  void number(const char* key, std::array<double, 2> range, double unit, double& out) const {   // unit [SI per written unit]
    if (!find(key)) return;
    const double value = requireNumber(*find(key), where(key));
    if (!(value >= range[0] && value <= range[1]))
      throw InputError(where(key) + ": must be " + plainNumber(range[0]) + " to " + plainNumber(range[1]) + ", is " + plainNumber(value));
    out = value * unit;
  }
  void required(const char* key, std::array<double, 2> range, double unit, double& out) const {
    if (!find(key)) throw InputError(where(key) + ": is missing");
    number(key, range, unit, out);
  }
  void text(const char* key, bool mustBe, std::string& out) const {
    if (find(key)) out = requireText(*find(key), where(key));
    if (mustBe && out.empty()) throw InputError(where(key) + ": is missing");
  }
  void vector(const char* key, bool mustBe, Vec3& out) const {
    if (!find(key)) {
      if (mustBe) throw InputError(where(key) + ": is missing");
      return;
    }
    const toml::array* list = find(key)->as_array();
    if (!list || list->size() != 3) throw InputError(where(key) + ": must be a list of three numbers");
    for (int i = 0; i < 3; ++i) {
      out[i] = requireNumber((*list)[static_cast<std::size_t>(i)], where(key));
      if (!(out[i] > -1e9 && out[i] < 1e9)) throw InputError(where(key) + ": out of range");
    }
  }
  void knows(std::initializer_list<const char*> keys) const {
    for (const auto& [key, node] : table)
      if (std::none_of(keys.begin(), keys.end(), [&, name = key.str()](const char* k) { return name == k; }))
        throw InputError(whereIs(origin, node, prefix + std::string(key.str())) + ": unknown key");
  }
  /// Calls `each` with every table of a list.
  template <class Each> void list(const char* key, const Each& each) const {
    if (!find(key)) return;
    const toml::array* entries = find(key)->as_array();
    if (!entries) throw InputError(where(key) + ": must be [[" + key + "]] tables");
    if (entries->size() > kMostPoints) throw InputError(where(key) + ": more than " + std::to_string(kMostPoints));
    for (const toml::node& entry : *entries) {
      if (!entry.is_table()) throw InputError(whereIs(origin, entry, key) + ": must be a table");
      each(Reader{*entry.as_table(), origin, std::string(key) + "."});
    }
  }
};

PointEntry readPoint(const Reader& r) {
  r.knows({"id", "name", "source", "along_cun", "side_cun", "around_deg", "depth_mm", "angle_deg", "lean"});
  PointEntry p;
  r.text("id", true, p.id);
  r.text("name", true, p.name);
  r.text("source", true, p.source);
  r.required("along_cun", {-100.0, 100.0}, 1.0, p.along);
  r.number("side_cun", {-20.0, 20.0}, 1.0, p.side);
  r.number("around_deg", {-180.0, 180.0}, 1.0, p.around);
  r.required("depth_mm", {1.0, 100.0}, 1e-3, p.depth);
  r.required("angle_deg", {5.0, 90.0}, 1.0, p.angle);
  r.vector("lean", false, p.lean);
  return p;
}

void readShape(const Reader& r, BodyTable& t) {
  r.text("mesh", false, t.mesh);
  r.number("scale", {1e-9, 1e3}, 1.0, t.scale);
  r.vector("half_size", false, t.slab.halfSize);
  r.number("power", {2.0, 10.0}, 1.0, t.slab.power);
  r.vector("inside", false, t.inside);
  r.list("cut", [&](const Reader& cut) {
    cut.knows({"point", "normal"});
    CutPlane plane;
    cut.vector("point", true, plane.point);
    cut.vector("normal", true, plane.normal);
    if (!(plane.normal.norm() > 0.0)) throw InputError(cut.where("normal") + ": has no length");
    t.cuts.push_back(plane);
  });
}

void readFrame(const Reader& r, BodyTable& t) {
  r.vector("front", true, t.front);
  r.vector("head", true, t.head);
  if (!(t.front.cross(t.head).norm() > 1e-3 * t.front.norm() * t.head.norm())) throw InputError(r.where("head") + ": lies along front");
  r.number("side_cun_mm", {1.0, 200.0}, 1e-3, t.sideCun);
  r.list("landmark", [&](const Reader& mark) {
    mark.knows({"name", "at", "cun"});
    Landmark l;
    mark.vector("at", true, l.at);
    mark.required("cun", {-100.0, 100.0}, 1.0, l.cun);
    if (!t.landmarks.empty() && !(l.cun > t.landmarks.back().cun)) throw InputError(mark.where("cun") + ": must rise from landmark to landmark");
    t.landmarks.push_back(l);
  });
  if (t.landmarks.size() < 2) throw InputError(r.where("landmark") + ": there must be two");
}

}  // namespace

BodyTable readBodyTable(const std::string& path) {
  const toml::table root = parseToml(readTextFile(path, kLargestFile), path);
  const Reader r{root, path, ""};
  r.knows({"title", "mesh", "scale", "half_size", "power", "inside", "cut", "front", "head", "side_cun_mm", "landmark", "point"});
  BodyTable t;
  t.path = path;
  r.text("title", true, t.title);
  readShape(r, t);
  readFrame(r, t);
  r.list("point", [&](const Reader& point) {
    t.points.push_back(readPoint(point));
    for (std::size_t i = 0; i + 1 < t.points.size(); ++i)
      if (t.points[i].id == t.points.back().id) throw InputError(point.where("id") + ": stands twice");
  });
  if (t.points.empty()) throw InputError(r.where("point") + ": there is none");
  return t;
}

BodyTable chooseBodyTable(const SceneFile& scene) {
  const AnatomyParams& anatomy = scene.params.anatomy;
  const fs::path folder = fs::path(scene.folder) / "bodies";
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".toml") files.push_back(it->path());
  std::sort(files.begin(), files.end());
  std::string known;
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    known += (known.empty() ? "" : ", ") + name;
    if (!anatomy.body.empty()) {
      if (name == anatomy.body) return readBodyTable(file.string());
      continue;
    }
    const BodyTable table = readBodyTable(file.string());
    if (fs::path(table.mesh).filename() == fs::path(anatomy.mesh).filename()) return table;   // the slab has none
  }
  if (anatomy.body.empty())
    throw InputError(placeOf(scene, "anatomy.mesh") + ": no table of acupoints is for this surface; name one as anatomy.body: " + known);
  throw InputError(placeOf(scene, "anatomy.body") + ": '" + quoted(anatomy.body) + "' is not one of " + known);
}

}  // namespace halsted::scenes
