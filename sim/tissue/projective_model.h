#pragma once
/// Prefactored projective dynamics (Bouaziz et al. 2014; Kugelstadt et al. 2018): one constant scalar matrix
///   A = M (1/dt^2 + damping/dt) + sum over tets 2 mu V G G^T      [N/m]
/// factored once, the same for x, y and z; unknowns are displacements from rest, zero for fixed particles. physics.md 0.8.
/// Volume is kept by a pressure per tet that relaxes to lambda tr(R^T F - I) (Uzawa), so the static stiffness is exact; both
/// terms of the corotated stress are bounded by the rotation, so an inverted tet cannot blow up.
///
/// A tet that is gone stays in the matrix, with its present deformation as target: no elastic stress and no pressure, but what is left is
/// viscous, a force 2 k mu V G G^T (u_now - u_before) with k the stiffening: across a kerf as if it were filled with a fluid of viscosity
/// 2 k mu dt. At E = 120 kPa and a step of 1 ms that is 83 Pa s, 434 Pa s where the tissue stiffens by 5.25. A piece that has come free
/// would sink through that fluid for ever: between it and the rest the target moves on at the speed of their parting, so that not the
/// parting but a change of it is resisted, as by a mass of that viscosity times dt, area over width of the kerf.
#include <array>
#include <vector>

#include "sim/line_vector.h"
#include "sim/types.h"

namespace halsted {

struct TissueModel;

struct ProjectiveModel {
  static constexpr int kLanes = 4;
  int size = 0;                                // particles
  // L of P A P^T = L D L^T in panels of up to four columns side by side that end in the same rows: a row is loaded once for all.
  struct Panel {
    int first = 0, width = 0;                  // columns
    int rows = 0, row = 0, value = 0;          // count, its own columns first; where these begin in `row` and `value`
    int part = 0;                              // of the tissue: pieces that hang together by no tet do not feel each other
  };
  static constexpr int kMostParts = 8;         // more than these count as one
  std::vector<int> permutation;                // factor index of each particle
  std::vector<Panel> panels;                   // ascending columns
  std::vector<int> row;                        // four times the row of each entry, ascending within a panel
  std::vector<double> value;                   // [1] [row][column of the panel]; of its own columns only what lies below the diagonal counts
  // Columns in an order for the way back, up to four abreast that do not need each other: no addition need wait for the last. Their entries below the
  // diagonal lie as they are used, those of the same place in each column side by side.
  struct Abreast {
    std::array<int, 4> index{-1, -1, -1, -1};  // of the columns, -1 where there is no other
    std::array<int, 4> count{};                // entries of each, the most first
  };
  std::vector<Abreast> backward;
  std::vector<int> backRow;                    // four times the row of each entry
  std::vector<double> backValue;               // [1]
  struct Part { int first = 0, end = 0, entry = 0; };   // of `backward`; where its entries begin
  std::vector<Part> parts;
  std::vector<double> inverseDiagonal;         // [m/N] of D
  std::vector<double> self;                    // [m/N] per particle: the diagonal of `inverse`
  std::vector<double> inverse;                 // [m/N] dense A^-1, row-major: the compliance seen by contacts
  // Tets in groups of four, struct of arrays: [group][entry][lane]; the last group repeats the last tet with zero weight.
  int groups = 0;
  std::vector<int> laneVertex;                 // [group][corner][lane]
  LineVector<double> laneRestInverse;          // [1/m] [group][9][lane], row-major
  LineVector<double> laneVolume;               // [m^3] [group][lane]
  // Gather lists: right-hand side of particle i = sum over its (tet, corner) entries; fixed order, no scatter.
  std::vector<int> cornerStart;                // size + 1
  std::vector<int> corner;                     // offset into the corner forces [group][corner][xyz][lane]: offset of x
  bool wide = false;                           // the CPU has AVX2; the bits are the same without
};

/// Fills `model.projective`; needs masses, fixed flags, rest inverses and volumes. Throws std::invalid_argument if A is singular.
void buildProjective(TissueModel& model);

inline constexpr int kPanelColumns = 4;        // what the kernel keeps in registers

/// Lays out a factor given by columns (strictly lower part, rows ascending): panels, and the order of the way back.
struct FactorColumns {
  std::vector<int> start, row;                 // start: columns + 1
  std::vector<double> value;                   // [1]
};
void layOutFactor(const FactorColumns&, ProjectiveModel&);

/// Compliance between two particles [m/N].
inline double compliance(const ProjectiveModel& p, int i, int j) {
  return p.inverse[static_cast<std::size_t>(i) * static_cast<std::size_t>(p.size) + static_cast<std::size_t>(j)];
}

/// x := A^-1 x for three right-hand sides stored as rows of four doubles (x, y, z, unused), in factor order.
void solveFactor(const ProjectiveModel&, double* rows);

}  // namespace halsted
