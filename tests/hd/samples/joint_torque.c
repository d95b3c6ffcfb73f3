/* Pushes with the three motors instead of a force: torques from the Jacobian, tau = J^T F. Then the same as DAC values. */
#include <HD/hd.h>
#include <HDU/hduError.h>

#include <math.h>
#include <stdio.h>

static int tick, errors;
static HDdouble first[3], byTorque[3], byForce[3], byMotors[3];
static HDlong motors[3];

static void note(const HDdouble *position, HDdouble *moved) {
  int i;
  for (i = 0; i < 3; ++i)
    if (fabs(position[i] - first[i]) > fabs(moved[i])) moved[i] = position[i] - first[i];
}

static HDCallbackCode HDCALLBACK push(void *pUserData) {
  static const HDdouble force[3] = {0.0, 0.6, 0.0};
  HDdouble position[3], jacobian[36], torque[3];
  int i, phase = tick < 200 || tick / 200 % 2 == 0 ? -1 : tick / 400; /* pushes and rests of 0.2 s */
  (void)pUserData;
  hdBeginFrame(hdGetCurrentDevice());
  hdGetDoublev(HD_CURRENT_POSITION, position);
  hdGetDoublev(HD_CURRENT_JACOBIAN, jacobian);
  if (phase < 0)
    for (i = 0; i < 3; ++i) first[i] = position[i];
  if (phase == 0) {
    hdSetDoublev(HD_CURRENT_FORCE, force); /* once unseen: friction remembers the last push */
  } else if (phase == 1) {
    for (i = 0; i < 3; ++i) torque[i] = jacobian[i] * force[0] + jacobian[6 + i] * force[1] + jacobian[12 + i] * force[2];
    hdSetDoublev(HD_CURRENT_JOINT_TORQUE, torque);
    note(position, byTorque);
  } else if (phase == 2) {
    hdSetDoublev(HD_CURRENT_FORCE, force);
    if (tick == 1010) hdGetLongv(HD_LAST_MOTOR_DAC_VALUES, motors);
    note(position, byForce);
  } else if (phase == 3) {
    hdSetLongv(HD_CURRENT_MOTOR_DAC_VALUES, motors);
    note(position, byMotors);
  }
  hdEndFrame(hdGetCurrentDevice());
  while (hdGetError().errorCode != HD_SUCCESS) ++errors;
  return ++tick < 1600 ? HD_CALLBACK_CONTINUE : HD_CALLBACK_DONE;
}

int main(void) {
  HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  HDSchedulerHandle handle;
  if (hdGetError().errorCode != HD_SUCCESS) return 1;
  hdEnable(HD_FORCE_OUTPUT);
  hdStartScheduler();
  handle = hdScheduleAsynchronous(push, 0, HD_DEFAULT_SCHEDULER_PRIORITY);
  hdWaitForCompletion(handle, HD_WAIT_INFINITE);
  hdStopScheduler();
  hdDisableDevice(device);
  printf("torque %.3f %.3f %.3f force %.3f %.3f %.3f motors %.3f %.3f %.3f dac %ld %ld %ld errors %d\n", byTorque[0], byTorque[1],
         byTorque[2], byForce[0], byForce[1], byForce[2], byMotors[0], byMotors[1], byMotors[2], motors[0], motors[1], motors[2], errors);
  return 0;
}
