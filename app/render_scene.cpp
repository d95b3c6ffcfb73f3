#include "app/render_scene.h"

#include <numbers>

namespace halsted::app {

RenderScene renderScene(const Scenario& scenario) {
  const SimParams& params = scenario.model.params;
  const TetMesh& mesh = scenario.mesh;
  RenderScene scene;
  scene.name = scenario.scene.name;
  scene.title = scenario.scene.title;
  scene.tissueRest = mesh.vertices;
  scene.surface = mesh.surface;
  scene.triangleLayer = mesh.triangleLayer;
  scene.surfaceUv = mesh.uv;
  scene.threadNodes = threadNodes(scenario.model);
  scene.threadRadius = params.thread.radius;
  scene.needle = {params.needle.arcLength / params.needle.arcAngle, params.needle.arcAngle, params.needle.wireRadius};
  if (params.anvil.radius > 0.0) scene.rods = {{params.anvil.from, params.anvil.to, params.anvil.radius}};
  for (int hand = 0; hand < kHands; ++hand) {
    const auto& tool = params.tools[hand];
    scene.tools[hand] = tool.kind;
    scene.jaws[hand] = {tool.jawLength, tool.jawRadius, tool.jawAngleDegrees * std::numbers::pi / 180.0};
  }
  scene.camera = scenario.scene.camera;
  for (const ProcedureStep& step : scenario.model.procedure) {
    scene.instructions.push_back(step.instruction);
    scene.stepIds.push_back(step.id);
  }
  return scene;
}

}  // namespace halsted::app
