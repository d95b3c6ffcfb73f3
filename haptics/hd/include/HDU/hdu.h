/* Fitting the device's workspace into a view. Matrices as OpenGL keeps them: sixteen doubles, column after column. */
#ifndef HALSTED_HDU_H
#define HALSTED_HDU_H

#include <HD/hd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* From device coordinates [mm] to world coordinates, so that the usable workspace of the current device fills what the camera sees,
   along the camera's axes, with one scale for the three axes. */
void hduMapWorkspaceModel(const HDdouble *modelMatrix, const HDdouble *projMatrix, HDdouble *wsModelMatrix);
/* The same between two depths of the view, 0 at the near plane, 1 at the far one. */
void hduMapWorkspaceModelEx(const HDdouble *modelMatrix, const HDdouble *projMatrix, HDdouble zNear, HDdouble zFar,
                            HDdouble *wsModelMatrix);
/* The same in coordinates of the camera. */
void hduMapWorkspace(const HDdouble *projMatrix, HDdouble *wsViewMatrix);

/* How long one pixel is, in world units, at the depth of the middle of the mapped workspace. */
HDdouble hduScreenToWorkspaceScale(const HDdouble *modelMatrix, const HDdouble *projMatrix, const HDint *viewport,
                                   const HDdouble *wsModelMatrix);

#ifdef __cplusplus
}
#endif

#endif
