/* 50 Hz along y; the timing comes from the tick count at the rate that the scheduler says. */
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>

#include <math.h>
#include <stdio.h>

static int tick, crossings, errors;
static double previous, rate;
static double low = 1e9, high = -1e9;

static HDCallbackCode HDCALLBACK vibrate(void *pUserData) {
  static const hduVector3Dd direction = {0, 1, 0};
  hduVector3Dd force, position;
  HDint nominal = 0;
  double amplitude;
  (void)pUserData;
  hdBeginFrame(hdGetCurrentDevice());
  hdGetIntegerv(HD_UPDATE_RATE, &nominal);
  rate = nominal;
  hdGetDoublev(HD_CURRENT_POSITION, position);
  amplitude = 0.75 * sin(2.0 * 3.14159265358979 * 50.0 * tick / rate);
  hduVecScale(force, direction, amplitude);
  hdSetDoublev(HD_CURRENT_FORCE, force);
  hdEndFrame(hdGetCurrentDevice());
  if (previous * amplitude < 0) ++crossings;
  if (amplitude != 0) previous = amplitude;
  if (tick > 300 && position[1] < low) low = position[1];
  if (tick > 300 && position[1] > high) high = position[1];
  if (hdGetError().errorCode != HD_SUCCESS) ++errors;
  return ++tick < 1001 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main(void) {
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  HDSchedulerHandle handle;
  if (hdGetError().errorCode != HD_SUCCESS) return 1;
  hdEnable(HD_FORCE_OUTPUT);
  handle = hdScheduleAsynchronous(vibrate, 0, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  hdWaitForCompletion(handle, HD_WAIT_INFINITE);
  hdStopScheduler();
  hdDisableDevice(device);
  printf("crossings %d rate %.0f errors %d motion %.3f mm\n", crossings, rate, errors, high - low);
  return 0;
}
