#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/acupuncture_tools.h"
#include "render/body_look.h"
#include "render/body_stand.h"
#include "render/body_surface.h"
#include "render/camera.h"
#include "render/canvas.h"
#include "render/discs.h"
#include "render/magnifier.h"
#include "render/painting.h"
#include "render/program.h"
#include "render/shaders.h"
#include "render/shadow_map.h"

namespace halsted::render {
namespace {

constexpr int kShadowSize = 1024;                        // texels
constexpr double kLampRadius = 0.075;                    // [m] round the target: what casts and catches shadows
constexpr double kMarkRadius = 3e-3;                     // [m] of the target's ring: what counts as having found it

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
  GpuMesh sheet, shaft, handle, loop, finger;
  Discs mark{1};
  Matrix4 lamp;

  void drawTools(const RenderSnapshot&, const View&) const;
  void drawMarks(const View&, bool cutaway);
  void drawShadows(const RenderSnapshot&) const;
  void drawSkinShadows(const RenderSnapshot&, const View&, bool cutaway);
  void drawMagnified(const RenderSnapshot&, const CameraView&, bool cutaway);
  Pose fingerStand(const RenderSnapshot&, int hand) const;
};

BodyPainting::BodyPainting(const RenderScene& scene, const Canvas& canvas)
    : picture(canvas), stand(scene), particles(placed(stand, scene.tissueRest)), points(scene.body.points), target(scene.body.target),
      tools(scene.tools), fingerRadius(scene.fingerRadius),
      needleLength(scene.straightNeedle.length + scene.straightNeedle.handleLength + 5.0 * scene.straightNeedle.handleRadius),
      needleWidth(3.0 * scene.straightNeedle.handleRadius), body(scene, particles), sheet(uploadShape(makeSheet(body.lowest()))), shaft(uploadTube(makeShaft(scene.straightNeedle))),
      handle(uploadTube(makeHandle(scene.straightNeedle))), loop(uploadShape(makeHandleLoop(scene.straightNeedle))),
      finger(uploadShape(scene.fingerRadius > 0.0 ? makeFinger(scene.fingerRadius) : Shape{})) {
  for (AcupointMark& point : points) {
    point.place = stand.place(point.place);
    point.normal = stand.way(point.normal);
  }
  const double side = tools[kLeft] == ToolKind::kFinger ? 1.0 : -1.0;            // [1] the viewer's left is +x
  fingerFrom = Vec3(0.8 * side, 0.6, 0.0);
  bodyImage = uploadImage(makeBodyImage(512), Sampling::kTiles);
  reflection = uploadImage(makeReflectionImage(256), Sampling::kNearest);
  lamp = lampProjection(Vec3(0.0, 0.0, 0.2 * kLampRadius), kLampRadius);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
}

/// Where the pressing finger is drawn: its pad on the tool's tip, coming from its own hand's side.
Pose BodyPainting::fingerStand(const RenderSnapshot& snapshot, int hand) const {
  const Pose tool = stand.pose(snapshot.tools[hand].pose);
  const Vec3 up = tool.orientation * Vec3::UnitZ();
  return fingerPose({tool.position, up.z() > 0.3 ? up : Vec3(Vec3::UnitZ()), fingerFrom}, fingerRadius);
}

void BodyPainting::drawShadows(const RenderSnapshot& snapshot) const {
  const View view = lampView(lamp);
  shadow.begin();
  for (int hand = 0; hand < kHands; ++hand) {
    if (tools[hand] == ToolKind::kFinger) {
      use(rigidDepth, view);
      place(rigidDepth, fingerStand(snapshot, hand));
      finger.draw();
    }
    if (tools[hand] != ToolKind::kAcupunctureNeedle) continue;
    const Pose pose = stand.pose(snapshot.tools[hand].pose);
    use(rigidDepth, view);
    place(rigidDepth, pose);
    loop.draw();
    use(tubeDepth, view);
    place(tubeDepth, pose);
    shaft.draw();
    handle.draw();
  }
  shadow.end();
}

void BodyPainting::drawTools(const RenderSnapshot& snapshot, const View& view) const {
  for (int hand = 0; hand < kHands; ++hand)
    if (tools[hand] == ToolKind::kFinger) {
      use(skin, view);
      place(skin, fingerStand(snapshot, hand));
      finger.draw();
    }
  const Blending over(Blending::kOver);
  for (int hand = 0; hand < kHands; ++hand) {
    if (tools[hand] != ToolKind::kAcupunctureNeedle) continue;
    const Pose pose = stand.pose(snapshot.tools[hand].pose);
    use(shaftLook, view);
    place(shaftLook, pose);
    shaft.draw();
    use(handleLook, view);
    place(handleLook, pose);
    handle.draw();
    use(steel, view);
    place(steel, pose);
    loop.draw();
  }
}

/// A lookup for every pixel of skin would cost more than all else that is done for it.
void BodyPainting::drawSkinShadows(const RenderSnapshot& snapshot, const View& view, bool cutaway) {
  constexpr double kSoft = 0.5e-3;                       // [m] what filtering adds to a shadow
  casters.clear();
  for (int hand = 0; hand < kHands; ++hand) {
    const bool isFinger = tools[hand] == ToolKind::kFinger;
    const Pose pose = isFinger ? fingerStand(snapshot, hand) : stand.pose(snapshot.tools[hand].pose);
    const double length = isFinger ? kFingerLength * fingerRadius : needleLength;         // [m]
    if (isFinger || tools[hand] == ToolKind::kAcupunctureNeedle)
      casters.push_back({pose.position, pose.apply(Vec3(0.0, 0.0, length)), kSoft + (isFinger ? 1.25 * fingerRadius : needleWidth)});
  }
  use(shadowLook, view);
  const Blending darken(Blending::kDarken);
  body.drawShadowed(cutaway, casters);
}

/// Ink follows the skin; what lies in the part that is cut away is not drawn.
void BodyPainting::drawMarks(const View& view, bool cutaway) {
  const Blending over(Blending::kOver);
  glDisable(GL_DEPTH_TEST);
  use(markLook, view);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const AcupointMark& point = points[i];
    const bool isTarget = static_cast<int>(i) == target;
    if ((cutaway && isTarget) || point.normal.dot(view.eye - point.place) <= 0.0) continue;
    const Vec3 centre(point.place.x(), point.place.y(), body.skinHeight(point.place.x(), point.place.y(), point.place.z()));   // [m]
    const Vec3 side = anyAcross(point.normal), other = point.normal.cross(side);
    mark.clear();
    mark.add({centre, side, other}, kMarkRadius);
    glUniform1f(markLook.open, isTarget ? 1.0f : 0.0f);
    mark.draw();
  }
  glEnable(GL_DEPTH_TEST);
}

