#pragma once
/// Which faults of the procedure began, and when: the state only counts them. Filled after every step without heap; read when the run is over.
#include <array>
#include <string>
#include <vector>

#include "sim/model.h"
#include "sim/step.h"

namespace halsted::app {

/// For people and for `--json`.
struct FaultLine {
  int row = 0;                                 // of the procedure
  std::string name;                            // as the scene names it, or that the step took too long
  double time = 0.0;                           // [s] from the start of the run
};

class FaultLog {
 public:
  static constexpr int kMost = 256;            // later ones are counted by the state alone

  void add(const StepOutput&, double dt);      // after every step; dt [s]
  std::vector<FaultLine> lines(const Model&) const;

 private:
  struct Begun { int row = 0; EventKind kind = EventKind::kFault; double time = 0.0; };   // [s]
  std::array<Begun, kMost> begun_{};
  int count_ = 0;
};

}  // namespace halsted::app
