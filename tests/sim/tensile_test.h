#pragma once
/// A tensile tester for what was tied on tissue.
#include <algorithm>

#include "sim/strand/strand.h"
#include "tests/sim/step_rig.h"

namespace halsted {

/// A knot taken out of the tissue with its contacts as they are: the loop is drawn apart at the two places where it went through the
/// tissue, the ends are free.
class TensileTest {
 public:
  struct Result {
    double most = 0.0, gained = 0.0;           // [N] that the loop bore; [m] by which it opened once it was straight
    bool held = false;                         // it stood the wanted force
    bool solved = false;                       // to the end: without this the rest says nothing
    bool slipped() const { return solved && !held; }
    const char* outcome() const { return !solved ? "could not be solved" : held ? "holds" : "slips"; }
  };

  explicit TensileTest(const StepRig& rig)
      : model_(rig.model.strand), strand_(rig.state.strand), contacts_(rig.state.threadContacts), work_(prepareWork(model_)),
        contactWork_(rig.state.work.threadContacts) {
    const Hole* holes[] = {&strand_.holes[0], &strand_.holes[strand_.holeCount - 1]};
    for (int k = 0; k < 2; ++k) {
      jaw_[k].coordinate = holes[k]->coordinate;
      jaw_[k].anchor = strandPoint(model_, strand_, holes[k]->coordinate);
      jaw_[k].stiffness = 2e3 * Mat3::Identity();
    }
    way_ = (jaw_[1].anchor - jaw_[0].anchor).normalized();
    // The thread inside the tissue is cut through: only the knot holds the two sides of the loop together.
    contacts_.cut[threadSpot(model_, 0.5 * (jaw_[0].coordinate + jaw_[1].coordinate)).node] = 1;
  }

  Result load(double force) {                  // [N]
    constexpr double kFast = 0.1, kSpeed = 0.03, kOpened = 6e-3, kLongest = 0.08;   // [m/s], [m/s], [m], [m]
    constexpr int kSteps = 6000;
    Result r;
    const double start = opening();            // [m]
    while (felt_ < kStraight && opening() - start < kLongest)
      if (!draw(kFast)) return r;
    const double straight = opening();         // [m]
    for (int k = 0; k < kSteps && r.gained < kOpened; ++k) {
      if (!draw(std::clamp((force - felt_) / (0.25 * force), -1.0, 1.0) * kSpeed)) return r;
      r.most = std::max(r.most, felt_);
      r.gained = opening() - straight;
    }
    r.solved = true;
    r.held = felt_ > 0.97 * force && r.gained < kOpened;
    return r;
  }

 private:
  static constexpr double kStep = 0.25e-3;     // [s]
  static constexpr double kStraight = 0.1;     // [N] at which the loop has no slack

  /// Moves the jaws apart at a speed; false if the thread could not be solved.
  bool draw(double speed) {                    // [m/s] of each jaw
    for (int side = 0; side < 2; ++side) jaw_[side].anchor += (side ? 1.0 : -1.0) * speed * kStep * way_;
    work_.linkCount = work_.turnCount = 0;
    for (const StrandLink& jaw : jaw_) addLink(work_, jaw);
    contactWork_.solids = {};
    ThreadTouch touch{contacts_, contactWork_};
    if (!solveStrand(model_, kStep, Vec3::Zero(), strand_, work_, &touch)) return false;
    felt_ = std::min(work_.links[0].force.dot(-way_), work_.links[1].force.dot(way_));
    return true;
  }
  double opening() const {                     // [m]
    return (strandPoint(model_, strand_, jaw_[1].coordinate) - strandPoint(model_, strand_, jaw_[0].coordinate)).dot(way_);
  }

  StrandModel model_;
  StrandState strand_;
  ThreadContactState contacts_;
  StrandWork work_;
  ThreadContactWork contactWork_;
  std::array<StrandLink, 2> jaw_;
  Vec3 way_ = Vec3::UnitX();                   // [1]
  double felt_ = 0.0;                          // [N] by both jaws
};

}  // namespace halsted
