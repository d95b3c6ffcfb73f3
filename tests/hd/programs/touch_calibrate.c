/* touch_calibrate: brings a device into a calibrated state and says how steady it then reads.
 *   touch_calibrate [-d NAME] [-s SECONDS]
 * Exit status: 0 calibrated, 2 the user did not dock the stylus in time, 1 anything else. */
#define _POSIX_C_SOURCE 200809L
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HDU/hduVector.h>

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { SAMPLES = 200 };
_Static_assert(sizeof(HDErrorInfo) == 12, "the error travels by value");
_Static_assert(HD_DEFAULT_SCHEDULER_PRIORITY == 32767, "half way");

struct session {
  HHD device;
  HDenum style, status;
  bool docked;
  int taken;
  hduVector3Dd sample[SAMPLES];
};

static bool failed(const char *doing) {
  HDErrorInfo error = hdGetError();
  if (!HD_DEVICE_ERROR(error)) return false;
  hduPrintError(stderr, &error, doing);
  if (hduIsSchedulerError(&error)) exit(1);
  return true;
}

static HDCallbackCode HDCALLBACK look(void *data) {
  struct session *s = data;
  HDboolean away = HD_TRUE;
  hdBeginFrame(s->device);
  hdGetBooleanv(HD_CURRENT_INKWELL_SWITCH, &away);
  hdEndFrame(s->device);
  s->docked = away == HD_FALSE;
  s->status = hdCheckCalibration();
  return HD_CALLBACK_DONE;
}

static HDCallbackCode HDCALLBACK take(void *data) {
  struct session *s = data;
  hdBeginFrame(s->device);
  hdGetDoublev(HD_CURRENT_POSITION, s->sample[s->taken]);
  hdEndFrame(s->device);
  return ++s->taken < SAMPLES ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

static const char *style_name(HDenum style) {
  switch (style) {
    case HD_CALIBRATION_ENCODER_RESET: return "encoder reset";
    case HD_CALIBRATION_AUTO: return "automatic";
    case HD_CALIBRATION_INKWELL: return "inkwell";
    default: return "none";
  }
}

int main(int argc, char **argv) {
  const char *name = HD_DEFAULT_DEVICE;
  double patience = 2.0;
  struct session *s = calloc(1, sizeof *s);
  int option, waited = 0;
  while ((option = getopt(argc, argv, "d:s:")) != -1) {
    if (option == 'd') name = optarg;
    else if (option == 's') patience = atof(optarg);
    else return 1;
  }
  s->device = hdInitDevice(name);
  if (failed("cannot open the device")) return 1;
  HDdouble firmware = 0;
  hdGetDoublev(HD_DEVICE_FIRMWARE_VERSION, &firmware);
  printf("%s, %s, serial %s, firmware %.3f, HD %s\n", hdGetString(HD_DEVICE_VENDOR), hdGetString(HD_DEVICE_MODEL_TYPE),
         hdGetString(HD_DEVICE_SERIAL_NUMBER), firmware, hdGetString(HD_VERSION));
  HDint styles = 0;
  hdGetIntegerv(HD_CALIBRATION_STYLE, &styles);
  for (HDenum bit = HD_CALIBRATION_ENCODER_RESET; bit <= HD_CALIBRATION_INKWELL; bit <<= 1)
    if ((HDenum)styles & bit) s->style = bit;
  printf("style %s\n", style_name(s->style));
  hdStartScheduler();
  if (failed("the servo loop does not start")) return 1;
  const struct timespec pause = {0, 20 * 1000 * 1000};
  for (;;) {
    hdScheduleSynchronous(look, s, HD_DEFAULT_SCHEDULER_PRIORITY);
    if (s->status == HD_CALIBRATION_OK) break;
    if (s->status == HD_CALIBRATION_NEEDS_UPDATE) hdUpdateCalibration(s->style);
    else if (waited == 0) puts("please put the stylus into the inkwell");
    if (waited++ * 0.02 > patience) {
      puts("gave up");
      hdStopScheduler();
      hdDisableDevice(s->device);
      return 2;
    }
    nanosleep(&pause, NULL);
  }
  hdScheduleSynchronous(take, s, HD_MAX_SCHEDULER_PRIORITY);
  hduVector3Dd mean = {0, 0, 0}, difference;
  double worst = 0;
  for (int i = 0; i < SAMPLES; i++) hduVecAdd(mean, mean, s->sample[i]);
  hduVecScaleInPlace(mean, 1.0 / SAMPLES);
  for (int i = 0; i < SAMPLES; i++) {
    hduVecSubtract(difference, s->sample[i], mean);
    if (hduVecMagnitude(difference) > worst) worst = hduVecMagnitude(difference);
  }
  printf("calibrated docked %d waited %d mean %.2f %.2f %.2f spread %.3f mm\n", s->docked, waited > 0, mean[0], mean[1], mean[2], worst);
  hdStopScheduler();
  hdDisableDevice(s->device);
  const bool clean = !failed("at the end");
  free(s);
  return clean ? 0 : 1;
}
