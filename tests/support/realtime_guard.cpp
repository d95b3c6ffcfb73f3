#include "tests/support/realtime_guard.h"

#ifdef HALSTED_SANITIZED

namespace halsted::test {
RealtimeGuard::RealtimeGuard() noexcept : before_(0) {}
RealtimeGuard::~RealtimeGuard() = default;
std::uint64_t RealtimeGuard::calls() const noexcept { return 0; }
const char* RealtimeGuard::first() const noexcept { return "none"; }
bool RealtimeGuard::available() noexcept { return false; }
}  // namespace halsted::test

#else

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>
#include <stdio.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>

namespace {

// Initial-exec: reading them needs no call, so they may be used inside malloc.
__attribute__((tls_model("initial-exec"))) thread_local int depth = 0;
__attribute__((tls_model("initial-exec"))) thread_local std::uint64_t count = 0;
__attribute__((tls_model("initial-exec"))) thread_local const char* firstCall = nullptr;

void note(const char* call) noexcept {
  if (depth == 0) return;
  if (firstCall == nullptr) firstCall = call;
  ++count;
}

/// The library's own function of this name, behind ours.
template <typename Function>
Function* behind(const char* name, Function*) noexcept {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

namespace halsted::test {

RealtimeGuard::RealtimeGuard() noexcept : before_(count) {
  if (depth++ == 0) firstCall = nullptr;
}
RealtimeGuard::~RealtimeGuard() { --depth; }
std::uint64_t RealtimeGuard::calls() const noexcept { return count - before_; }
const char* RealtimeGuard::first() const noexcept { return calls() > 0 && firstCall ? firstCall : "none"; }
bool RealtimeGuard::available() noexcept { return true; }

}  // namespace halsted::test

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

void* malloc(std::size_t size) noexcept { note("malloc"); return __libc_malloc(size); }
void* calloc(std::size_t n, std::size_t size) noexcept { note("calloc"); return __libc_calloc(n, size); }
void* realloc(void* old, std::size_t size) noexcept { note("realloc"); return __libc_realloc(old, size); }
void* memalign(std::size_t align, std::size_t size) noexcept { note("memalign"); return __libc_memalign(align, size); }
void* aligned_alloc(std::size_t align, std::size_t size) noexcept { note("aligned_alloc"); return __libc_memalign(align, size); }
int posix_memalign(void** out, std::size_t align, std::size_t size) noexcept {
  note("posix_memalign");
  *out = __libc_memalign(align, size);
  return *out ? 0 : ENOMEM;
}
void free(void* block) noexcept { note("free"); __libc_free(block); }

// One line each: count, then hand on. The lookup is done at the first call and kept.
#define HALSTED_WATCH(result, name, parameters, arguments, specifier) \
  result name parameters specifier {                                   \
    note(#name);                                                       \
    static auto* const next = behind(#name, &name);                    \
    return next arguments;                                             \
  }

HALSTED_WATCH(int, pthread_mutex_lock, (pthread_mutex_t* m), (m), noexcept)
HALSTED_WATCH(int, pthread_mutex_trylock, (pthread_mutex_t* m), (m), noexcept)
HALSTED_WATCH(int, pthread_rwlock_rdlock, (pthread_rwlock_t* l), (l), noexcept)
HALSTED_WATCH(int, pthread_rwlock_wrlock, (pthread_rwlock_t* l), (l), noexcept)
HALSTED_WATCH(int, pthread_cond_wait, (pthread_cond_t* c, pthread_mutex_t* m), (c, m), )
HALSTED_WATCH(int, pthread_cond_timedwait, (pthread_cond_t* c, pthread_mutex_t* m, const timespec* t), (c, m, t), )
HALSTED_WATCH(int, pthread_cond_signal, (pthread_cond_t* c), (c), noexcept)
HALSTED_WATCH(int, sem_wait, (sem_t* s), (s), )
HALSTED_WATCH(int, sem_post, (sem_t* s), (s), noexcept)
HALSTED_WATCH(int, nanosleep, (const timespec* t, timespec* left), (t, left), )
HALSTED_WATCH(int, clock_nanosleep, (clockid_t c, int flags, const timespec* t, timespec* left), (c, flags, t, left), )
HALSTED_WATCH(int, usleep, (useconds_t t), (t), )
HALSTED_WATCH(ssize_t, read, (int file, void* to, std::size_t size), (file, to, size), )
HALSTED_WATCH(ssize_t, write, (int file, const void* from, std::size_t size), (file, from, size), )
HALSTED_WATCH(std::size_t, fwrite, (const void* from, std::size_t size, std::size_t n, FILE* file), (from, size, n, file), )
HALSTED_WATCH(int, puts, (const char* text), (text), )

#undef HALSTED_WATCH

}  // extern "C"

#endif
