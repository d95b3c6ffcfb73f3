#include "sim/strand/knot_diagram.h"

#include <algorithm>

namespace halsted {
namespace {

struct Frame { Vec3 right, up, toward; };      // [1] the viewer looks against `toward`

Frame frameOf(const Vec3& direction) {
  const Vec3 w = direction.normalized();
  const Vec3 helper = w.x() * w.x() < 0.5 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
  const Vec3 u = helper.cross(w).normalized();
  return {u, w.cross(u), w};
}

using SeenVisit = KnotReader::Visit;

/// Crossing of two pieces as seen; false when they do not cross.
bool crossPieces(const std::vector<Vec3>& seen, int i, int j, SeenVisit& first, SeenVisit& second, int& sign) {
  const Vec3 a = seen[i + 1] - seen[i], b = seen[j + 1] - seen[j], d = seen[j] - seen[i];
  const double cross = a.x() * b.y() - a.y() * b.x();   // [m^2]
  if (cross == 0.0) return false;
  const double s = (d.x() * b.y() - d.y() * b.x()) / cross, t = (d.x() * a.y() - d.y() * a.x()) / cross;   // [1]
  if (s < 0.0 || s >= 1.0 || t < 0.0 || t >= 1.0) return false;
  const bool firstOver = seen[i].z() + s * a.z() > seen[j].z() + t * b.z();
  first = {i + s, {0, firstOver}};
  second = {j + t, {0, !firstOver}};
  sign = (cross > 0.0) == firstOver ? 1 : -1;
  return true;
}

/// Does the thread come back to the crossing at position i with none between?
bool returnsAtOnce(const KnotDiagram& d, int i) { return i + 1 < static_cast<int>(d.code.size()) && d.code[i].crossing == d.code[i + 1].crossing; }

void takeOut(KnotDiagram& d, int i, int visits) { d.code.erase(d.code.begin() + i, d.code.begin() + i + visits); }

bool loopMove(KnotDiagram& d) {
  for (int i = 0; i + 1 < static_cast<int>(d.code.size()); ++i) {
    if (!returnsAtOnce(d, i)) continue;
    takeOut(d, i, 2);
    return true;
  }
  return false;
}

/// Position of the other visit of the crossing at position i.
int partnerOf(const KnotDiagram& d, int i) {
  for (int j = 0; j < static_cast<int>(d.code.size()); ++j)
    if (j != i && d.code[j].crossing == d.code[i].crossing) return j;
  return -1;
}

bool pairMove(KnotDiagram& d) {
  for (int i = 0; i + 1 < static_cast<int>(d.code.size()); ++i) {
    const CrossingVisit a = d.code[i], b = d.code[i + 1];
    if (a.over != b.over || d.sign[a.crossing] == d.sign[b.crossing]) continue;
    const int p = partnerOf(d, i), q = partnerOf(d, i + 1);
    if (p - q != 1 && q - p != 1) continue;
    const auto goes = [&](const CrossingVisit& v) { return v.crossing == a.crossing || v.crossing == b.crossing; };
    std::erase_if(d.code, goes);
    return true;
  }
  return false;
}

/// Half twists of the throw whose 2 n visits begin at position i; 0 when there is none.
int throwAt(const KnotDiagram& d, int i) {
  for (int n : {3, 5, 7, 9}) {
    if (i + 2 * n > static_cast<int>(d.code.size())) return 0;
    bool fits = true;
    for (int k = 0; k < n && fits; ++k) {
      const CrossingVisit &a = d.code[i + k], &b = d.code[i + n + k];
      fits = a.crossing == b.crossing && d.sign[a.crossing] == d.sign[d.code[i].crossing] && a.over == (d.code[i].over == (k % 2 == 0));
    }
    if (fits) return n;
  }
  return 0;
}

void turn(std::span<const Vec3> curve, const Vec3& direction, std::vector<Vec3>& seen) {   // [m], [1], [m]
  const Frame f = frameOf(direction);
  seen.clear();
  for (const Vec3& x : curve) seen.push_back(Vec3(f.right.dot(x), f.up.dot(x), f.toward.dot(x)));
}

/// All crossings of the pieces as seen; false when there are more than `most`.
bool findCrossings(const std::vector<Vec3>& seen, std::size_t most, std::vector<SeenVisit>& visits, KnotDiagram& d) {
  visits.clear();
  d.sign.clear();
  d.code.clear();
  for (int i = 0; i + 1 < static_cast<int>(seen.size()); ++i)
    for (int j = i + 2; j + 1 < static_cast<int>(seen.size()); ++j) {
      SeenVisit a, b;
      int sign = 0;
      if (!crossPieces(seen, i, j, a, b, sign)) continue;
      if (d.sign.size() == most) return false;
      a.visit.crossing = b.visit.crossing = static_cast<int>(d.sign.size());
      d.sign.push_back(sign);
      visits.push_back(a);
      visits.push_back(b);
    }
  std::sort(visits.begin(), visits.end(), [](const SeenVisit& a, const SeenVisit& b) {
    if (a.along != b.along) return a.along < b.along;
    return a.visit.crossing != b.visit.crossing ? a.visit.crossing < b.visit.crossing : a.visit.over && !b.visit.over;
  });
  return true;
}

// A view in which all crossings belong to throws shows the knot; of these the one with the fewest. Ten directions without symmetry do but
// for one double throw in two hundred, whose diagram keeps a crossing too many: then thirty more.
constexpr int kFirstViews = 10, kViews = 40;
constexpr int kLooks = 3;                      // more, with the corners drawn in before each

Vec3 viewDirection(int n) {                    // [1]
  constexpr double kFirst[kFirstViews][3] = {{0.11, 0.07, 1.0}, {1.0, 0.13, 0.09}, {0.05, 1.0, 0.12}, {1.0, 0.9, 0.17},  {-0.8, 1.0, 0.21},
                                             {0.19, 1.0, 0.8},  {0.23, -1.0, 0.9}, {1.0, 0.15, 0.7}, {-0.9, 0.27, 1.0}, {0.8, 0.9, 1.0}};
  if (n < kFirstViews) return Vec3(kFirst[n][0], kFirst[n][1], kFirst[n][2]);
  const auto spread = [n](double step) { return 2.0 * (n * step - static_cast<int>(n * step)) - 1.0; };
  return Vec3(spread(0.8191725), spread(0.6710436), spread(0.5497005));   // evenly (R3 of Roberts 2018)
}

}  // namespace

KnotDiagram projectThread(std::span<const Vec3> curve, const Vec3& direction) {
  std::vector<Vec3> seen;
  std::vector<SeenVisit> visits;
  KnotDiagram d;
  turn(curve, direction, seen);
  findCrossings(seen, seen.size() * seen.size(), visits, d);
  for (const SeenVisit& v : visits) d.code.push_back(v.visit);
  return d;
}

void reduceDiagram(KnotDiagram& d) {
  while (loopMove(d) || pairMove(d)) {}
}

KnotReading takeThrows(KnotDiagram& d) {
  KnotReading reading;
  int where = -1;                              // position at which the last throw was taken out
  reading.complete = true;
  for (int i = 0; i < static_cast<int>(d.code.size());) {
    if (returnsAtOnce(d, i)) {                 // round throws that are taken out: the ends lay across each other
      takeOut(d, i, 2);
      if (where > i) where = std::max(i, where - 2);
      i = 0;
      continue;
    }
    const int n = throwAt(d, i);
    if (n == 0 || !reading.throws.add({(n - 1) / 2, d.sign[d.code[i].crossing]})) { ++i; continue; }
    // The next throw of the same loop encloses the last: it begins before the place and ends after it.
    if (where >= 0 && !(i < where && where < i + 2 * n)) reading.complete = false;
    takeOut(d, i, 2 * n);
    where = i;
    i = 0;
  }
  reading.crossingsLeft = d.crossings();
  reading.complete = reading.complete && reading.crossingsLeft == 0;
  return reading;
}

KnotReader::KnotReader(int nodes) {
  const int most = 2 * nodes + 2;              // two points of the curve for every node, and both ends led away
  straight_.reserve(most);
  seen_.reserve(most);
  visits_.reserve(2 * kMostCrossings);
  diagram_.code.reserve(2 * kMostCrossings);
  diagram_.sign.reserve(kMostCrossings);
}

bool KnotReader::project(const Vec3& direction) {   // [1]
  turn(straight_, direction, seen_);
  if (!findCrossings(seen_, kMostCrossings, visits_, diagram_)) return false;
  for (const SeenVisit& v : visits_) diagram_.code.push_back(v.visit);
  reduceDiagram(diagram_);
  return true;
}

void KnotReader::lookFrom(int views, KnotReading& best, int& fewest) {
  for (int n = 0; n < views && !(n >= kFirstViews && best.complete); ++n) {
    if (!project(viewDirection(n))) continue;
    const int crossings = diagram_.crossings();
    const KnotReading reading = takeThrows(diagram_);
    const bool better = reading.complete != best.complete ? reading.complete : crossings < fewest;
    if (better) { best = reading; fewest = crossings; }
    if (crossings == 0) return;
  }
}

KnotReading KnotReader::read(std::span<const Vec3> nodes) {
  straighten(nodes);
  KnotReading best;
  best.crossingsLeft = kMostCrossings;
  int fewest = kMostCrossings + 1;
  lookFrom(kViews, best, fewest);
  for (int again = 0; again < kLooks && !best.complete; ++again) {
    drawIn();
    lookFrom(kFirstViews, best, fewest);
  }
  return best;
}

KnotReading readKnot(std::span<const Vec3> nodes) { return KnotReader(static_cast<int>(nodes.size())).read(nodes); }

std::string surgicalNotation(const KnotReading& r) {
  std::string text;
  for (std::size_t k = 0; k < r.throws.size(); ++k) {
    if (k > 0) text += r.throws[k].sign == r.throws[k - 1].sign ? 'x' : '=';
    text += std::to_string(r.throws[k].turns);
  }
  return r.complete ? text : text + "?";
}

std::string knotName(const KnotReading& r) {
  const std::string text = surgicalNotation(r);
  if (text.empty()) return "none";
  if (text == "1") return "half hitch";
  if (text == "1=1") return "square";
  if (text == "1x1") return "granny";
  return text == "2=1=1" ? "surgeon's" : text;
}

}  // namespace halsted
