/* Asks for haptic rendering of shapes first; where there is none, it says why and uses the device itself. */
#include <HD/hd.h>
#include <HDU/hduError.h>
#include <HL/hl.h>
#include <HLU/hlu.h>

#include <stdio.h>

static int ticks = 0;
static double strongest = 0;

static void HLCALLBACK touched(HLenum event, HLuint object, HLenum thread, HLcache *cache, void *userdata) {
  HLdouble proxy[3];
  (void)thread;
  (void)userdata;
  hlCacheGetDoublev(cache, HL_PROXY_POSITION, proxy);
  printf("touched %s %u\n", event, object);
}

static HDCallbackCode HDCALLBACK floor_at_zero(void *data) {
  HDdouble position[3], force[3] = {0, 0, 0};
  hdBeginFrame(*(HHD *)data);
  hdGetDoublev(HD_CURRENT_POSITION, position);
  if (position[1] < 0) force[1] = -0.3 * position[1];
  hdSetDoublev(HD_CURRENT_FORCE, force);
  hdEndFrame(*(HHD *)data);
  if (force[1] > strongest) strongest = force[1];
  return ++ticks < 800 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main(void) {
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  HHLRC context = hlCreateContext(device);
  HLerror error;
  int errors = 0, device_errors = 0;
  HLuint shape;
  const HLdouble projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  hlMakeCurrent(context);
  shape = hlGenShapes(1);
  hlAddEventCallback(HL_EVENT_TOUCH, shape, HL_CLIENT_THREAD, touched, 0);
  hlMatrixMode(HL_TOUCHWORKSPACE);
  hluFitWorkspace(projection);
  while (HL_ERROR(error = hlGetError())) {
    ++errors;
    fprintf(stderr, "HL Error: %s\n", error.errorCode);
    if (error.errorCode == HL_DEVICE_ERROR) {
      ++device_errors;
      hduPrintError(stderr, &error.errorInfo, "haptic rendering");
    }
  }
  printf("vendor %s context %d shape %u HL errors %d device %d\n", (const char *)hlGetString(HL_VENDOR), context != 0, shape, errors, device_errors);
  if (!context) {
    hdEnable(HD_FORCE_OUTPUT);
    hdStartScheduler();
    hdWaitForCompletion(hdScheduleAsynchronous(floor_at_zero, &device, HD_DEFAULT_SCHEDULER_PRIORITY), HD_WAIT_INFINITE);
    hdStopScheduler();
    printf("by HD alone: ticks %d strongest %.2f N error %u\n", ticks, strongest, hdGetError().errorCode);
  }
  hlDeleteContext(context);
  hdDisableDevice(device);
  return 0;
}
