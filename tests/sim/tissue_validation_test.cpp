/// The stiffness promise (DESIGN 6) against closed forms, at the scene's own step, material and density. Static states are reached by
/// letting the damped block settle in virtual time through the calls of a step. Shape matching has no material and makes no promise.
#include <gtest/gtest.h>

#include "tests/sim/linear_fem.h"
#include "tests/sim/tissue_block.h"

namespace halsted {
namespace {

class StiffnessPromise : public testing::TestWithParam<TissueSolver> {
 protected:
  static SimParams params() {
    SimParams p = sceneParams(GetParam());
    p.tissue.massDamping = 60.0;               // settles in a few hundred steps; a static state does not know damping
    return p;
  }
};
INSTANTIATE_TEST_SUITE_P(Tissue, StiffnessPromise, testing::Values(TissueSolver::kProjective, TissueSolver::kXpbd),
                         [](const auto& solver) { return solverName(solver.param); });

/// A strip 20 x 4 x 1 cells of 2 mm, pulled along x at both ends.
TEST_P(StiffnessPromise, AStripStretchesAsYoungsModulusSays) {
  const SimParams p = params();
  const Vec3 size(40e-3, 8e-3, 2e-3);          // [m]
  TissueBlock strip(blockMesh(20, 4, 1, size), p);
  const double strain = 2e-3;                  // [1]
  strip.pull(Vec3(p.tissue.youngsModulus * strain, 0, 0).asDiagonal());
  strip.run(1200);
  const double stretch = (strip.meanOnPlane(0, size.x()) - strip.meanOnPlane(0, 0.0)) / size.x() - 1.0;      // [1]
  const double lateral = (strip.meanOnPlane(1, size.y()) - strip.meanOnPlane(1, 0.0)) / size.y() - 1.0;      // [1]
  RecordProperty("stretch_over_hooke", std::to_string(stretch / strain));
  RecordProperty("lateral_over_poisson", std::to_string(-lateral / (p.tissue.poissonRatio * strain)));
  EXPECT_NEAR(stretch / strain, 1.0, 0.05);
  EXPECT_NEAR(-lateral / (p.tissue.poissonRatio * strain), 1.0, 0.05);
}

/// F1: tets of all shapes under one stress take one strain, that of the material: 10 % and shear, far from linear; and 35 %, well past
/// the toe, for the solver that stiffens.
TEST_P(StiffnessPromise, AnIrregularPatchTakesOneStrain) {
  const SimParams p = params();
  TetMesh mesh = blockMesh(4, 3, 3, Vec3(12e-3, 9e-3, 9e-3));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 shift(std::sin(12.9 * i), std::sin(78.2 * i), std::sin(37.7 * i));
    mesh.vertices[i] += 0.5e-3 * shift;
  }
  TissueBlock patch(mesh, p);
  Mat3 F;
  F << 1.10, 0.05, 0.0, 0.05, 0.96, -0.03, 0.0, -0.03, 1.02;
  const Corotated m = patch.model.material;
  const bool projective = GetParam() == TissueSolver::kProjective;
  if (projective) F << 1.35, 0.05, 0.0, 0.05, 0.92, -0.03, 0.0, -0.03, 0.94;   // pulled on every side: squeezed ones turn over
  patch.pull(projective ? stress(m, F) : stress(StableNeoHookean{m.mu, m.lambda}, F));
  patch.run(3000);
  const Mat3 green = 0.5 * (F.transpose() * F - Mat3::Identity());     // [1] blind to rotation
  double worst = 0.0;                          // [1]
  Mat3 mean = Mat3::Zero();                    // [1]
  for (int t = 0; t < static_cast<int>(patch.model.tets.size()); ++t) {
    const Mat3 f = patch.deformation(t);
    const Mat3 error = 0.5 * (f.transpose() * f - Mat3::Identity()) - green;   // [1]
    worst = std::max(worst, error.norm() / green.norm());
    mean += error * patch.model.restVolume[t] / volume(mesh);
  }
  RecordProperty("mean_strain_error", std::to_string(mean.norm() / green.norm()));
  RecordProperty("worst_strain_error", std::to_string(worst));
  EXPECT_LT(mean.norm() / green.norm(), projective ? 1e-6 : 0.05);
  EXPECT_LT(worst, projective ? 1e-6 : 0.15);  // one sweep a substep leaves more in the thinnest tets
}

/// A plate one cell thick, held at one end and pressed at the other: the load under which one sweep a substep is softest.
double plateDeflection(SimParams p) {          // [m]
  TetMesh mesh = blockMesh(10, 4, 1, Vec3(20e-3, 8e-3, 2e-3));
  for (int i = 0; i < static_cast<int>(mesh.vertices.size()); ++i)
    if (mesh.vertices[i].x() == 0.0) mesh.fixed.push_back(i);
  p.tissue.massDamping = 20.0;
  TissueBlock plate(mesh, p);
  for (std::size_t i = 0; i < plate.model.rest.size(); ++i)
    if (plate.model.rest[i].x() > 19.9e-3) plate.force[i] = Vec3(0, 0, -1e-5);
  plate.run(2500);
  return 2e-3 - plate.meanOnPlane(2, 2e-3);    // of the whole upper face
}

TEST(Xpbd, IsNeverSofterThanItsBuilderSays) {
  const double exact = plateDeflection(sceneParams(TissueSolver::kProjective));   // [m]
  for (int substeps : {8, 16, 0}) {
    SimParams p = sceneParams(TissueSolver::kXpbd);
    p.tissue.substeps = substeps;
    const TissueBlock sample(blockMesh(10, 4, 1, Vec3(20e-3, 8e-3, 2e-3)), p);
    const double shortfall = sample.model.xpbd.stiffnessShortfall;     // [1]
    const double softer = plateDeflection(p) / exact - 1.0;            // [1]
    RecordProperty("softer_at_" + std::to_string(sample.model.xpbd.substeps), std::to_string(softer));
    EXPECT_LE(softer, 1.05 * shortfall) << substeps;
    EXPECT_GT(softer, 0.0);
    if (substeps == 0) {
      EXPECT_LE(shortfall, 0.05);
    } else {
      EXPECT_GT(shortfall, 0.05);
    }
  }
}

// ---- F5, the punch ---------------------------------------------------------------------------------------------------------------
// A rigid frictionless square punch, half side b, on a block of half side and depth 20 b. Linear tets are too stiff beside the stress
// singularity at its edge: 65 % with two cells per b, 18 % with eight, falling with the cell size. So the closed form is met in two
// steps: the solvers meet static linear elasticity on their own mesh, and that meets the closed form as the mesh is refined.

constexpr double kHalfSide = 2e-3;             // [m] b

/// Distances from the centre in units of b, each cell cut in `parts`.
std::vector<double> grades(const std::vector<double>& coarse, int parts) {   // coarse [1]
  std::vector<double> fine;
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i)
    for (int k = 0; k < parts; ++k) fine.push_back(coarse[i] + (coarse[i + 1] - coarse[i]) * k / parts);
  fine.push_back(coarse.back());
  return fine;
}

