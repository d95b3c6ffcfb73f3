/* Prints what a device says of itself, then where it is. */
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>

#include <stdio.h>

typedef struct {
  HDboolean button;
  hduVector3Dd position;
  HDErrorInfo error;
  int ticks;
} DeviceData;

static DeviceData servoData;

static HDCallbackCode HDCALLBACK updateDevice(void *pUserData) {
  HDint buttons = 0;
  (void)pUserData;
  hdBeginFrame(hdGetCurrentDevice());
  hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons);
  servoData.button = (buttons & HD_DEVICE_BUTTON_1) ? HD_TRUE : HD_FALSE;
  hdGetDoublev(HD_CURRENT_POSITION, servoData.position);
  servoData.error = hdGetError();
  hdEndFrame(hdGetCurrentDevice());
  ++servoData.ticks;
  return HD_CALLBACK_CONTINUE;
}

static HDCallbackCode HDCALLBACK copyData(void *pUserData) {
  *(DeviceData *)pUserData = servoData;
  return HD_CALLBACK_DONE;
}

static HDCallbackCode HDCALLBACK waitTicks(void *pUserData) {
  return --*(int *)pUserData > 0 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main(void) {
  HDErrorInfo error;
  DeviceData seen;
  HDint dof = 0;
  HDdouble force = 0, workspace[6];
  int wait = 50;
  HDSchedulerHandle handle;
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    hduPrintError(stderr, &error, "no device");
    return 1;
  }
  hdGetIntegerv(HD_INPUT_DOF, &dof);
  hdGetDoublev(HD_NOMINAL_MAX_FORCE, &force);
  hdGetDoublev(HD_USABLE_WORKSPACE_DIMENSIONS, workspace);
  printf("handle %u model %s vendor %s serial %s version %s\n", device, hdGetString(HD_DEVICE_MODEL_TYPE), hdGetString(HD_DEVICE_VENDOR),
         hdGetString(HD_DEVICE_SERIAL_NUMBER), hdGetString(HD_VERSION));
  printf("dof %d force %.2f N workspace %.0f %.0f %.0f to %.0f %.0f %.0f mm\n", dof, force, workspace[0], workspace[1], workspace[2],
         workspace[3], workspace[4], workspace[5]);

  handle = hdScheduleAsynchronous(updateDevice, 0, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    hduPrintError(stderr, &error, "no scheduler");
    return 1;
  }
  hdScheduleSynchronous(waitTicks, &wait, HD_MIN_SCHEDULER_PRIORITY);
  hdScheduleSynchronous(copyData, &seen, HD_MIN_SCHEDULER_PRIORITY);
  printf("position %.1f %.1f %.1f button %d error %u ticks %s\n", seen.position[0], seen.position[1], seen.position[2], seen.button,
         seen.error.errorCode, seen.ticks >= 50 ? "ok" : "too few");
  hdStopScheduler();
  hdUnschedule(handle);
  hdDisableDevice(device);
  error = hdGetError();
  printf("end: %s\n", hdGetErrorString(error.errorCode));
  return 0;
}
