#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/acupuncture_tools.h"
#include "render/body_look.h"
#include "render/body_stand.h"
#include "render/body_surface.h"
#include "render/camera.h"
#include "render/canvas.h"
#include "render/magnifier.h"
#include "render/painting.h"
#include "render/shaders.h"
#include "render/shadow_map.h"

namespace halsted::render {
namespace {

constexpr int kShadowSize = 1024;                        // texels
constexpr double kLampRadius = 0.075;                    // [m] round the target: what casts and catches shadows
constexpr double kMarkRadius = 3e-3;                     // [m] of the target's ring: what counts as having found it

Program programOf(const char* vertex, const char* fragment, const char* switches = "") {
  return makeProgram(shaderHead() + vertex, shaderHead() + switches + fragment);
}

void bindTexture(TextureUnit unit, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
}

struct BodyPainting final : Painting {
  BodyPainting(const RenderScene&, const Canvas& picture);
  void draw(const RenderSnapshot&, const CameraView&, bool cutaway) override;

  const Canvas& picture;
  Stand stand;
  std::vector<Vec3> particles;                           // [m] picture space, as they stand
  std::vector<AcupointMark> points;                      // picture space
  int target;
  std::array<ToolKind, kHands> tools;
  double fingerRadius, needleLength, needleWidth;        // [m] of the whole needle: to the end of its loop, half of the loop's breadth
  std::vector<CapsuleShape> casters;                     // picture space
  Vec3 fingerFrom;                                       // [1] the side that the pressing hand comes from
  Program skin = programOf(kRigidVertex, kSkinFragment, kWithShadow), skinBare = programOf(kRigidVertex, kSkinFragment, kWithoutShadow);
  Program shadowLook = programOf(kRigidVertex, kFieldFragment), section = programOf(kRigidVertex, kSectionFragment);
  Program sheetLook = programOf(kRigidVertex, kSheetFragment), steel = programOf(kRigidVertex, kSteelFragment);
  Program shaftLook = programOf(kTubeVertex, kNeedleFragment), handleLook = programOf(kTubeVertex, kHandleFragment);
  Program markLook = programOf(kHoleVertex, kMarkFragment);
  Program rigidDepth = programOf(kRigidVertex, kDepthFragment), tubeDepth = programOf(kTubeVertex, kDepthFragment);
  ShadowMap shadow{kShadowSize};
  Texture bodyImage, reflection;
  BodySurface body;
  GpuMesh sheet, shaft, handle, loop, finger, mark;
  Matrix4 lamp, lampTexture;
  int viewHeight;                                        // pixels of what is being drawn

