/// hduMapWorkspace*: the device's box into the camera's view. Row vectors as in hduMatrix. No C++ library in it but inline code.
#include <HDU/hdu.h>
#include <HDU/hduMatrix.h>

namespace {

/// The corner of the view volume at a depth from 0 (near) to 1 (far), in camera coordinates.
hduVector3Dd corner(const hduMatrix& unproject, double x, double y, double depth) {
  hduVector3Dd out;
  unproject.multVecMatrix(hduVector3Dd(x, y, 2.0 * depth - 1.0), out);
  return out;
}

/// The largest upright box inside the view between two depths, as middle and size: as wide and high as the view is at the nearer depth.
void fit(const hduMatrix& unproject, double zNear, double zFar, hduVector3Dd& middle, hduVector3Dd& size) {
  const hduVector3Dd low = corner(unproject, -1.0, -1.0, zNear), high = corner(unproject, 1.0, 1.0, zNear);
  const hduVector3Dd back = corner(unproject, 0.0, 0.0, zFar), front = corner(unproject, 0.0, 0.0, zNear);
  size.set(fabs(high[0] - low[0]), fabs(high[1] - low[1]), fabs(front[2] - back[2]));
  middle.set(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (front[2] + back[2]));
}

hduMatrix deviceToCamera(const HDdouble* projMatrix, double zNear, double zFar) {
  HDdouble box[6] = {-80.0, -60.0, -35.0, 80.0, 60.0, 35.0};  // [mm] when no device is open
  hdGetDoublev(HD_USABLE_WORKSPACE_DIMENSIONS, box);
  hduVector3Dd middle, size;
  fit(hduMatrix(projMatrix).getInverse(), zNear, zFar, middle, size);
  double scale = size[0] / (box[3] - box[0]);
  for (int i = 1; i < 3; ++i)
    if (size[i] / (box[3 + i] - box[i]) < scale) scale = size[i] / (box[3 + i] - box[i]);
  const hduVector3Dd centre(0.5 * (box[0] + box[3]), 0.5 * (box[1] + box[4]), 0.5 * (box[2] + box[5]));
  return hduMatrix::createTranslation(-centre) * hduMatrix::createScale(scale, scale, scale) * hduMatrix::createTranslation(middle);
}

void store(const hduMatrix& matrix, HDdouble* out) {
  for (int i = 0; i < 16; ++i) out[i] = matrix[i / 4][i % 4];
}

}  // namespace

extern "C" {

void hduMapWorkspaceModelEx(const HDdouble* modelMatrix, const HDdouble* projMatrix, HDdouble zNear, HDdouble zFar,
                            HDdouble* wsModelMatrix) {
  store(deviceToCamera(projMatrix, zNear, zFar) * hduMatrix(modelMatrix).getInverse(), wsModelMatrix);
}

void hduMapWorkspaceModel(const HDdouble* modelMatrix, const HDdouble* projMatrix, HDdouble* wsModelMatrix) {
  hduMapWorkspaceModelEx(modelMatrix, projMatrix, 0.0, 1.0, wsModelMatrix);
}

void hduMapWorkspace(const HDdouble* projMatrix, HDdouble* wsViewMatrix) { store(deviceToCamera(projMatrix, 0.0, 1.0), wsViewMatrix); }

HDdouble hduScreenToWorkspaceScale(const HDdouble* modelMatrix, const HDdouble* projMatrix, const HDint* viewport,
                                   const HDdouble* wsModelMatrix) {
  const hduMatrix worldToClip = hduMatrix(modelMatrix) * hduMatrix(projMatrix);
  hduVector3Dd middle, seen, nextSeen, world, next;
  hduMatrix(wsModelMatrix).multVecMatrix(hduVector3Dd(0.0, 0.0, 0.0), middle);
  worldToClip.multVecMatrix(middle, seen);
  nextSeen = seen;
  nextSeen[0] += viewport[2] > 0 ? 2.0 / viewport[2] : 0.0;  // one pixel to the right
  const hduMatrix clipToWorld = worldToClip.getInverse();
  clipToWorld.multVecMatrix(seen, world);
  clipToWorld.multVecMatrix(nextSeen, next);
  return world.distance(next);
}

}  // extern "C"
