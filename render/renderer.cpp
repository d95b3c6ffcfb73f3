#include "render/renderer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/camera.h"
#include "render/context.h"
#include "render/gpu_mesh.h"
#include "render/holes.h"
#include "render/hud_drawing.h"
#include "render/instruments.h"
#include "render/operating_field.h"
#include "render/shaders.h"
#include "render/shadow_map.h"
#include "render/tissue_surface.h"

namespace halsted::render {
namespace {

constexpr std::size_t kTriangleBudget = 42000;           // tuned: what one core draws twice in a third of a frame
constexpr int kShadowSize = 1024, kFieldPicture = 1024;  // texels
constexpr float kThreadTint[3] = {0.22f, 0.085f, 0.40f}; // linear [1]; violet, as dyed braided suture is

Program programOf(const char* vertex, const char* fragment) { return makeProgram(shaderHead() + vertex, shaderHead() + fragment); }

FieldPlace placeOf(const RenderScene& scene) {
  FieldPlace place;
  if (scene.tissueRest.empty()) return place;
  Vec3 low = scene.tissueRest.front(), high = low;       // [m]
  for (const Vec3& p : scene.tissueRest) { low = low.cwiseMin(p); high = high.cwiseMax(p); }
  place.centre = 0.5 * (low + high);
  place.centre.z() = low.z() + 0.2 * (high.z() - low.z());
  place.radius = std::max(0.25 * (high.x() - low.x() + high.y() - low.y()), 5e-3);
  return place;
}

}  // namespace

struct Renderer::Parts {
  int width, height;
  std::unique_ptr<Context> context;
  Program field = programOf(kRigidVertex, kFieldFragment), steel = programOf(kRigidVertex, kSteelFragment);
  Program tissueLook = programOf(kTissueVertex, kTissueFragment), threadLook = programOf(kTubeVertex, kThreadFragment);
  Program needleLook = programOf(kTubeVertex, kNeedleFragment), holeLook = programOf(kHoleVertex, kHoleFragment);
  Program rigidDepth = programOf(kRigidVertex, kDepthFragment), tubeDepth = programOf(kTubeVertex, kDepthFragment);
  ShadowMap shadow{kShadowSize};
  Texture tissueImage, clothImage, reflection, fieldImage;
  GpuMesh ground, rods;
  TissueSurface tissue;
  Tube threadTube;
  GpuMesh thread, needle;
  Holes holes;
  std::array<Instrument, kHands> instruments;
  std::array<std::array<GpuMesh, 2>, kHands> instrumentMeshes;
  Matrix4 lamp, lampTexture;
  double threadRadius;                                    // [m]
  std::size_t particles, threadNodes;
  HudDrawing hud;
  Frame frame;

