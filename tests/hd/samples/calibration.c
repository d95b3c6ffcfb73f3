/* What a driver does before it trusts a position: looks at the style, updates when asked, waits for the user when it must. */
#include <HD/hd.h>
#include <HDU/hduError.h>

#include <stdio.h>
#include <time.h>

typedef struct {
  HDenum style, status;
  HDdouble position[3];
} Calibration;

static HDCallbackCode HDCALLBACK calibrate(void *pUserData) {
  Calibration *calibration = (Calibration *)pUserData;
  if (hdCheckCalibration() == HD_CALIBRATION_NEEDS_UPDATE) hdUpdateCalibration(calibration->style);
  hdBeginFrame(hdGetCurrentDevice());
  hdGetDoublev(HD_CURRENT_POSITION, calibration->position);
  hdEndFrame(hdGetCurrentDevice());
  calibration->status = hdCheckCalibration();
  return HD_CALLBACK_DONE;
}

static const char *name(HDenum status) {
  return status == HD_CALIBRATION_OK ? "ok" : status == HD_CALIBRATION_NEEDS_UPDATE ? "needs_update" : "needs_manual_input";
}

int main(void) {
  Calibration calibration = {0, 0, {0, 0, 0}};
  HDint styles = 0;
  HDdouble before[3];
  HDErrorInfo error;
  const struct timespec pause = {0, 5000000};
  int tries = 0, asked = 0;
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  if (HD_DEVICE_ERROR(error = hdGetError())) {
    hduPrintError(stderr, &error, "no device");
    return 1;
  }
  hdGetIntegerv(HD_CALIBRATION_STYLE, &styles);
  if (styles & HD_CALIBRATION_ENCODER_RESET) calibration.style = HD_CALIBRATION_ENCODER_RESET;
  if (styles & HD_CALIBRATION_INKWELL) calibration.style = HD_CALIBRATION_INKWELL;
  if (styles & HD_CALIBRATION_AUTO) calibration.style = HD_CALIBRATION_AUTO;
  hdGetDoublev(HD_CURRENT_POSITION, before);
  printf("styles %d first %s position %.2f %.2f %.2f\n", styles, name(hdCheckCalibration()), before[0], before[1], before[2]);
  hdStartScheduler();
  do {
    hdScheduleSynchronous(calibrate, &calibration, HD_DEFAULT_SCHEDULER_PRIORITY);
    if (calibration.status == HD_CALIBRATION_NEEDS_MANUAL_INPUT) asked = 1;
    nanosleep(&pause, 0);
  } while (calibration.status != HD_CALIBRATION_OK && ++tries < 400);
  hdScheduleSynchronous(calibrate, &calibration, HD_DEFAULT_SCHEDULER_PRIORITY);
  hdStopScheduler();
  error = hdGetError();
  printf("last %s asked %d error %u position %.2f %.2f %.2f\n", name(calibration.status), asked, error.errorCode, calibration.position[0],
         calibration.position[1], calibration.position[2]);
  hdDisableDevice(device);
  return 0;
}
