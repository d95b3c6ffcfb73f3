#include "sim/strand/thread_contact_search.h"

#include <algorithm>

namespace halsted {

void boundPieces(const StrandModel& m, const StrandState& s, ThreadContactWork& w) {
  const int pieces = m.nodes - 2;
  double fastest = 0.0;                        // [m^2/s^2]
  for (const Vec3& v : s.velocity) fastest = std::max(fastest, v.squaredNorm());
  w.fastest = std::sqrt(fastest);
  for (int p = 0; p < pieces; ++p) {
    // A piece lies in the triangle of its two ends and its middle node.
    const Vec3 centre = curvePoint(s.position, curveWeights(p, 0.5));
    const double a = (0.5 * (s.position[p] + s.position[p + 1]) - centre).squaredNorm();       // [m^2]
    const double b = (0.5 * (s.position[p + 1] + s.position[p + 2]) - centre).squaredNorm();   // [m^2]
    const double c = (s.position[p + 1] - centre).squaredNorm();                               // [m^2]
    w.pieceCentre[p] = centre;
    w.pieceRadius[p] = std::sqrt(std::max(a, std::max(b, c)));
  }
  for (std::size_t chunk = 0; chunk < w.chunkCentre.size(); ++chunk) {
    const int begin = static_cast<int>(chunk) * kChunk, end = std::min(pieces, begin + kChunk);
    const Vec3 centre = w.pieceCentre[(begin + end) / 2];
    double radius = 0.0;                       // [m]
    for (int p = begin; p < end; ++p) radius = std::max(radius, (w.pieceCentre[p] - centre).norm() + w.pieceRadius[p]);
    w.chunkCentre[chunk] = centre;
    w.chunkRadius[chunk] = radius;
  }
}

}  // namespace halsted
