#include "scenes/scene_fields.h"

namespace halsted::scenes {
namespace {

using Fields = std::vector<SceneField>;

void addLayer(const std::string& table, LayerParams& layer, Fields& fields) {
  fields.insert(fields.end(), {
      {table + ".thickness", &layer.thickness, 0.1e-3, 0.2, "m"},
      {table + ".spring_stiffness", &layer.springStiffness, 0.1, 1e5, "N/m"},
      {table + ".spring_length", &layer.springLength, 0.1e-3, 20e-3, "m"},
      {table + ".rings", &layer.rings, 2, 40, ""},
      {table + ".damping", &layer.damping, 0, 1e5, "N s/m^2"},
      {table + ".puncture_force", &layer.punctureForce, 0, 20, "N"},
      {table + ".friction", &layer.friction, 0, 1e4, "N/m"},
      {table + ".cut_force", &layer.cutForce, 0, 10, "N"},
  });
}

void addNeedle(NeedlingParams& p, Fields& fields) {
  fields.insert(fields.end(), {
      {"needling.profile", &p.profile, 0, 0, ""},
      {"needling.cone_slope", &p.coneSlope, 1e-3, 10, ""},
      {"needling.needle_radius", &p.needleRadius, 0.05e-3, 1e-3, "m"},
      {"needling.needle_length", &p.needleLength, 5e-3, 0.2, "m"},
      {"needling.handle_length", &p.handleLength, 1e-3, 0.1, "m"},
      {"needling.handle_radius", &p.handleRadius, 0.1e-3, 5e-3, "m"},
      {"needling.springback_time", &p.springbackTime, 1e-3, 10, "s"},
      {"needling.shaft_stiffness", &p.shaftStiffness, 1, 1e4, "N/m"},
      {"needling.static_ratio", &p.staticRatio, 1, 10, ""},
      {"needling.weakening", &p.weakening, 1e-6, 0.1, "m"},
      {"needling.still_speed", &p.stillSpeed, 1e-6, 0.1, "m/s"},
      {"needling.tip_stiffness", &p.tipStiffness, 1, 1e5, "N/m"},
      {"needling.side_stiffness", &p.sideStiffness, 0, 1e6, "N/m^2"},
      {"needling.surface_grip", &p.surfaceGrip, 0, 5, ""},
  });
}

void addGrasp(NeedlingParams& p, Fields& fields) {
  fields.insert(fields.end(), {
      {"needling.wind_linear", &p.windLinear, 1e-9, 1, "N m"},
      {"needling.wind_cubic", &p.windCubic, 0, 1, "N m"},
      {"needling.wind_length", &p.windLength, 1e-3, 1, "m"},
      {"needling.wind_damping", &p.windDamping, 0, 1, "N m s/rad"},
      {"needling.wind_limit", &p.windLimit, 1e-9, 1, "N m"},
      {"needling.grasp_most", &p.graspMost, 1, 100, ""},
      {"needling.grasp_wind", &p.graspWind, 0, 10, "1/rad"},
      {"needling.grasp_unwind", &p.graspUnwind, 0, 10, "1/rad"},
      {"needling.grasp_time", &p.graspTime, 0.1, 1e5, "s"},
      {"needling.lift_least", &p.liftLeast, 0.1e-3, 0.1, "m"},
      {"needling.lift_most", &p.liftMost, 0.1e-3, 0.1, "m"},
      {"needling.twirl_least", &p.twirlLeast, 0.01, 100, "rad"},
      {"needling.twirl_most", &p.twirlMost, 0.01, 100, "rad"},
      {"needling.finger_radius", &p.fingerRadius, 1e-3, 30e-3, "m"},
      {"needling.finger_stiffness", &p.fingerStiffness, 1, 2e3, "N/m"},
  });
}

}  // namespace

void addNeedling(SceneFile& scene, Fields& fields) {
  NeedlingParams& needling = scene.params.needling;
  AnatomyParams& anatomy = scene.params.anatomy;
  addNeedle(needling, fields);
  addGrasp(needling, fields);
  addLayer("needling.skin", needling.layers[0], fields);
  addLayer("needling.fat", needling.layers[1], fields);
  addLayer("needling.muscle", needling.layers[2], fields);
  fields.insert(fields.end(), {
      {"anatomy.body", &anatomy.body, 0, 40, "characters"},
      {"anatomy.point", &anatomy.point, 0, 40, "characters"},
      {"anatomy.order", &anatomy.order, 1, 64, ""},
      {"anatomy.layers_from", MeshPath{&anatomy.layersFrom}, 0, 4096, "characters"},
      {"anatomy.layers_angle_degrees", &anatomy.layersAngle, -180, 180, "deg"},
  });
}

}  // namespace halsted::scenes