  void use(const Program&, const Matrix4& view, const CameraView&) const;
  void place(const Program&, const Pose&) const;
  void drawTools(const RenderSnapshot&, const Matrix4& view, const CameraView&) const;
  void drawMarks(const Matrix4& view, const CameraView&, bool cutaway);
  void drawShadows(const RenderSnapshot&) const;
  void drawSkinShadows(const RenderSnapshot&, const Matrix4& view, const CameraView&, bool cutaway);
  void drawMagnified(const RenderSnapshot&, const CameraView&, bool cutaway);
  Pose fingerStand(const RenderSnapshot&, int hand) const;
};

GpuMesh makeMark() {
  GpuMesh mesh{makeArray(), makeBuffer(), {}, 6};
  glBindVertexArray(mesh.array);
  describe(mesh.vertices, 5 * sizeof(float), {{0, 3, 0}, {1, 2, 3 * sizeof(float)}});
  glBufferData(GL_ARRAY_BUFFER, 6 * 5 * sizeof(float), nullptr, GL_STREAM_DRAW);
  return mesh;
}

BodyPainting::BodyPainting(const RenderScene& scene, const Canvas& canvas)
    : picture(canvas), stand(scene), particles(placed(stand, scene.tissueRest)), points(scene.body.points), target(scene.body.target),
      tools(scene.tools), fingerRadius(scene.fingerRadius),
      needleLength(scene.straightNeedle.length + scene.straightNeedle.handleLength + 5.0 * scene.straightNeedle.handleRadius),
      needleWidth(3.0 * scene.straightNeedle.handleRadius), body(scene, particles), sheet(uploadShape(makeSheet(body.lowest()))), shaft(uploadTube(makeShaft(scene.straightNeedle))),
      handle(uploadTube(makeHandle(scene.straightNeedle))), loop(uploadShape(makeHandleLoop(scene.straightNeedle))),
      finger(uploadShape(scene.fingerRadius > 0.0 ? makeFinger(scene.fingerRadius) : Shape{})), mark(makeMark()), viewHeight(canvas.height()) {
  for (AcupointMark& point : points) {
    point.place = stand.place(point.place);
    point.normal = stand.way(point.normal);
  }
  const double side = tools[kLeft] == ToolKind::kFinger ? 1.0 : -1.0;            // [1] the viewer's left is +x
  fingerFrom = Vec3(0.8 * side, 0.6, 0.0);
  bodyImage = uploadImage(makeBodyImage(512), Sampling::kTiles);
  reflection = uploadImage(makeReflectionImage(256), Sampling::kNearest);
  lamp = lampProjection(Vec3(0.0, 0.0, 0.2 * kLampRadius), kLampRadius);
  lampTexture = toTexture(lamp);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
}

void BodyPainting::use(const Program& program, const Matrix4& view, const CameraView& camera) const {
  glUseProgram(program.id);
  const Eigen::Vector3f eye = camera.eye.cast<float>();
  const Matrix4 still = Matrix4::Identity();
  glUniformMatrix4fv(program.model, 1, GL_FALSE, still.data());
  glUniformMatrix4fv(program.viewProjection, 1, GL_FALSE, view.data());
  glUniformMatrix4fv(program.shadowMatrix, 1, GL_FALSE, lampTexture.data());
  glUniform3fv(program.eye, 1, eye.data());
  glUniform1f(program.pixelSize, static_cast<float>(pixelSize(camera, viewHeight)));
}

void BodyPainting::place(const Program& program, const Pose& pose) const {
  glUniformMatrix4fv(program.model, 1, GL_FALSE, matrixOf(pose).data());
}

/// Where the pressing finger is drawn: its pad on the tool's tip, coming from its own hand's side.
Pose BodyPainting::fingerStand(const RenderSnapshot& snapshot, int hand) const {
  const Pose tool = stand.pose(snapshot.tools[hand].pose);
  const Vec3 up = tool.orientation * Vec3::UnitZ();
  return fingerPose({tool.position, up.z() > 0.3 ? up : Vec3(Vec3::UnitZ()), fingerFrom}, fingerRadius);
}

void BodyPainting::drawShadows(const RenderSnapshot& snapshot) const {
  const CameraView none;
  shadow.begin();
  for (int hand = 0; hand < kHands; ++hand) {
    if (tools[hand] == ToolKind::kFinger) {
      use(rigidDepth, lamp, none);
      place(rigidDepth, fingerStand(snapshot, hand));
      finger.draw();
    }
    if (tools[hand] != ToolKind::kAcupunctureNeedle) continue;
    const Pose pose = stand.pose(snapshot.tools[hand].pose);
    use(rigidDepth, lamp, none);
    place(rigidDepth, pose);
    loop.draw();
    use(tubeDepth, lamp, none);
    glUniform1f(tubeDepth.pixelSize, 0.0f);
    place(tubeDepth, pose);
    shaft.draw();
    handle.draw();
  }
  shadow.end();
}

void BodyPainting::drawTools(const RenderSnapshot& snapshot, const Matrix4& view, const CameraView& camera) const {
  for (int hand = 0; hand < kHands; ++hand)
    if (tools[hand] == ToolKind::kFinger) {
      use(skin, view, camera);
      place(skin, fingerStand(snapshot, hand));
      finger.draw();
    }
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  for (int hand = 0; hand < kHands; ++hand) {
    if (tools[hand] != ToolKind::kAcupunctureNeedle) continue;
    const Pose pose = stand.pose(snapshot.tools[hand].pose);
    use(shaftLook, view, camera);
    place(shaftLook, pose);
    shaft.draw();
    use(handleLook, view, camera);
    place(handleLook, pose);
    handle.draw();
    use(steel, view, camera);
    place(steel, pose);
    loop.draw();
  }
  glDisable(GL_BLEND);
}

/// A lookup for every pixel of skin would cost more than all else that is done for it.
void BodyPainting::drawSkinShadows(const RenderSnapshot& snapshot, const Matrix4& view, const CameraView& camera, bool cutaway) {
  constexpr double kSoft = 0.5e-3;                       // [m] what filtering adds to a shadow
  casters.clear();
  for (int hand = 0; hand < kHands; ++hand) {
    const bool isFinger = tools[hand] == ToolKind::kFinger;
    const Pose pose = isFinger ? fingerStand(snapshot, hand) : stand.pose(snapshot.tools[hand].pose);
    const double length = isFinger ? kFingerLength * fingerRadius : needleLength;         // [m]
    if (isFinger || tools[hand] == ToolKind::kAcupunctureNeedle)
      casters.push_back({pose.position, pose.apply(Vec3(0.0, 0.0, length)), kSoft + (isFinger ? 1.25 * fingerRadius : needleWidth)});
  }
  use(shadowLook, view, camera);
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_COLOR, GL_ZERO);
  body.drawShadowed(cutaway, casters);
  glDisable(GL_BLEND);
}

/// Ink follows the skin; what lies in the part that is cut away is not drawn.
void BodyPainting::drawMarks(const Matrix4& view, const CameraView& camera, bool cutaway) {
  static constexpr float kCorner[6][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};   // [1]
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_DEPTH_TEST);
  use(markLook, view, camera);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const AcupointMark& point = points[i];
    const bool isTarget = static_cast<int>(i) == target;
    if ((cutaway && isTarget) || point.normal.dot(camera.eye - point.place) <= 0.0) continue;
    const Vec3 centre(point.place.x(), point.place.y(), body.skinHeight(point.place.x(), point.place.y(), point.place.z()));   // [m]
    const Vec3 side = point.normal.cross(std::abs(point.normal.y()) < 0.9 ? Vec3::UnitY() : Vec3::UnitX()).normalized(), other = point.normal.cross(side);
    float corners[6][5];                                 // [m] [1]
    for (int k = 0; k < 6; ++k) {
      const Vec3 p = centre + kMarkRadius * (kCorner[k][0] * side + kCorner[k][1] * other);   // [m]
      for (int c = 0; c < 3; ++c) corners[k][c] = static_cast<float>(p[c]);
      corners[k][3] = kCorner[k][0];
      corners[k][4] = kCorner[k][1];
    }
    mark.stream(corners, sizeof corners);
    glUniform1f(markLook.open, isTarget ? 1.0f : 0.0f);
    glBindVertexArray(mark.array);
    glDrawArrays(GL_TRIANGLES, 0, 6);
  }
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
}