/// The block under z = 0, held at its bottom; whole, or the quarter with x, y >= 0.
TetMesh punchBlock(const std::vector<double>& grade, bool quarter) {   // grade [1]
  const int n = static_cast<int>(grade.size()) - 1, lateral = quarter ? n : 2 * n;
  TetMesh mesh = blockMesh(lateral, lateral, n, Vec3(lateral, lateral, n));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    Vec3& x = mesh.vertices[i];
    const auto side = [&](double cell) {       // cell [1]
      const int k = static_cast<int>(std::lround(cell)) - (quarter ? 0 : n);
      return k < 0 ? -grade[-k] : grade[k];
    };
    const int below = n - static_cast<int>(std::lround(x.z()));
    x = kHalfSide * Vec3(side(x.x()), side(x.y()), -grade[below]);
    if (below == n) mesh.fixed.push_back(static_cast<int>(i));
  }
  return mesh;
}

bool isUnderPunch(const Vec3& x) {             // [m]
  return x.z() > -1e-9 && std::fabs(x.x()) < kHalfSide + 1e-9 && std::fabs(x.y()) < kHalfSide + 1e-9;
}

/// 2 a E / (1 - nu^2) with the circle of the same area (a square is 1.2 % stiffer, King 1987).  [N/m]
double halfSpaceStiffness(const SimParams& p) {
  const double a = 2.0 * kHalfSide / std::sqrt(3.14159265358979312);   // [m]
  return 2.0 * a * p.tissue.youngsModulus / (1.0 - p.tissue.poissonRatio * p.tissue.poissonRatio);
}

