#pragma once
/// `halsted devices --bench`: force quality in numbers (haptics/bench), the scene's share of them, and jitter on this machine's clock.
#include <string>

#include "app/scenario.h"
#include "haptics/bench/bench.h"

namespace halsted::app {

/// Both hands of a session at random in a scene, as the program sets them up. `progress` hears the simulated time [s].
haptics::bench::Measurements measureSceneEnergy(const Scenario&, double seconds, std::uint64_t seed, const std::function<void(double)>& progress);   // [s]

/// Lateness of the shipped haptic thread beside a bare loop's, on this machine, now. `seconds` of real time.
haptics::bench::Measurements measureJitter(const Scenario&, double seconds);   // [s]

int benchDevices(bool json);

}  // namespace halsted::app