void BodyPainting::draw(const RenderSnapshot& snapshot, const CameraView& world, bool cutaway) {
  const CameraView camera = stand.view(world);
  const Matrix4 view = viewProjection(camera, static_cast<double>(picture.width()) / picture.height());
  if (snapshot.tissue.size() == particles.size()) {
    for (std::size_t i = 0; i < particles.size(); ++i) particles[i] = stand.place(snapshot.tissue[i]);
    body.update(particles);
  }
  drawShadows(snapshot);
  picture.bind();
  glClearColor(0.055f, 0.068f, 0.070f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  bindTexture(kReflectionUnit, reflection);
  bindTexture(kSurfaceUnit, bodyImage);
  use(skinBare, view, camera);
  body.drawSkin(cutaway);
  drawSkinShadows(snapshot, view, camera, cutaway);
  use(section, view, camera);
  body.drawInside(cutaway);
  use(sheetLook, view, camera);
  sheet.draw();
  drawMarks(view, camera, cutaway);
  drawTools(snapshot, view, camera);
  if (magnified(snapshot)) drawMagnified(snapshot, camera, cutaway);
}

/// The place where the needle meets the skin, from the same eye, in a corner of the picture.
void BodyPainting::drawMagnified(const RenderSnapshot& snapshot, const CameraView& camera, bool cutaway) {
  const Glass glass = magnifier(picture.width(), picture.height());
  const Vec3 middle = stand.place(snapshot.needling.contact);
  const CameraView near{camera.eye, middle, camera.up, 2.0 * std::atan(0.5 * kGlassHeight / (camera.eye - middle).norm()) * 180.0 / std::numbers::pi};
  const Matrix4 view = viewProjection(near, static_cast<double>(glass.width) / glass.height);
  const int fromBottom = picture.height() - glass.y - glass.height;              // pixels
  viewHeight = glass.height;
  glViewport(glass.x, fromBottom, glass.width, glass.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(glass.x, fromBottom, glass.width, glass.height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  bindTexture(kSurfaceUnit, bodyImage);
  use(skin, view, near);
  body.drawSkin(cutaway);
  use(section, view, near);
  body.drawInside(cutaway);
  drawTools(snapshot, view, near);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, picture.width(), picture.height());
  viewHeight = picture.height();
}

}  // namespace

std::unique_ptr<Painting> makeBodyPainting(const RenderScene& scene, const Canvas& picture) {
  return std::make_unique<BodyPainting>(scene, picture);
}

}  // namespace halsted::render
