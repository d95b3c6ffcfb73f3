#pragma once
/// Triangle surfaces with a known shape, and the same surface as text or bytes of every file format that is read.
#include <functional>
#include <string>

#include "scenes/mesh_readers/surface.h"

namespace halsted::testing {

/// An open tube round a centre line: row i of `rows` lies in the plane of `frame(i / (rows - 1))`.
struct TubeShape {
  int around = 40, rows = 50;
  double radius = 20e-3;                        // [m]
  double length = 150e-3;                       // [m] along the middle line
  double bendRadius = 0.0;                      // [m] of the middle line; 0 = straight along z
};
scenes::Surface tubeSurface(const TubeShape&);

/// Both faces of a wall, not connected to each other.
scenes::Surface doubleTube(const TubeShape&, double wall);       // wall [m]
scenes::Surface sphereSurface(double radius);                    // [m]
scenes::Surface planeSurface(double size);                       // [m] of one side

/// Leaves out the triangles for which `drop` is true (given the triangle's centre).
scenes::Surface without(const scenes::Surface&, const std::function<bool(const Vec3&)>& drop);

std::string asObj(const scenes::Surface&);
std::string asTextStl(const scenes::Surface&);
std::string asBinaryStl(const scenes::Surface&);
std::string asTextPly(const scenes::Surface&);
std::string asBinaryPly(const scenes::Surface&);
std::string asVtk(const scenes::Surface&);

/// A new empty folder under the test's temporary directory, and a file in it.
std::string freshFolder(const std::string& name);
void writeFile(const std::string& path, const std::string& content);

}  // namespace halsted::testing
