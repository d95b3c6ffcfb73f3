#pragma once
/// A mutex whose holder inherits the priority of who waits for it. The HD API lets any thread call anything at any time, so its state
/// needs one; held for some hundred nanoseconds, never over a callback, a device transfer or a system call. Servo and client threads.
#include <pthread.h>

namespace halsted::haptics::hd {

class InheritingMutex {
 public:
  InheritingMutex() noexcept {
    pthread_mutexattr_t kind;
    pthread_mutexattr_init(&kind);
    pthread_mutexattr_setprotocol(&kind, PTHREAD_PRIO_INHERIT);
    pthread_mutex_init(&mutex_, &kind);
    pthread_mutexattr_destroy(&kind);
  }
  InheritingMutex(const InheritingMutex&) = delete;
  InheritingMutex& operator=(const InheritingMutex&) = delete;
  ~InheritingMutex() { pthread_mutex_destroy(&mutex_); }

  void lock() noexcept { pthread_mutex_lock(&mutex_); }
  void unlock() noexcept { pthread_mutex_unlock(&mutex_); }
  pthread_mutex_t* native() noexcept { return &mutex_; }

 private:
  pthread_mutex_t mutex_;
};

/// Holds a mutex for a scope.
class Hold {
 public:
  explicit Hold(InheritingMutex& mutex) noexcept : mutex_(mutex) { mutex_.lock(); }
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;
  ~Hold() { mutex_.unlock(); }

 private:
  InheritingMutex& mutex_;
};

}  // namespace halsted::haptics::hd
