#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/camera.h"
#include "render/canvas.h"
#include "render/discs.h"
#include "render/gpu_mesh.h"
#include "render/instruments.h"
#include "render/operating_field.h"
#include "render/painting.h"
#include "render/program.h"
#include "render/shaders.h"
#include "render/shadow_cells.h"
#include "render/shadow_map.h"
#include "render/smoke.h"
#include "render/tissue_surface.h"

namespace halsted::render {
namespace {

constexpr std::size_t kTriangleBudget = 16000;           // tuned: twice as many cost 3 ms a frame and show no finer outline
constexpr std::size_t kPerineumBudget = 24000;            // one subdivision of a prolapse, which fills the picture
constexpr int kShadowSize = 1024;                        // texels
constexpr double kHoleRadius = 0.62e-3;                  // [m] a 0.66 mm needle leaves a hole with a bruised edge
constexpr double kHoleLift = 0.45e-3;                    // [m] toward the eye, so that the drawn wall does not hide it
constexpr float kThreadTint[3] = {0.22f, 0.085f, 0.40f}; // linear [1]; violet, as dyed braided suture is

FieldPlace placeOf(const RenderScene& scene) {
  FieldPlace place;
  if (scene.tissueRest.empty()) return place;
  Vec3 low = scene.tissueRest.front(), high = low;       // [m]
  for (const Vec3& p : scene.tissueRest) { low = low.cwiseMin(p); high = high.cwiseMax(p); }
  place.centre = 0.5 * (low + high);
  place.perineum = scene.perineum;
  place.centre.z() = low.z() + (scene.perineum ? 0.0 : 0.2 * (high.z() - low.z()));
  place.radius = std::max(0.25 * (high.x() - low.x() + high.y() - low.y()), 5e-3);
  return place;
}

struct DrawnInstrument {
  Instrument shape;
  std::array<GpuMesh, 2> mesh;                            // of its halves
  std::array<std::vector<Vec3>, 2> shadow;                // [m]
};

DrawnInstrument drawnInstrument(ToolKind kind, const JawShape& jaws) {
  DrawnInstrument out;
  if (kind == ToolKind::kNone) return out;
  out.shape = makeInstrument(kind, jaws);
  for (int half = 0; half < 2; ++half) {
    out.mesh[half] = uploadShape(out.shape.halves[half]);
    out.shadow[half] = shadowTriangles(out.shape.halves[half]);
  }
  return out;
}

struct SuturePainting final : Painting {
  SuturePainting(const RenderScene&, const Canvas& picture);
  void draw(const RenderSnapshot&, const CameraView&, bool cutaway) override;

