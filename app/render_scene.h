#pragma once
/// What never changes in a picture, taken from the scenario and handed to the renderer once. Any thread.
#include "app/scenario.h"
#include "sim/exchange.h"

namespace halsted::app {

RenderScene renderScene(const Scenario&);

}  // namespace halsted::app