double staticPunchStiffness(const SimParams& p, const TetMesh& mesh, bool quarter) {   // [N/m]
  const int n = static_cast<int>(mesh.vertices.size());
  Support support{std::vector<char>(3 * n, 0), Eigen::VectorXd::Zero(3 * n)};
  for (int i : mesh.fixed)
    for (int a = 0; a < 3; ++a) support.given[3 * i + a] = 1;
  for (int i = 0; i < n; ++i) {
    const Vec3& x = mesh.vertices[i];
    if (quarter && x.x() < 1e-9) support.given[3 * i] = 1;
    if (quarter && x.y() < 1e-9) support.given[3 * i + 1] = 1;
    if (!isUnderPunch(x)) continue;
    support.given[3 * i + 2] = 1;
    support.value[3 * i + 2] = -1.0;           // [m] linear: any depth will do
  }
  const Eigen::VectorXd force = reactions(mesh, lame(p.tissue.youngsModulus, p.tissue.poissonRatio), support);   // [N]
  double sum = 0.0;                            // [N]
  for (int i = 0; i < n; ++i)
    if (isUnderPunch(mesh.vertices[i])) sum -= force[3 * i + 2];
  return quarter ? 4.0 * sum : sum;
}

/// Force over depth: each touched particle's force grows until it stands at the punch's depth.  [N/m]
double settledPunchStiffness(TissueBlock& block, double depth) {       // depth [m]
  std::vector<int> touched;
  for (std::size_t i = 0; i < block.model.rest.size(); ++i)
    if (isUnderPunch(block.model.rest[i])) touched.push_back(static_cast<int>(i));
  const double gain = 20.0 / static_cast<double>(touched.size());      // [N/m] a step; a tenth of the whole stiffness or less
  double sum = 0.0;                            // [N]
  for (int k = 0; k < 700; ++k) {
    sum = 0.0;
    for (int i : touched) {
      block.force[i].z() -= gain * (depth + block.state.position[i].z());
      sum -= block.force[i].z();
    }
    block.run(1);
  }
  for (int i : touched) EXPECT_NEAR(-block.state.position[i].z(), depth, 0.005 * depth);
  return sum / depth;
}

TEST_P(StiffnessPromise, APunchMeetsLinearElasticityOnItsMesh) {
  SimParams p = params();
  p.tissue.massDamping = 300.0;
  const TetMesh mesh = punchBlock({0.0, 1.0, 1.6, 2.7, 5.0, 10.0, 20.0}, false);
  const double exact = staticPunchStiffness(p, mesh, false);           // [N/m]
  TissueBlock block(mesh, p);
  const double measured = settledPunchStiffness(block, 0.01e-3);       // [N/m]
  RecordProperty("stiffness_over_linear_elasticity", std::to_string(measured / exact));
  RecordProperty("mesh_over_half_space", std::to_string(exact / halfSpaceStiffness(p)));
  EXPECT_NEAR(measured / exact, 1.0, GetParam() == TissueSolver::kProjective ? 0.02 : 0.05);
}

TEST(LinearElasticity, PunchStiffnessGoesToTheHalfSpaceAsTheMeshIsRefined) {
  const SimParams p = sceneParams(TissueSolver::kProjective);
  const std::vector<double> coarse = {0.0, 1.0, 1.6, 2.7, 5.0, 10.0, 20.0};   // [1]
  double ratio[2];                             // [1]
  for (int k : {0, 1}) ratio[k] = staticPunchStiffness(p, punchBlock(grades(coarse, k + 1), true), true) / halfSpaceStiffness(p);
  RecordProperty("one_cell_per_half_side", std::to_string(ratio[0]));
  RecordProperty("two_cells_per_half_side", std::to_string(ratio[1]));
  EXPECT_LT(ratio[1], ratio[0]);
  EXPECT_GT(ratio[1], 1.0);                    // linear tets are stiffer than the body they divide
  EXPECT_NEAR(2.0 * ratio[1] - ratio[0], 1.0, 0.10);   // beside a singularity the error falls with the cell size: extrapolate to none
}

}  // namespace
}  // namespace halsted
