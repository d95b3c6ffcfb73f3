#pragma once
/// The one list of everything in `State` (DESIGN 7.4). Hash, save, load and diff are visitors of this list, so a field added here is
/// hashed, saved, restored and compared. A member added to a struct and forgotten here does not compile: the structured binding in
/// HALSTED_FIELDS must name every member, in the order of its declaration.
///
/// A visitor has one function, `leaf(const FieldPath&, T* data, std::size_t count, int stride)`, called in list order for each run of
/// scalars (double, an integer or bool); `stride` scalars make an element (3 in a Vec3). Vectors call `size(path, length)` first.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/state.h"

namespace halsted {

/// Where the visit stands: a chain of members and indices, formatted only when somebody asks.
class FieldPath {
 public:
  void enter(const char* names, int member) { entries_[depth_++] = {names, member, -1}; }
  void leave() { --depth_; }
  void index(int i) { entries_[depth_ - 1].index = i; }
  /// "strand.holes[3].weight"
  std::string text() const;

 private:
  struct Entry { const char* names = nullptr; int member = 0, index = -1; };   // names: "a, b, c" as written in the list
  std::array<Entry, 8> entries_{};
  int depth_ = 0;
};

/// How many doubles stand in a row in a type that is nothing but scalars; 0 for anything else.
template <class T> inline constexpr int kScalars = std::is_arithmetic_v<T> ? 1 : 0;
template <> inline constexpr int kScalars<Vec3> = 3;
template <> inline constexpr int kScalars<Quat> = 4;

template <class T> struct ArrayTraits { static constexpr bool isArray = false, isVector = false; };
template <class T> struct ArrayTraits<std::vector<T>> { static constexpr bool isArray = true, isVector = true; using Item = T; };
template <class T> struct ArrayTraits<std::span<T>> { static constexpr bool isArray = true, isVector = false; using Item = T; };
template <class T, std::size_t N> struct ArrayTraits<std::array<T, N>> { static constexpr bool isArray = true, isVector = false; using Item = T; };

template <class T> inline constexpr bool kOptional = false;
template <class T> inline constexpr bool kOptional<std::optional<T>> = true;

inline double* scalarData(Vec3& v) { return v.data(); }
inline double* scalarData(Quat& q) { return q.coeffs().data(); }
template <class T> requires std::is_arithmetic_v<T> T* scalarData(T& x) { return &x; }

template <class V> struct FieldWalk {
  V& visitor;
  FieldPath path{};

  template <class... T> void members(const char* names, T&&... field) {
    int member = 0;
    (one(names, member++, field), ...);
  }

 private:
  template <class T> void one(const char* names, int member, T& field) {
    path.enter(names, member);
    value(field);
    path.leave();
  }
  template <class T> void value(T& field) {
    using Array = ArrayTraits<T>;
    if constexpr (kScalars<T> > 0) visitor.leaf(path, scalarData(field), kScalars<T>, kScalars<T>);
    else if constexpr (Array::isArray) array(field);
    else if constexpr (kOptional<T>) part(field);
    else visitMembers(field, *this);
  }
  /// A part that the model has or has not; what is not there leaves no trace.
  template <class T> void part(std::optional<T>& field) {
    if constexpr (requires { visitor.holder(&field, sizeof field); }) visitor.holder(&field, sizeof field);   // for tests
    if (field) value(*field);
  }
  template <class T> void array(T& field) {
    using Item = typename ArrayTraits<T>::Item;
    if constexpr (ArrayTraits<T>::isVector) {
      visitor.size(path, field.size());
      if constexpr (requires { visitor.holder(&field, sizeof field); }) visitor.holder(&field, sizeof field);   // for tests
      if (field.empty()) return;
    }
    if constexpr (kScalars<Item> > 0) {
      static_assert(std::is_same_v<Item, std::remove_pointer_t<decltype(scalarData(field[0]))>> ||
                    sizeof(Item) == kScalars<Item> * sizeof(double), "items must lie in a row without padding");
      visitor.leaf(path, scalarData(field[0]), field.size() * kScalars<Item>, kScalars<Item>);
    } else {
      for (std::size_t i = 0; i < field.size(); ++i) { path.index(static_cast<int>(i)); value(field[i]); }
      path.index(-1);
    }
  }
};

#define HALSTED_FIELDS(Type, ...)                                                     \
  template <class V> void visitMembers(Type& object, V& walk) {                       \
    auto& [__VA_ARGS__] = object;                                                     \
    walk.members(#__VA_ARGS__, __VA_ARGS__);                                          \
  }

HALSTED_FIELDS(Pose, position, orientation)
/// Of heat and what is gone nothing at all where nothing can be cut.
template <class V> void visitMembers(TissueState& object, FieldWalk<V>& walk) {
  auto& [position, velocity, rotation, pressure, rodForce, pairCount, droppedPairs, pairVertex, pairTriangle, pairForce, heat, gone, left, piece] = object;
  walk.members("position, velocity, rotation, pressure, rodForce, pairCount, droppedPairs, pairVertex, pairTriangle, pairForce",
               position, velocity, rotation, pressure, rodForce, pairCount, droppedPairs, pairVertex, pairTriangle, pairForce);
  if (!gone.empty()) walk.members("heat, gone, left, piece", heat, gone, left, piece);
}
HALSTED_FIELDS(CutState, piece, bare, tie, edge, pieces, goneTets)
HALSTED_FIELDS(Hole, tet, weight, coordinate, force, slip, bite, role, entryCosine)
HALSTED_FIELDS(StrandContact, sample, feature, normalForce, force, weight)
/// Of the holes only those that there are; nothing of what comes through walls where thread can be knotted.
template <class V> void visitMembers(StrandState& object, FieldWalk<V>& walk) {
  auto& [position, velocity, tension, needle, needleVelocity, needleSpin, nearVertex, otherVertex, comesThrough, holes, holeCount, contacts, contactCount, bitesBegun] =
      object;
  walk.members("position, velocity, tension, needle, needleVelocity, needleSpin, nearVertex, otherVertex, holeCount, contacts, contactCount, bitesBegun",
               position, velocity, tension, needle, needleVelocity, needleSpin, nearVertex, otherVertex, holeCount, contacts, contactCount, bitesBegun);
  if (!comesThrough.empty()) walk.members("comesThrough", comesThrough);
  if (holeCount < 0 || holeCount > StrandState::kMaxHoles) holeCount = 0;   // read from damaged data
  walk.members("holes", std::span<Hole>(holes.data(), static_cast<std::size_t>(holeCount)));
}
HALSTED_FIELDS(ThreadContact, sample, partner, place, normalForce, friction)
/// Nothing at all in a scene whose thread does not meet itself; otherwise only the contacts there are, for the table is long.
template <class V> void visitMembers(ThreadContactState& object, FieldWalk<V>& walk) {
  auto& [contacts, count, dropped, drag, set, cut] = object;
  if (drag.empty()) return;
  walk.members("count, dropped, drag, set, cut", count, dropped, drag, set, cut);
  if (count < 0 || count > ThreadContactState::kMaxContacts) count = 0;   // read from damaged data
  walk.members("contacts", std::span<ThreadContact>(contacts.data(), static_cast<std::size_t>(count)));
}
template <class V> void visitMembers(KnotState& object, FieldWalk<V>& walk) {
  auto& [watched, complete, throws, turns, sense, crossingsLeft, tail, tip, toolTurns, breaks, cuts] = object;
  if (!watched) return;
  walk.members("complete, throws, turns, sense, crossingsLeft, tail, tip, toolTurns, breaks, cuts", complete, throws, turns, sense, crossingsLeft,
               tail, tip, toolTurns, breaks, cuts);
  if (throws < 0 || throws > KnotState::kMostThrows) throws = 0;   // read from damaged data
}
HALSTED_FIELDS(AssistKnot, placed, locked, tail, tip, apart, drawn, seated, felt, locks, slipped)
HALSTED_FIELDS(TissuePoint, tet, weight)
HALSTED_FIELDS(OverSurface, triangle, weight, height)
HALSTED_FIELDS(TiedStitch, holeCount, hole, force, give, shared, length, tension, tailLeg, tipLeg)
/// Only those that there are.
template <class V> void visitMembers(TiedStitches& object, FieldWalk<V>& walk) {
  auto& [stitch, count, torn] = object;
  walk.members("count, torn", count, torn);
  if (count < 0 || count > TiedStitches::kMost) count = 0;   // read from damaged data
  walk.members("stitch", std::span<TiedStitch>(stitch.data(), static_cast<std::size_t>(count)));
}
HALSTED_FIELDS(ThreadSupply, left, handed, refusal, bitesBefore, fullThicknessBefore, tearsBefore)
HALSTED_FIELDS(TissueGrasp, count, triangle, weight, local, force)
HALSTED_FIELDS(ToolState, device, proxy, lag, jaw, closed, ratchet, force, holdsNeedle, needleCoordinate, needleInTool, needleForce, threadCoordinate,
               threadInTool, threadForce, strandForce, grasp, through, contactCount, contactTriangle, contactWeight,
               contactNormal, contactForce, nearCount, nearTriangle)
HALSTED_FIELDS(InstrumentState, second, refusal)
HALSTED_FIELDS(StandingClamp, hand, second, jaw, held, pose, grasp)
HALSTED_FIELDS(StandingClamps, clamp, count, left, refusal)
HALSTED_FIELDS(ProcedureState, current, heldDone, heldFault, stepStart, finished, faults, inFault, late)
HALSTED_FIELDS(HandMetrics, pathLength, peakForce, forceSum, forceSteps, lastPosition, started)
HALSTED_FIELDS(BiteMetrics, depth, spacing, entryAngle, width)
HALSTED_FIELDS(JoinMetrics, crossings, rimGap, wallGap, inversion, sewnShare, tailDifference)
HALSTED_FIELDS(SeamMetrics, join, wallShare, fullThickness, deepestTip, lastBowel)
HALSTED_FIELDS(Strokes, direction, extreme, lastTurn, count, counted, amplitude, amplitudeSquares, trough, troughSquares, troughs)
HALSTED_FIELDS(NeedlingMetrics, entered, left, entryOffset, angle, deepest, depthError, enteredAt, reachedAt, leftAt, peakForce, peakPull, peakGrasp,
               peakTorque, peakWithdrawal, lifts, twirls, turned, lastTurned)
HALSTED_FIELDS(CutMetrics, share, errorMean, errorWorst, energy, overshoot, time, freeVolume, burnt, freePieces, taken, crumbs, current)
HALSTED_FIELDS(DamageMetrics, forceTime, peakPressure, dose, injured)
HALSTED_FIELDS(MetricsState, hands, bites, biteCount, lastExit, acrossOpening, tears, perforations, damage, peakStretch, peakTension, openingArea, restOpeningArea, seam, assistedKnots,
               cut, needling)
HALSTED_FIELDS(LayerState, phase, crossing, since, normal, rest, now)
HALSTED_FIELDS(ShaftFriction, held, slid, force, drag)
HALSTED_FIELDS(TipCut, reached, force)
HALSTED_FIELDS(Winding, angle, turned, length, torque, grasp)
HALSTED_FIELDS(NeedlingState, step, skinUnit, fingerUnit, contact, outward, entry, axis, layers, depth, pressed, fingerDepth, fingerPlace,
               fingerNormal, needleTurn, friction, cut, winding, inside)
template <class V> void visitMembers(StepWork&, V&) {}   // scratch is not part of the state's value
HALSTED_FIELDS(State, step, random, tissue, strand, threadContacts, knot, assist, stitches, supply, cut, tools, instruments, clamps, procedure, metrics, bruise, needling, work)

#undef HALSTED_FIELDS

/// Calls `visitor` for every scalar of the state, always in the same order.
template <class V> void visitFields(State& state, V& visitor) {
  FieldWalk<V> walk{visitor};
  visitMembers(state, walk);
}

}  // namespace halsted
