/* A frame that opens in the first callback of a tick and closes in the last; then every mistake, and what it is called. */
#include <HD/hd.h>
#include <HDU/hduError.h>

#include <stdio.h>

static int opened, used, closed, wrong;

static HDCallbackCode HDCALLBACK beginCallback(void *pUserData) {
  (void)pUserData;
  hdBeginFrame(hdGetCurrentDevice());
  ++opened;
  return HD_CALLBACK_CONTINUE;
}

static HDCallbackCode HDCALLBACK useCallback(void *pUserData) {
  HDdouble force[3] = {0.1, 0.2, 0.3}, seen[3];
  (void)pUserData;
  hdSetDoublev(HD_CURRENT_FORCE, force);
  hdGetDoublev(HD_CURRENT_FORCE, seen);
  if (seen[0] != 0.1 || seen[1] != 0.2 || seen[2] != 0.3) ++wrong;
  ++used;
  return HD_CALLBACK_CONTINUE;
}

static HDCallbackCode HDCALLBACK endCallback(void *pUserData) {
  (void)pUserData;
  hdEndFrame(hdGetCurrentDevice());
  ++closed;
  return HD_CALLBACK_CONTINUE;
}

/* Reads the servo thread's count on that thread: the way to see a number that it writes. */
static HDCallbackCode HDCALLBACK readClosed(void *pUserData) {
  *(int *)pUserData = closed;
  return HD_CALLBACK_DONE;
}

static HDCallbackCode HDCALLBACK mistakes(void *pUserData) {
  HDdouble force[3] = {0, 0, 0};
  HDint whole[3];
  (void)pUserData;
  hdEndFrame(hdGetCurrentDevice());                    /* HD_ILLEGAL_END */
  hdSetDoublev(HD_CURRENT_FORCE, force);               /* HD_FRAME_ERROR */
  hdGetIntegerv(HD_CURRENT_POSITION, whole);           /* HD_INVALID_INPUT_TYPE */
  hdGetDoublev(0x1234, force);                         /* HD_INVALID_ENUM */
  hdMakeCurrentDevice(77);                             /* HD_BAD_HANDLE */
  hdBeginFrame(hdGetCurrentDevice());
  hdEndFrame(hdGetCurrentDevice());
  hdBeginFrame(hdGetCurrentDevice());                  /* HD_ILLEGAL_BEGIN */
  return HD_CALLBACK_DONE;
}

int main(void) {
  HDSchedulerHandle handles[3];
  HDErrorInfo error;
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  int i, asked, seen = 0;
  if (hdGetError().errorCode != HD_SUCCESS) return 1;
  hdInitDevice(HD_DEFAULT_DEVICE);
  hdInitDevice("no such device");
  while (HD_DEVICE_ERROR(error = hdGetError())) printf("init %s\n", hdGetErrorString(error.errorCode));
  hdEnable(HD_FORCE_OUTPUT);
  handles[0] = hdScheduleAsynchronous(endCallback, 0, HD_MIN_SCHEDULER_PRIORITY);
  handles[1] = hdScheduleAsynchronous(useCallback, 0, HD_DEFAULT_SCHEDULER_PRIORITY);
  handles[2] = hdScheduleAsynchronous(beginCallback, 0, HD_MAX_SCHEDULER_PRIORITY);
  hdStartScheduler();
  for (asked = 0; seen < 200 && asked < 100000; ++asked) {
    hdWaitForCompletion(handles[0], HD_WAIT_CHECK_STATUS);
    hdScheduleSynchronous(readClosed, &seen, HD_DEFAULT_SCHEDULER_PRIORITY);
  }
  for (i = 0; i < 3; ++i) hdUnschedule(handles[2 - i]); /* the one that opens goes first */
  error = hdGetError();
  printf("frames %s wrong %d error %s\n", closed >= 200 && opened >= closed && used >= closed ? "ok" : "missing", wrong,
         hdGetErrorString(error.errorCode));
  hdScheduleSynchronous(mistakes, 0, HD_DEFAULT_SCHEDULER_PRIORITY);
  while (HD_DEVICE_ERROR(error = hdGetError())) printf("mistake %s on %u\n", hdGetErrorString(error.errorCode), error.hHD);
  hdStopScheduler();
  hdDisableDevice(device);
  return 0;
}
