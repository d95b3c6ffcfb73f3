/// The scheduler.
#include <HD/hd.h>

#include "haptics/hd/session.h"

using namespace halsted::haptics::hd;

namespace {

constexpr int kMostCallsInPlace = 100'000;             // of a synchronous callback that never says it is done
constexpr Nanoseconds kUnschedulePatience = kSecond / 4;

/// On the servo thread itself: now, whatever the priorities. There is nothing to wait for between two calls.
void runOnServo(Session& session, HDSchedulerCallback callback, void* userData) {
  for (int i = 0; i < kMostCallsInPlace; ++i)
    if (callback(userData) != HD_CALLBACK_CONTINUE) return;
  session.raise(HD_TIMER_ERROR);
}

/// Without a servo loop: on the calling thread, one call a period, each a tick of its own.
void runHere(Session& session, HDSchedulerCallback callback, void* userData) {
  ThreadContext& thread = thisThread();
  const bool nested = thread.moment.tick != 0;
  Nanoseconds next = monotonicNow();
  for (int i = 0; i < kMostCallsInPlace; ++i) {
    if (!nested) thread.moment.tick = session.servo.newTick();
    thread.localStart = monotonicNow();
    const bool again = callback(userData) == HD_CALLBACK_CONTINUE;
    if (!nested) thread.moment.tick = 0;
    if (!again) return;
    sleepUntil(next += session.servo.period());
  }
  session.raise(HD_TIMER_ERROR);
}

/// In the servo loop, and waits. False when the loop stopped first: then it is for the caller to run.
bool runInLoop(Session& session, const Operation& operation) {
  const HDSchedulerHandle handle = session.operations.add(operation);
  if (handle == 0) {
    session.raise(HD_SCHEDULER_FULL);
    return true;
  }
  HHD left = HD_INVALID_HANDLE;
  const bool finished = session.operations.waitFor(handle, &left) || !session.operations.remove(handle, kSecond);
  if (finished && session.find(left)) thisThread().current = left;
  return finished;
}

}  // namespace

extern "C" {

void hdStartScheduler(void) {
  Session& session = Session::instance();
  if (!session.servo.start()) session.raise(HD_TIMER_ERROR);
}

void hdStopScheduler(void) { Session::instance().servo.stop(); }

void hdSetSchedulerRate(HDulong nRate) {
  Session& session = Session::instance();
  if (!session.servo.setRate(nRate)) session.raise(HD_INVALID_VALUE);
}

void hdScheduleSynchronous(HDSchedulerCallback pCallback, void* pUserData, HDushort nPriority) {
  Session& session = Session::instance();
  if (!pCallback) return session.raise(HD_INVALID_VALUE);
  if (thisThread().servo) return runOnServo(session, pCallback, pUserData);
  const Operation operation{pCallback, pUserData, nPriority, true, session.currentDevice()};
  if (session.servo.running() && runInLoop(session, operation)) return;
  runHere(session, pCallback, pUserData);
}

HDSchedulerHandle hdScheduleAsynchronous(HDSchedulerCallback pCallback, void* pUserData, HDushort nPriority) {
  Session& session = Session::instance();
  if (!pCallback) {
    session.raise(HD_INVALID_VALUE);
    return HD_INVALID_HANDLE;
  }
  const HDSchedulerHandle handle = session.operations.add({pCallback, pUserData, nPriority, false, HD_INVALID_HANDLE});
  if (handle != 0) return handle;
  session.raise(HD_SCHEDULER_FULL);
  return HD_INVALID_HANDLE;
}

void hdUnschedule(HDSchedulerHandle hHandle) {
  Session& session = Session::instance();
  // From another thread the callback is not running any more when this returns; its data may then be freed.
  const Nanoseconds patience = thisThread().servo ? 0 : kUnschedulePatience;
  if (!session.operations.remove(hHandle, patience)) session.raise(HD_INVALID_OPERATION);
}

HDboolean hdWaitForCompletion(HDSchedulerHandle hHandle, HDWaitCode param) {
  Session& session = Session::instance();
  const bool known = session.operations.wasIssued(hHandle);
  if (!known || (param != HD_WAIT_CHECK_STATUS && param != HD_WAIT_INFINITE)) {
    session.raise(known ? HD_INVALID_ENUM : HD_INVALID_OPERATION);
    return HD_FALSE;
  }
  const bool scheduled = session.operations.isScheduled(hHandle);
  if (param == HD_WAIT_CHECK_STATUS) return scheduled ? HD_TRUE : HD_FALSE;
  if (!scheduled) return HD_TRUE;
  if (!thisThread().servo && session.operations.waitFor(hHandle, nullptr)) return HD_TRUE;
  session.raise(HD_INVALID_OPERATION);  // the servo thread would wait for itself; a loop that does not run never finishes
  return HD_FALSE;
}

HDdouble hdGetSchedulerTimeStamp(void) {
  const ThreadContext& thread = thisThread();
  const bool inPlace = !thread.servo && thread.moment.tick != 0;
  return inPlace ? seconds(monotonicNow() - thread.localStart) : Session::instance().servo.sinceTick();
}

}  // extern "C"
