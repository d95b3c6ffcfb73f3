/* Rates 500, 1000 and 2000, the rate of each tick, and how much of the tick is gone when the callback runs. */
#include <HD/hd.h>
#include <HDU/hduError.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define SAMPLES 400

static HDdouble rates[SAMPLES], stamps[SAMPLES];
static int count;

static HDCallbackCode HDCALLBACK logRate(void *pUserData) {
  HDdouble rate = 0;
  (void)pUserData;
  stamps[count] = hdGetSchedulerTimeStamp();
  hdGetDoublev(HD_INSTANTANEOUS_UPDATE_RATE, &rate);
  rates[count] = rate;
  return ++count < SAMPLES ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

static int compare(const void *a, const void *b) {
  const HDdouble x = *(const HDdouble *)a, y = *(const HDdouble *)b;
  return x < y ? -1 : x > y;
}

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

int main(void) {
  static const HDulong wanted[3] = {500, 1000, 2000};
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  int i;
  if (hdGetError().errorCode != HD_SUCCESS) return 1;
  hdStartScheduler();
  for (i = 0; i < 3; ++i) {
    HDint nominal = 0;
    double start;
    hdSetSchedulerRate(wanted[i]);
    hdGetIntegerv(HD_UPDATE_RATE, &nominal);
    count = 0;
    start = now();
    hdWaitForCompletion(hdScheduleAsynchronous(logRate, 0, HD_DEFAULT_SCHEDULER_PRIORITY), HD_WAIT_INFINITE);
    start = now() - start;
    qsort(rates, SAMPLES, sizeof rates[0], compare);
    qsort(stamps, SAMPLES, sizeof stamps[0], compare);
    printf("rate %lu nominal %d median %.1f measured %.1f stamp_us %.1f p99_us %.1f error %u\n", wanted[i], nominal, rates[SAMPLES / 2],
           SAMPLES / start, stamps[SAMPLES / 2] * 1e6, stamps[SAMPLES * 99 / 100] * 1e6, hdGetError().errorCode);
  }
  hdSetSchedulerRate(1234);
  printf("odd rate: %s\n", hdGetErrorString(hdGetError().errorCode));
  hdStopScheduler();
  hdDisableDevice(device);
  return 0;
}
