/* The servo loop: callbacks once a tick, in order of decreasing priority. */
#ifndef HALSTED_HD_SCHEDULER_H
#define HALSTED_HD_SCHEDULER_H

#include <HD/hdDefines.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef unsigned int HDCallbackCode;
#define HD_CALLBACK_DONE 0
#define HD_CALLBACK_CONTINUE 1

typedef unsigned int HDWaitCode;
#define HD_WAIT_CHECK_STATUS 0
#define HD_WAIT_INFINITE 1

typedef unsigned long HDSchedulerHandle;
typedef HDCallbackCode(HDCALLBACK *HDSchedulerCallback)(void *pUserData);

HDAPI void HDAPIENTRY hdStartScheduler(void);
HDAPI void HDAPIENTRY hdStopScheduler(void);
HDAPI void HDAPIENTRY hdSetSchedulerRate(HDulong nRate);

HDAPI void HDAPIENTRY hdScheduleSynchronous(HDSchedulerCallback pCallback, void *pUserData, HDushort nPriority);
HDAPI HDSchedulerHandle HDAPIENTRY hdScheduleAsynchronous(HDSchedulerCallback pCallback, void *pUserData, HDushort nPriority);
HDAPI void HDAPIENTRY hdUnschedule(HDSchedulerHandle hHandle);
HDAPI HDboolean HDAPIENTRY hdWaitForCompletion(HDSchedulerHandle hHandle, HDWaitCode param);

/* Seconds since the start of the tick. */
HDAPI HDdouble HDAPIENTRY hdGetSchedulerTimeStamp(void);

#ifdef __cplusplus
}
#endif

#endif
