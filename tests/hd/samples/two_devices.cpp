// Two devices in one tick, joined by a spring: the moved hand drags the other one. Prints where the first one ends, and
// how far the second one was dragged before its own hand brought it back.
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>

#include <cstdio>

static HHD left, right;
static int ticks = 0, errors = 0;
static hduVector3Dd leftStart, rightStart, leftEnd, rightEnd, sum;

static HDCallbackCode HDCALLBACK couple(void *) {
  const double stiffness = 0.05;  // N/mm
  hduVector3Dd leftPosition, rightPosition;
  hdBeginFrame(left);
  hdGetDoublev(HD_CURRENT_POSITION, leftPosition);
  hdBeginFrame(right);
  hdGetDoublev(HD_CURRENT_POSITION, rightPosition);
  if (ticks == 0) {
    leftStart = leftPosition;
    rightStart = rightPosition;
  }
  const hduVector3Dd force = stiffness * ((leftPosition - leftStart) - (rightPosition - rightStart));
  hdMakeCurrentDevice(left);
  hdSetDoublev(HD_CURRENT_FORCE, -force);
  hduVector3Dd onLeft, onRight;
  hdGetDoublev(HD_CURRENT_FORCE, onLeft);
  hdEndFrame(left);
  hdMakeCurrentDevice(right);
  hdSetDoublev(HD_CURRENT_FORCE, force);
  hdGetDoublev(HD_CURRENT_FORCE, onRight);
  hdEndFrame(right);
  sum += onLeft + onRight;
  leftEnd = leftPosition - leftStart;
  if ((rightPosition - rightStart).magnitude() > rightEnd.magnitude()) rightEnd = rightPosition - rightStart;
  while (hdGetError().errorCode != HD_SUCCESS) ++errors;
  return ++ticks < 900 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main() {
  HDErrorInfo error;
  left = hdInitDevice("left");
  hdEnable(HD_FORCE_OUTPUT);
  right = hdInitDevice("right");
  hdEnable(HD_FORCE_OUTPUT);
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    hduPrintError(stderr, &error, "no device");
    return 1;
  }
  hdStartScheduler();
  hdWaitForCompletion(hdScheduleAsynchronous(couple, nullptr, HD_MAX_SCHEDULER_PRIORITY), HD_WAIT_INFINITE);
  hdStopScheduler();
  hdDisableDevice(left);
  hdDisableDevice(right);
  std::printf("left %.2f mm right %.2f mm sum %.6f N errors %d handles %u %u\n", leftEnd[0], rightEnd[0], sum.magnitude(), errors, left,
              right);
  return 0;
}
