#pragma once
/// Tissue as tetrahedra: what every solver shares, and the data of each. Built at load time.
#include <span>
#include <vector>

#include "sim/materials/corotated.h"
#include "sim/mesh.h"
#include "sim/params.h"
#include "sim/tissue/projective_model.h"
#include "sim/tissue/shape_matching_model.h"
#include "sim/tissue/xpbd_model.h"

namespace halsted {

/// mu, lambda of isotropic linear elasticity.
struct Lame { double mu = 0.0, lambda = 0.0; };                  // [Pa]
Lame lame(double youngsModulus, double poissonRatio);            // [Pa], [1]

struct TissueModel {
  TissueSolver solver = TissueSolver::kProjective;
  double dt = 1e-3;                            // [s]
  Vec3 gravity = Vec3::Zero();                 // [m/s^2]
  double massDamping = 0.0;                    // [1/s]
  Corotated material;                          // the solvers but the projective one do not stiffen
  std::vector<std::array<int, 4>> tets;        // as in the mesh
  std::vector<Mat3> restInverse;               // [1/m] per tet: inverse of the rest edge matrix (x1-x0, x2-x0, x3-x0)
  std::vector<double> restVolume;              // [m^3] per tet
  std::vector<Vec3> rest;                      // [m] per particle
  std::vector<double> mass;                    // [kg] per particle, lumped
  std::vector<char> isFixed;                   // per particle: 1 = held in place
  ProjectiveModel projective;                  // always built: its inverse is also the compliance that contacts see
  XpbdModel xpbd;                              // only for kXpbd
  ShapeMatchingModel shape;                    // only for kShapeMatching
};

/// Throws std::invalid_argument when a tet is flat or inverted, or a value makes no sense.
TissueModel buildTissue(const TetMesh&, const SimParams&);

}  // namespace halsted
