// A plane at y = 0 that pushes up only; reports what the hand that pressed it felt.
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace {

struct Plane {
  hduVector3Dd normal;
  double stiffness;                                    // N/mm
  double deepest, largest, sideways;                   // mm, N, N
  int touching, errors, ticks;
};

HDCallbackCode HDCALLBACK planeCallback(void *data) {
  Plane *plane = static_cast<Plane *>(data);
  hdBeginFrame(hdGetCurrentDevice());
  hduVector3Dd position;
  hdGetDoublev(HD_CURRENT_POSITION, position);
  const double depth = -dotProduct(position, plane->normal);
  hduVector3Dd force(0, 0, 0);
  if (depth > 0) {
    force = plane->stiffness * depth * plane->normal;
    ++plane->touching;
    if (depth > plane->deepest) plane->deepest = depth;
    if (force.magnitude() > plane->largest) plane->largest = force.magnitude();
    const hduVector3Dd along = force - plane->normal * force.dotProduct(plane->normal);
    if (along.magnitude() > plane->sideways) plane->sideways = along.magnitude();
  }
  hdSetDoublev(HD_CURRENT_FORCE, force);
  hdEndFrame(hdGetCurrentDevice());

  HDErrorInfo error;
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    std::cerr << error << std::endl;
    ++plane->errors;
    if (hduIsSchedulerError(&error)) return HD_CALLBACK_DONE;
  }
  return ++plane->ticks < 800 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

}  // namespace

int main() {
  HDErrorInfo error;
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    hduPrintError(stderr, &error, "Failed to initialize haptic device");
    return EXIT_FAILURE;
  }
  hdEnable(HD_FORCE_OUTPUT);
  Plane plane = {hduVector3Dd(0, 1, 0), 0.25, 0, 0, 0, 0, 0, 0};
  hdStartScheduler();
  HDSchedulerHandle handle = hdScheduleAsynchronous(planeCallback, &plane, HD_DEFAULT_SCHEDULER_PRIORITY);
  hdWaitForCompletion(handle, HD_WAIT_INFINITE);
  hdStopScheduler();
  hdUnschedule(handle);                                // finished: that is an error
  const bool known = hdGetError().errorCode == HD_INVALID_OPERATION;
  hdDisableDevice(device);
  std::printf("touching %d deepest %.2f mm force %.3f N sideways %.4f N errors %d unscheduled_twice %d\n", plane.touching, plane.deepest,
              plane.largest, plane.sideways, plane.errors, known);
  return 0;
}
