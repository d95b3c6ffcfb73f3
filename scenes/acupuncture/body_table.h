#pragma once
/// A table of acupoints of one body, scenes/NAME/bodies/BODY.toml: how to find them on the body's skin, and how they are needled.
/// Places are proportional, as in the textbooks: a body is measured by its landmarks in cun, so a point is where it is on any size.
#include <string>
#include <vector>

#include "scenes/harmonics/region.h"
#include "scenes/scene.h"

namespace halsted::scenes {

struct Landmark { Vec3 at = Vec3::Zero(); double cun = 0.0; };   // [mesh units], [cun]; inside the body

struct PointEntry {
  std::string id, name, source;
  double along = 0.0;                          // along_cun [cun] between the landmarks
  double side = 0.0;                           // side_cun [cun] to the body's left
  double around = 0.0;                         // around_deg [deg] from the front about the landmarks' line, to the body's left
  double depth = 0.0;                          // depth_mm [m]
  double angle = 0.0;                          // angle_deg [deg] between needle and skin
  Vec3 lean = Vec3::Zero();                    // [mesh axes] the way an oblique needle points; zero: to the foot end
};

struct BodyTable {
  std::string path, title;
  std::string mesh;                            // file below HALSTED_DATA; empty: a slab
  double scale = 1.0;                          // [m per mesh unit]
  Superellipsoid slab;
  std::vector<CutPlane> cuts;                  // [mesh units]
  Vec3 inside = Vec3::Zero();                  // [mesh units] near the piece that is kept
  Vec3 front = Vec3::UnitZ(), head = Vec3::UnitY();   // [1]
  double sideCun = 25e-3;                      // side_cun_mm [m] of one cun across
  std::vector<Landmark> landmarks;             // cun rising
  std::vector<PointEntry> points;
};

/// Throws InputError naming file, line and key.
BodyTable readBodyTable(const std::string& path);

/// The table that the scene names, or whose mesh has the name of the scene's; else the slab's.
BodyTable chooseBodyTable(const SceneFile&);

}  // namespace halsted::scenes
