#include "app/render_scene.h"

#include <numbers>

#include "sim/needling/needling_scene.h"

namespace halsted::app {
namespace {

JawShape jawsOf(const ToolParams& tool) { return {tool.jawLength, tool.jawRadius, tool.jawAngleDegrees * std::numbers::pi / 180.0}; }

}  // namespace

RenderScene renderScene(const Scenario& scenario) {
  const SimParams& params = scenario.model.params;
  const TetMesh& mesh = scenario.model.mesh;
  RenderScene scene;
  scene.name = scenario.scene.name;
  scene.title = scenario.scene.title;
  scene.tissueRest = mesh.vertices;
  scene.surface = mesh.surface;
  scene.triangleLayer = mesh.triangleLayer;
  scene.surfaceUv = mesh.uv;
  scene.perineum = params.anatomy.layout == "prolapse";
  if (params.gravity.norm() > 0.0) scene.up = -params.gravity.normalized();
  scene.threadNodes = threadNodes(scenario.model);
  scene.threadRadius = params.thread.radius;
  scene.needle = {params.needle.arcLength / params.needle.arcAngle, params.needle.arcAngle, params.needle.wireRadius};
  if (params.anvil.radius > 0.0) scene.rods = {{params.anvil.from, params.anvil.to, params.anvil.radius}};
  for (int hand = 0; hand < kHands; ++hand) {
    scene.tools[hand] = params.tools[hand].kind;
    scene.jaws[hand] = jawsOf(params.tools[hand]);
    scene.secondTools[hand] = params.second[hand].kind;
    scene.secondJaws[hand] = jawsOf(params.second[hand]);
  }
  scene.maxStitches = params.thread.spare;     // the last one keeps its thread
  scene.camera = scenario.scene.camera;
  scene.cutaway = scenario.scene.cutaway;
  describeBody(scenario.model, scene);
  for (const ProcedureStep& step : scenario.model.procedure) {
    scene.instructions.push_back(step.instruction);
    scene.stepIds.push_back(step.id);
    if (step.repeatFrom >= 0 && step.enough.quantity == Quantity::kStitches) scene.stitchesWanted = static_cast<int>(step.enough.min);
  }
  return scene;
}

}  // namespace halsted::app
