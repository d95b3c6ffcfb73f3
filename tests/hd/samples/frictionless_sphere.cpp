// A sphere round the origin that pushes outward; the hand slides over it.
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduMatrix.h>
#include <HDU/hduVector.h>

#include <cstdio>

static const double kRadius = 30.0;     // mm
static const double kStiffness = 0.25;  // N/mm
static double worstCosine = 1.0, largestForce = 0.0, transformError = 0.0;
static int touching = 0, ticks = 0;

static HDCallbackCode HDCALLBACK sphereCallback(void *) {
  const HHD device = hdGetCurrentDevice();
  hdBeginFrame(device);
  hduVector3Dd position;
  hduMatrix transform;
  hdGetDoublev(HD_CURRENT_POSITION, position);
  hdGetDoublev(HD_CURRENT_TRANSFORM, transform);
  const hduVector3Dd tip = hduVector3Dd(0, 0, 0) * transform;
  if (tip.distance(position) > transformError) transformError = tip.distance(position);

  const double distance = position.magnitude();
  if (distance < kRadius) {
    const hduVector3Dd direction = position / distance;
    const hduVector3Dd force = kStiffness * (kRadius - distance) * direction;
    hdSetDoublev(HD_CURRENT_FORCE, force);
    hduVector3Dd back;
    hdGetDoublev(HD_CURRENT_FORCE, back);
    ++touching;
    if (force.magnitude() > largestForce) largestForce = force.magnitude();
    if (force.magnitude() > 0.01) {
      const double cosine = normalize(back).dotProduct(direction);
      if (cosine < worstCosine) worstCosine = cosine;
    }
  }
  hdEndFrame(device);
  const HDErrorInfo error = hdGetError();
  if (hduIsSchedulerError(&error)) return HD_CALLBACK_DONE;
  return ++ticks < 800 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main() {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  HDErrorInfo error = hdGetError();
  if (HD_DEVICE_ERROR(error)) {
    hduPrintError(stderr, &error, "no device");
    return 1;
  }
  hdEnable(HD_FORCE_OUTPUT);
  hdStartScheduler();
  const HDSchedulerHandle handle = hdScheduleAsynchronous(sphereCallback, nullptr, HD_MAX_SCHEDULER_PRIORITY);
  hdWaitForCompletion(handle, HD_WAIT_INFINITE);
  hdStopScheduler();
  hdDisableDevice(device);
  std::printf("touching %d largest %.3f N cosine %.6f transform %.6f mm\n", touching, largestForce, worstCosine, transformError);
  return 0;
}
