/* Pulls the stylus to where it was when the spring was switched on; the hand is moved by a motion file. */
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>

#include <stdio.h>

static const HDdouble kStiffness = 0.1; /* N/mm */
static HDdouble anchor[3];
static int tick, errors;
static double largestForce, largestDistance;

static HDCallbackCode HDCALLBACK springCallback(void *pUserData) {
  HDdouble position[3], difference[3], force[3];
  HDErrorInfo error;
  HHD device = hdGetCurrentDevice();
  (void)pUserData;
  hdBeginFrame(device);
  hdGetDoublev(HD_CURRENT_POSITION, position);
  if (tick == 0) {
    anchor[0] = position[0];
    anchor[1] = position[1];
    anchor[2] = position[2];
  }
  hduVecSubtract(difference, anchor, position);
  hduVecScale(force, difference, kStiffness);
  hdSetDoublev(HD_CURRENT_FORCE, force);
  hdEndFrame(device);
  if (hduVecMagnitude(force) > largestForce) largestForce = hduVecMagnitude(force);
  if (hduVecMagnitude(difference) > largestDistance) largestDistance = hduVecMagnitude(difference);
  while (HD_DEVICE_ERROR(error = hdGetError())) {
    ++errors;
    hduPrintError(stderr, &error, "in the callback");
    if (hduIsSchedulerError(&error)) return HD_CALLBACK_DONE;
  }
  return ++tick < 600 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main(void) {
  HDErrorInfo error;
  HDSchedulerHandle spring;
  HHD device = hdInitDevice("Default PHANToM");
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    hduPrintError(stderr, &error, "no device");
    return 1;
  }
  hdEnable(HD_FORCE_OUTPUT);
  spring = hdScheduleAsynchronous(springCallback, 0, HD_DEFAULT_SCHEDULER_PRIORITY);
  hdStartScheduler();
  if (!hdWaitForCompletion(spring, HD_WAIT_INFINITE)) return 1;
  hdStopScheduler();
  hdDisableDevice(device);
  printf("ticks %d errors %d\n", tick, errors);
  printf("largest distance %.1f mm force %.2f N ratio %.3f N/mm\n", largestDistance, largestForce, largestForce / largestDistance);
  return 0;
}
