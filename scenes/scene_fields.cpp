#include "scenes/scene_fields.h"

namespace halsted::scenes {
namespace {

using Fields = std::vector<SceneField>;

void addScene(SceneFile& scene, Fields& fields) {
  fields.insert(fields.end(), {
      {"title", &scene.title, 0, 200, "characters"},
      {"technique", &scene.technique, 0, 1000, "characters"},
      {"train_preset", &scene.trainPreset, 0, 100, "characters"},
      {"sim.model", &scene.params.model, 0, 0, ""},
      {"sim.dt", &scene.params.dt, 1e-5, 2e-2, "s"},
      {"sim.gravity", &scene.params.gravity, -100, 100, "m/s^2"},
      {"sim.seed", &scene.params.seed, 0, 9e18, ""},
      {"camera.eye", &scene.camera.eye, -10, 10, "m"},
      {"camera.target", &scene.camera.target, -10, 10, "m"},
      {"camera.up", &scene.camera.up, -1, 1, ""},
      {"camera.fov_degrees", &scene.camera.fovDegrees, 0.2, 120, "deg"},
      {"camera.cutaway", &scene.cutaway, 0, 0, ""},
  });
}

void addTissue(SimParams& params, Fields& fields) {
  TissueParams& tissue = params.tissue;
  ContactParams& contact = params.contact;
  fields.insert(fields.end(), {
      {"tissue.material", MaterialName{&tissue}, 0, 0, ""},
      {"tissue.solver", &tissue.solver, 0, 0, ""},
      {"tissue.youngs_modulus", &tissue.youngsModulus, 100, 1e9, "Pa"},
      {"tissue.poisson_ratio", &tissue.poissonRatio, 0, 0.495, ""},
      {"tissue.stiffening", &tissue.stiffening, 1, 20, ""},
      {"tissue.toe_strain", &tissue.toeStrain, 1e-3, 10, ""},
      {"tissue.density", &tissue.density, 100, 20e3, "kg/m^3"},
      {"tissue.mass_damping", &tissue.massDamping, 0, 1e3, "1/s"},
      {"tissue.substeps", &tissue.substeps, 0, 200, ""},
      {"tissue.resistance", &tissue.resistance, 0, 1, ""},
      {"tissue.shape_iterations", &tissue.shapeIterations, 1, 100, ""},
      {"tissue.perforation_force", &tissue.perforationForce, 0.1, 1e4, "N"},
      {"tissue.bedded", &tissue.bedded, 0, 0, ""},
      {"contact.tool_tissue_friction", &contact.toolTissueFriction, 0, 2, ""},
      {"contact.thread_tissue_friction", &contact.threadTissueFriction, 0, 2, ""},
      {"contact.thread_tool_friction", &contact.threadToolFriction, 0, 2, ""},
  });
}

void addStrand(SimParams& params, Fields& fields) {
  ThreadParams& thread = params.thread;
  NeedleParams& needle = params.needle;
  fields.insert(fields.end(), {
      {"thread.nodes", &thread.nodes, 8, 2000, ""},
      {"thread.segment_length", &thread.segmentLength, 0.2e-3, 20e-3, "m"},
      {"thread.radius", &thread.radius, 0.01e-3, 2e-3, "m"},
      {"thread.linear_density", &thread.linearDensity, 1e-7, 1e-2, "kg/m"},
      {"thread.axial_stiffness", &thread.axialStiffness, 1, 1e5, "N"},
      {"thread.bending_stiffness", &thread.bendingStiffness, 0, 1e-4, "N m^2"},
      {"thread.yield_moment", &thread.yieldMoment, 0, 1e-2, "N m"},
      {"thread.damping", &thread.damping, 0, 1e4, "1/s"},
      {"thread.channel_drag", &thread.channelDrag, 0, 1e4, "N/m"},
      {"thread.knots", &thread.knots, 0, 1, ""},
      {"thread.substeps", &thread.substeps, 1, 20, ""},
      {"thread.fine_from", &thread.fineFrom, 0, 2, "m"},
      {"thread.fine_to", &thread.fineTo, 0, 2, "m"},
      {"thread.fine_segment", &thread.fineSegment, 0, 20e-3, "m"},
      {"thread.friction", &thread.friction, 0, 2, ""},
      {"thread.lateral_modulus", &thread.lateralModulus, 1e6, 1e10, "Pa"},
      {"thread.assist", &thread.assist, 0, 0, ""},
      {"thread.assist_tension", &thread.assistTension, 0.05, 20, "N"},
      {"thread.assist_holding", &thread.assistHolding, 0.1, 100, "N"},
      {"thread.spare", &thread.spare, 0, 60, ""},
      {"thread.breaking_tension", &thread.breakingTension, 0.1, 500, "N"},
      {"needle.arc_length", &needle.arcLength, 3e-3, 0.1, "m"},
      {"needle.arc_angle", &needle.arcAngle, 0.5, 5, "rad"},
      {"needle.wire_radius", &needle.wireRadius, 0.05e-3, 2e-3, "m"},
      {"needle.density", &needle.density, 1000, 25e3, "kg/m^3"},
      {"needle.puncture_force", &needle.punctureForce, 0, 50, "N"},
      {"needle.exit_force", &needle.exitForce, 0, 50, "N"},
      {"needle.cut_force", &needle.cutForce, 0, 50, "N"},
      {"needle.tear_force", &needle.tearForce, 0.01, 500, "N"},
      {"needle.shaft_friction", &needle.shaftFriction, 0, 1e4, "N/m"},
  });
}

void addTool(const std::string& table, ToolParams& tool, Fields& fields) {
  fields.insert(fields.end(), {
      {table + ".kind", &tool.kind, 0, 0, ""},
      {table + ".jaw_length", &tool.jawLength, 1e-3, 0.1, "m"},
      {table + ".jaw_radius", &tool.jawRadius, 0.1e-3, 20e-3, "m"},
      {table + ".shaft_radius", &tool.shaftRadius, 0.1e-3, 20e-3, "m"},
      {table + ".shaft_length", &tool.shaftLength, 5e-3, 1, "m"},
      {table + ".jaw_angle_degrees", &tool.jawAngleDegrees, 1, 120, "deg"},
      {table + ".capture_radius", &tool.captureRadius, 0.1e-3, 20e-3, "m"},
      {table + ".grip_force", &tool.gripForce, 0, 200, "N"},
      {table + ".cutter", &tool.cutter, 0, 1, ""},
      {table + ".coupling_stiffness", &tool.couplingStiffness, 1, 1e5, "N/m"},
      {table + ".hand_force", &tool.handForce, 1, 1e4, "N"},
  });
}

void addCautery(CauteryParams& cautery, Fields& fields) {
  fields.insert(fields.end(), {
      {"cautery.power", &cautery.power, 0, 400, "W"},
      {"cautery.cutting_energy", &cautery.cuttingEnergy, 1e6, 1e11, "J/m^3"},
      {"cautery.tip_radius", &cautery.tipRadius, 0.1e-3, 5e-3, "m"},
      {"cautery.reach", &cautery.reach, 0.05e-3, 10e-3, "m"},
      {"cautery.take_away", &cautery.takeAway, 1e-3, 1, "m"},
      {"cautery.crumb", &cautery.crumb, 0, 1e-6, "m^3"},
  });
}

void addAssistant(AssistantParams& assistant, Fields& fields) { fields.push_back({"assistant.clamps", &assistant.clamps, 0, kMostClamps, ""}); }

void addAnatomy(SimParams& params, Fields& fields) {
  AnatomyParams& anatomy = params.anatomy;
  fields.insert(fields.end(), {
      {"anatomy.mesh", MeshPath{&anatomy.mesh}, 0, 4096, "characters"},
      {"anatomy.scale", &anatomy.scale, 1e-9, 1e3, "m per mesh unit"},
      {"anatomy.segment", &anatomy.segment, 0, 40, "characters"},
      {"anatomy.radius", &anatomy.radius, 2e-3, 0.1, "m"},
      {"anatomy.length", &anatomy.length, 5e-3, 1, "m"},
      {"anatomy.wall", &anatomy.wall, 0.2e-3, 20e-3, "m"},
      {"anatomy.haustra_depth", &anatomy.haustraDepth, 0, 20e-3, "m"},
      {"anatomy.around", &anatomy.around, 8, 256, ""},
      {"anatomy.along", &anatomy.along, 3, 256, ""},
      {"anatomy.layout", &anatomy.layout, 0, 40, "characters"},
      {"anatomy.gap", &anatomy.gap, 1e-3, 0.1, "m"},
      {"anatomy.cut_height", &anatomy.cutHeight, 2e-3, 0.1, "m"},
      {"anatomy.cut_band", &anatomy.cutBand, 1e-3, 20e-3, "m"},
      {"anvil.from", &params.anvil.from, -1, 1, "m"},
      {"anvil.to", &params.anvil.to, -1, 1, "m"},
      {"anvil.radius", &params.anvil.radius, 0, 0.05, "m"},
  });
}

}  // namespace

std::vector<SceneField> sceneFields(SceneFile& scene) {
  Fields fields;
  addScene(scene, fields);
  addTissue(scene.params, fields);
  addStrand(scene.params, fields);
  addTool("tool.left", scene.params.tools[kLeft], fields);
  addTool("tool.right", scene.params.tools[kRight], fields);
  addTool("tool.left.second", scene.params.second[kLeft], fields);
  addTool("tool.right.second", scene.params.second[kRight], fields);
  addCautery(scene.params.cautery, fields);
  addAssistant(scene.params.assistant, fields);
  addAnatomy(scene.params, fields);
  addNeedling(scene, fields);
  return fields;
}

}  // namespace halsted::scenes