  Parts(const RenderScene&, int w, int h);
  void drawSolids(const RenderSnapshot&, const Program& rigid) const;
  void drawShadows(const RenderSnapshot&) const;
  void drawPicture(const RenderSnapshot&, const CameraView&) const;
  void use(const Program&, const Matrix4& view, const CameraView&) const;
  bool hasTissue(const RenderSnapshot& s) const { return particles > 0 && s.tissue.size() == particles; }
  bool hasThread(const RenderSnapshot& s) const { return threadNodes >= 2 && s.thread.size() == threadNodes; }
};

Renderer::Parts::Parts(const RenderScene& scene, int w, int h)
    : width(w), height(h), context(createContext(w, h)), tissue(scene, kTriangleBudget), threadTube(makeThread(scene.threadNodes)),
      thread(uploadTube(threadTube)), needle(uploadTube(makeNeedle(scene.needle))), holes(scene.maxPunctures),
      threadRadius(scene.threadRadius), particles(scene.tissueRest.size()),
      threadNodes(static_cast<std::size_t>(std::max(scene.threadNodes, 0))), hud(scene, w, h) {
  const FieldPlace place = placeOf(scene);
  const OperatingField drapes = makeOperatingField(place, kFieldPicture);
  ground = uploadShape(drapes.shape);
  fieldImage = uploadImage(drapes.picture, Tiling::kClamp);
  tissueImage = uploadImage(makeTissueImage(512), Tiling::kRepeat);
  clothImage = uploadImage(makeClothImage(256), Tiling::kRepeat);
  reflection = uploadImage(makeReflectionImage(256), Tiling::kClamp);
  Shape rodShape;
  for (const CapsuleShape& rod : scene.rods) addRod(rodShape, rod);
  rods = uploadShape(rodShape);
  for (int hand = 0; hand < kHands; ++hand) {
    instruments[hand] = makeInstrument(scene.tools[hand]);
    for (int half = 0; half < 2; ++half) instrumentMeshes[hand][half] = uploadShape(instruments[hand].halves[half]);
  }
  const Vec3 middle = 0.5 * (place.centre + Vec3(place.centre.x(), place.centre.y(), 0.0));   // [m] between skin and rim
  lamp = lampProjection(middle, std::max(0.085, 4.0 * place.radius));
  lampTexture = toTexture(lamp);
  frame = {width, height, std::vector<std::uint8_t>(4u * width * height)};
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

/// Instruments and rods with `rigid`, which is in use.
void Renderer::Parts::drawSolids(const RenderSnapshot& snapshot, const Program& rigid) const {
  const auto place = [&](const Pose& pose) { glUniformMatrix4fv(rigid.model, 1, GL_FALSE, matrixOf(pose).data()); };
  for (int hand = 0; hand < kHands; ++hand)
    for (int half = 0; half < 2; ++half) {
      const ToolView& tool = snapshot.tools[hand];
      place(halfPose(instruments[hand], half, tool.jaw, tool.pose));
      instrumentMeshes[hand][half].draw();
    }
  place({});
  rods.draw();
}

void Renderer::Parts::use(const Program& program, const Matrix4& view, const CameraView& camera) const {
  glUseProgram(program.id);
  const Eigen::Vector3f eye = camera.eye.cast<float>();
  const Matrix4 still = Matrix4::Identity();
  glUniformMatrix4fv(program.model, 1, GL_FALSE, still.data());
  glUniformMatrix4fv(program.viewProjection, 1, GL_FALSE, view.data());
  glUniformMatrix4fv(program.shadowMatrix, 1, GL_FALSE, lampTexture.data());
  glUniform3fv(program.eye, 1, eye.data());
  glUniform3fv(program.tint, 1, kThreadTint);
  glUniform1f(program.pixelSize, static_cast<float>(pixelSize(camera, height)));
}

void Renderer::Parts::drawShadows(const RenderSnapshot& snapshot) const {
  CameraView none;
  shadow.begin();
  use(rigidDepth, lamp, none);
  if (hasTissue(snapshot)) tissue.draw();
  drawSolids(snapshot, rigidDepth);
  use(tubeDepth, lamp, none);
  glUniform1f(tubeDepth.pixelSize, 0.0f);
  if (hasThread(snapshot)) thread.draw();
  glUniformMatrix4fv(tubeDepth.model, 1, GL_FALSE, matrixOf(snapshot.needle).data());
  needle.draw();
  shadow.end(width, height);
}

void Renderer::Parts::drawPicture(const RenderSnapshot& snapshot, const CameraView& camera) const {
  const auto bind = [](TextureUnit unit, const Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
  };
  const Matrix4 view = viewProjection(camera, static_cast<double>(width) / height);
  glClearColor(0.03f, 0.07f, 0.08f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  bind(kReflectionUnit, reflection);
  bind(kDetailUnit, clothImage);
  bind(kSurfaceUnit, tissueImage);

  // Near things first: what they hide is not shaded.
  use(steel, view, camera);
  drawSolids(snapshot, steel);
  use(tissueLook, view, camera);
  const double open = std::sqrt(std::clamp(snapshot.openingArea / std::max(tissue.openingAtRest(), 1e-9), 0.0, 1.0));   // [1]
  glUniform1f(tissueLook.open, static_cast<float>(open));
  if (hasTissue(snapshot)) tissue.draw();
  bind(kSurfaceUnit, fieldImage);
  use(field, view, camera);
  ground.draw();

  // Wires fade over their last half pixel, which stands in for multisampling; they need what is behind them.
  glEnable(GL_BLEND);
  use(holeLook, view, camera);
  glDepthMask(GL_FALSE);
  holes.draw();
  glDepthMask(GL_TRUE);
  use(needleLook, view, camera);
  glUniformMatrix4fv(needleLook.model, 1, GL_FALSE, matrixOf(snapshot.needle).data());
  needle.draw();
  use(threadLook, view, camera);
  if (hasThread(snapshot)) thread.draw();
  glDisable(GL_BLEND);
}

Renderer::Renderer(const RenderScene& scene, int width, int height) : parts_(std::make_unique<Parts>(scene, width, height)) {}
Renderer::~Renderer() { parts_->context->makeCurrent(); }

const Frame& Renderer::draw(const RenderSnapshot& snapshot, const HudInput& hud, const CameraView& camera) {
  Parts& p = *parts_;
  p.context->makeCurrent();
  if (p.hasTissue(snapshot)) p.tissue.update(snapshot.tissue);
  if (p.hasThread(snapshot)) {
    updateThread(snapshot.thread, snapshot.twist, p.threadRadius, p.threadTube);
    p.thread.stream(p.threadTube.vertices.data(), p.threadTube.vertices.size() * sizeof(TubeVertex));
  }
  p.holes.update(snapshot.punctures, snapshot.punctureCount, camera.eye, camera.up);
  p.drawShadows(snapshot);
  p.drawPicture(snapshot, camera);
  if (hud.visible) p.hud.draw(snapshot, hud);
  p.context->finish();
  std::copy_n(p.context->pixels(), p.frame.rgba.size(), p.frame.rgba.data());
  return p.frame;
}

}  // namespace halsted::render