  const Canvas& picture;
  Canvas backdrop;                                        // backdrop: the field without shadows, as `backdropView` sees it
  CameraView backdropView;
  bool backdropDrawn = false;
  std::unique_ptr<ShadowCells> shadowCells;
  std::vector<std::array<int, 3>> casters;                // triangles of particles
  std::vector<CapsuleShape> rodsAsLines;
  double needleReach;                                     // [m] from the middle of its arc
  Buffer shadowIndices;
  Program field = programOf(kRigidVertex, kFieldFragment), fieldBare = programOf(kRigidVertex, kFieldBareFragment);
  Program steel = programOf(kRigidVertex, kSteelFragment);
  Program tissueLook = programOf(kTissueVertex, kTissueFragment), threadLook = programOf(kTubeVertex, kThreadFragment);
  Program needleLook = programOf(kTubeVertex, kNeedleFragment), holeLook = programOf(kHoleVertex, kHoleFragment);
  Program smokeLook = programOf(kSmokeVertex, kSmokeFragment);
  Program rigidDepth = programOf(kRigidVertex, kDepthFragment), instrumentDepth = programOf(kInstrumentDepthVertex, kDepthFragment);
  Program tubeDepth = programOf(kTubeVertex, kDepthFragment);
  ShadowMap shadow{kShadowSize};
  Texture tissueImage, reflection, fieldImage;
  GpuMesh ground, rods;
  TissueSurface tissue;
  Tube threadTube;
  GpuMesh thread, needle;
  GpuIndices threadShadow;
  Tube stitchTube = makeThread(kStitchPoints);
  std::vector<GpuMesh> stitches;
  int stitchesDrawn = 0;
  Discs holes, smoke;
  std::array<std::array<DrawnInstrument, 2>, kHands> instruments;   // of each hand the first and the second
  Matrix4 lamp;
  double lampDepth;                                       // [m] that the shadow map covers
  double threadRadius;                                    // [m]
  Vec3 up;                                                // [1] against gravity
  std::size_t particles, threadNodes;
  /// Calls `draw` for each half of each instrument: in the hands, then in the assistant's.
  template <class Draw> void eachInstrument(const RenderSnapshot& s, Draw draw) const {
    const auto both = [&](int hand, const ToolView& tool) {
      const DrawnInstrument& instrument = instruments[hand][tool.second ? 1 : 0];
      for (int half = 0; half < 2; ++half) draw(instrument, half, halfPose(instrument.shape, half, tool.jaw, tool.pose));
    };
    for (int hand = 0; hand < kHands; ++hand) both(hand, s.tools[hand]);
    for (int k = 0; k < s.clampCount; ++k) both(s.clamps[k].hand, s.clamps[k].tool);
  }
  void drawInstruments(const RenderSnapshot&, const Program&) const;
  void drawShadows(const RenderSnapshot&) const;
  void layHoles(const RenderSnapshot&, const CameraView&);
  void layStitches(const RenderSnapshot&);
  void drawBackdrop(const CameraView&, const View&);
  void markShadows(const RenderSnapshot&);
  void drawFieldShadows(const RenderSnapshot&, const View&);
  void drawWires(const RenderSnapshot&, const View&) const;
  void drawSmoke(const View&) const;
  void drawPicture(const RenderSnapshot&, const CameraView&);
  bool hasTissue(const RenderSnapshot& s) const { return particles > 0 && s.tissue.size() == particles; }
  bool hasThread(const RenderSnapshot& s) const { return threadNodes >= 2 && s.thread.size() == threadNodes && !s.threadOnTable; }
};

SuturePainting::SuturePainting(const RenderScene& scene, const Canvas& canvas)
    : picture(canvas), backdrop(canvas.width(), canvas.height()), casters(scene.surface.begin(), scene.surface.begin() + static_cast<std::ptrdiff_t>(boundaryTriangles(scene))), rodsAsLines(scene.rods),
      needleReach(scene.needle.radius + scene.needle.wireRadius), tissue(scene, scene.perineum ? kPerineumBudget : kTriangleBudget), threadTube(makeThread(scene.threadNodes)),
      thread(uploadTube(threadTube)), needle(uploadTube(makeNeedle(scene.needle))),
      threadShadow(uploadOtherIndices(threadShadowIndices(scene.threadNodes))), holes(kMostPunctures), smoke(kHands * kPuffs),
      threadRadius(scene.threadRadius), up(scene.up), particles(scene.tissueRest.size()),
      threadNodes(static_cast<std::size_t>(std::max(scene.threadNodes, 0))) {
  for (int k = 0; k < scene.maxStitches; ++k) stitches.push_back(uploadTube(stitchTube));
  const FieldPlace wound = placeOf(scene);
  const OperatingField drapes = makeOperatingField(wound, std::clamp(2 * canvas.height(), 256, 1536));
  ground = uploadShape(drapes.shape);
  shadowCells = std::make_unique<ShadowCells>(drapes.shape);
  shadowIndices = makeIndexRoom(drapes.shape.indices.size());
  fieldImage = uploadImage(drapes.picture, Sampling::kOneLevel);
  tissueImage = uploadImage(makeTissueImage(512), Sampling::kTiles);
  reflection = uploadImage(makeReflectionImage(256), Sampling::kNearest);
  Shape rodShape;
  for (const CapsuleShape& rod : scene.rods) addRod(rodShape, rod);
  rods = uploadShape(rodShape);
  for (int hand = 0; hand < kHands; ++hand) {
    instruments[hand][0] = drawnInstrument(scene.tools[hand], scene.jaws[hand]);
    instruments[hand][1] = drawnInstrument(scene.secondTools[hand], scene.secondJaws[hand]);
  }
  const Vec3 middle = 0.5 * (wound.centre + Vec3(wound.centre.x(), wound.centre.y(), 0.0));   // [m] between skin and rim
  const double lampRadius = std::max(0.085, 4.0 * wound.radius);   // [m]
  lampDepth = 4.0 * lampRadius;
  lamp = lampProjection(middle, lampRadius);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);                                 // shadows are drawn over the backdrop at the same depth
  glEnable(GL_CULL_FACE);
}

void SuturePainting::drawInstruments(const RenderSnapshot& snapshot, const Program& program) const {
  eachInstrument(snapshot, [&](const DrawnInstrument& instrument, int half, const Pose& stand) {
    place(program, stand);
    instrument.mesh[half].draw();
  });
}

void SuturePainting::layHoles(const RenderSnapshot& snapshot, const CameraView& camera) {
  const int count = std::min(snapshot.punctureCount, static_cast<int>(snapshot.punctures.size()));
  holes.clear();
  for (int i = 0; i < count; ++i) {
    DiscPlace place = facing(camera, snapshot.punctures[i]);
    place.centre += kHoleLift * (camera.eye - place.centre).normalized();
    holes.add(place, kHoleRadius);
  }
}

void SuturePainting::layStitches(const RenderSnapshot& snapshot) {
  stitchesDrawn = std::min(snapshot.stitchCount, static_cast<int>(stitches.size()));
  for (int k = 0; k < stitchesDrawn; ++k) {
    updateTiedThread({snapshot.stitches.data() + k * kStitchPoints, kStitchPoints}, kStitchKnots, threadRadius, stitchTube);
    stitches[static_cast<std::size_t>(k)].stream(stitchTube.vertices.data(), stitchTube.vertices.size() * sizeof(TubeVertex));
  }
}

void SuturePainting::drawShadows(const RenderSnapshot& snapshot) const {
  const View view = lampView(lamp);
  shadow.begin();
  use(rigidDepth, view);
  if (hasTissue(snapshot)) {
    shadow.setBack(0.35e-3 / lampDepth);                              // [m] the drawn wall is that much finer than what casts its shadow
    tissue.drawCoarse();
    shadow.setBack(0.0);
  }
  rods.draw();
  use(instrumentDepth, view);
  drawInstruments(snapshot, instrumentDepth);
  use(tubeDepth, view);
  if (hasThread(snapshot)) thread.drawAs(threadShadow);
  place(tubeDepth, snapshot.needle);
  if (!snapshot.threadOnTable) needle.draw();
  shadow.end();
}

bool sameView(const CameraView& a, const CameraView& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fovDegrees == b.fovDegrees;
}

/// Only when the eye has moved: the field fills the frame, and shading it afresh would take half of the frame's time.
void SuturePainting::drawBackdrop(const CameraView& camera, const View& view) {
  if (backdropDrawn && sameView(camera, backdropView)) return;
  backdrop.bind();
  glClearColor(0.02f, 0.01f, 0.01f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  bindTexture(kSurfaceUnit, fieldImage);
  use(fieldBare, view);
  ground.draw();
  backdropView = camera;
  backdropDrawn = true;
}

void SuturePainting::markShadows(const RenderSnapshot& snapshot) {
  shadowCells->clear();
  if (hasTissue(snapshot))
    for (const auto& t : casters) shadowCells->add(snapshot.tissue[t[0]], snapshot.tissue[t[1]], snapshot.tissue[t[2]]);
  if (hasThread(snapshot))
    for (std::size_t i = 1; i < threadNodes; ++i) shadowCells->add(snapshot.thread[i - 1], snapshot.thread[i], snapshot.thread[i]);
  if (!snapshot.threadOnTable) shadowCells->add(snapshot.needle.position, needleReach);
  for (const CapsuleShape& rod : rodsAsLines)
    for (double t = 0.0; t <= 1.0; t += 0.05) shadowCells->add(rod.a + t * (rod.b - rod.a), 1.5 * rod.radius);
  eachInstrument(snapshot, [&](const DrawnInstrument& instrument, int half, const Pose& stand) {
    const Matrix4 matrix = matrixOf(stand);
    shadowCells->add(instrument.shadow[half], matrix.cast<double>());
  });
}

void SuturePainting::drawFieldShadows(const RenderSnapshot& snapshot, const View& view) {
  markShadows(snapshot);
  use(field, view);
  const Blending darken(Blending::kDarken);
  ground.drawOnly(shadowCells->indices(), shadowIndices);
}

/// Wires fade over their last half pixel, which stands in for multisampling; they need what is behind them.
void SuturePainting::drawWires(const RenderSnapshot& snapshot, const View& view) const {
  const Blending over(Blending::kOver);
  use(holeLook, view);
  glDepthMask(GL_FALSE);
  holes.draw();
  glDepthMask(GL_TRUE);
  use(needleLook, view);
  place(needleLook, snapshot.needle);
  if (!snapshot.threadOnTable) needle.draw();
  use(threadLook, view);
  glUniform3fv(threadLook.tint, 1, kThreadTint);
  if (hasThread(snapshot)) thread.draw();
  for (int k = 0; k < stitchesDrawn; ++k) stitches[static_cast<std::size_t>(k)].draw();
}

void SuturePainting::drawSmoke(const View& view) const {
  const Blending over(Blending::kOver);
  use(smokeLook, view);
  glDepthMask(GL_FALSE);
  smoke.draw();
  glDepthMask(GL_TRUE);
}

void SuturePainting::drawPicture(const RenderSnapshot& snapshot, const CameraView& camera) {
  const View view = eyeView(camera, picture.width(), picture.height(), lamp);
  bindTexture(kReflectionUnit, reflection);
  drawBackdrop(camera, view);
  picture.copyFrom(backdrop);
  picture.bind();

  // Near things first: what they hide is not shaded.
  use(steel, view);
  rods.draw();
  drawInstruments(snapshot, steel);
  bindTexture(kSurfaceUnit, tissueImage);
  use(tissueLook, view);
  const double open = std::sqrt(std::clamp(snapshot.openingArea / std::max(tissue.openingAtRest(), 1e-9), 0.0, 1.0));   // [1]
  glUniform1f(tissueLook.open, static_cast<float>(open));
  if (hasTissue(snapshot)) tissue.draw();
  drawFieldShadows(snapshot, view);
  drawWires(snapshot, view);
  drawSmoke(view);
}

void SuturePainting::draw(const RenderSnapshot& snapshot, const CameraView& camera, bool) {
  if (hasTissue(snapshot)) tissue.update(snapshot);
  if (hasThread(snapshot)) {
    updateThread(snapshot.thread, snapshot.twist, threadRadius, threadTube);
    thread.stream(threadTube.vertices.data(), threadTube.vertices.size() * sizeof(TubeVertex));
  }
  layHoles(snapshot, camera);
  laySmoke(snapshot, up, camera, smoke);
  layStitches(snapshot);
  drawShadows(snapshot);
  drawPicture(snapshot, camera);
}

}  // namespace

std::unique_ptr<Painting> makeSuturePainting(const RenderScene& scene, const Canvas& picture) {
  return std::make_unique<SuturePainting>(scene, picture);
}

}  // namespace halsted::render
