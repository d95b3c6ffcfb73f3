#pragma once
/// The ten quantities of force quality (devices.md), each a plain function of nothing but its arguments: virtual time, the shipped
/// tick, the virtual Touch. The tenth of them that needs a real clock, jitter, is measured by the program.
#include <array>
#include <cstdint>
#include <functional>

#include "haptics/bench/measurement.h"
#include "haptics/bench/press.h"
#include "sim/model.h"

namespace halsted::haptics::bench {

/// Hears the share of the work that is done [1]; may be empty.
using Heard = std::function<void(double)>;

Measurements measureZWidth(const Heard& heard = {});               // 1
Measurements measureNominalWall();             // 1: what the Touch promises, with everything as shipped
Measurements measurePressEnergy();             // 2: over closed cycles of press and release
Measurements measureContinuity();              // 3
Measurements measureHeldContact();             // 4
Measurements measurePopThrough(int throws, const Heard& heard = {});   // 5
Measurements measureRateInvariance();          // 6
Measurements measureLatency();                 // 7
Measurements measureAccuracy();                // 9
Measurements measureContactFriction();         // 9: of a tool dragged over tissue
Measurements measureFaults();                  // 10
Measurements measureThermal();                 // 10
Measurements measureCouplingLimits();          // the scene asks for more than the device can show

/// 2: both hands stir at random about the opening of a scene for `seconds`, through the tick and the step.
/// Three accounts a device: over the whole time; within each contact, beyond what the simulated tool gave back (so that what the other
/// hand puts in through the tissue is not called created); and within each contact with that. `start` [m] are the tools' poses, `config` the hands' loops as the program sets them up. `progress` hears the simulated time [s].
Measurements measureTwoHands(const Model&, const std::array<Pose, kHands>& start, const HandLoopConfig& config, double seconds,
                             std::uint64_t seed, const std::function<void(double)>& progress);   // [s]

/// The search behind the Z-width, for the law that the bench itself must keep: a bare device shows 2 b / T.
double stiffestQuietWall(const PressPlan&, double upTo);                           // [N/m] -> [N/m]
double mostDampedQuietWall(const PressPlan&, double stiffness, double upTo);       // [N/m] [N s/m] -> [N s/m]

/// Everything but the scene: name and function of each, in the order of the table.
struct Section {
  const char* title;
  std::function<Measurements(const Heard&)> measure;
};
std::vector<Section> sections();

}  // namespace halsted::haptics::bench