void BodyPainting::draw(const RenderSnapshot& snapshot, const CameraView& world, bool cutaway) {
  const CameraView camera = stand.view(world);
  const View view = eyeView(camera, picture.width(), picture.height(), lamp);
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
  use(skinBare, view);
  body.drawSkin(cutaway);
  drawSkinShadows(snapshot, view, cutaway);
  use(section, view);
  body.drawInside(cutaway);
  use(sheetLook, view);
  sheet.draw();
  drawMarks(view, cutaway);
  drawTools(snapshot, view);
  if (magnified(snapshot)) drawMagnified(snapshot, camera, cutaway);
}

/// The place where the needle meets the skin, from the same eye, in a corner of the picture.
void BodyPainting::drawMagnified(const RenderSnapshot& snapshot, const CameraView& camera, bool cutaway) {
  const Glass glass = magnifier(picture.width(), picture.height());
  const Vec3 middle = stand.place(snapshot.needling.contact);
  const CameraView near{camera.eye, middle, camera.up, 2.0 * std::atan(0.5 * kGlassHeight / (camera.eye - middle).norm()) * 180.0 / std::numbers::pi};
  const View view = eyeView(near, glass.width, glass.height, lamp);
  const int fromBottom = picture.height() - glass.y - glass.height;              // pixels
  glViewport(glass.x, fromBottom, glass.width, glass.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(glass.x, fromBottom, glass.width, glass.height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  bindTexture(kSurfaceUnit, bodyImage);
  use(skin, view);
  body.drawSkin(cutaway);
  use(section, view);
  body.drawInside(cutaway);
  drawTools(snapshot, view);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, picture.width(), picture.height());
}

}  // namespace

std::unique_ptr<Painting> makeBodyPainting(const RenderScene& scene, const Canvas& picture) {
  return std::make_unique<BodyPainting>(scene, picture);
}

}  // namespace halsted::render
