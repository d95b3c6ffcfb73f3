/* Knows no header: loads the library by name, as wrappers of other languages do. argv[1]: the library. */
#include <dlfcn.h>
#include <stdio.h>

typedef struct { unsigned error; int internal; unsigned device; } Error;

static unsigned (*current)(void);
static void (*beginFrame)(unsigned), (*endFrame)(unsigned), (*getDoublev)(unsigned, double *);
static double position[3];

static unsigned readPosition(void *data) {
  (void)data;
  beginFrame(current());
  getDoublev(0x2050, position);
  endFrame(current());
  return 0;
}

int main(int argc, char **argv) {
  void *library = dlopen(argc > 1 ? argv[1] : "libHD.so", RTLD_NOW);
  unsigned (*init)(const char *), device;
  void (*start)(void), (*stop)(void), (*synchronous)(unsigned (*)(void *), void *, unsigned short), (*disable)(unsigned);
  Error (*lastError)(void);
  if (!library) {
    printf("%s\n", dlerror());
    return 1;
  }
  *(void **)&init = dlsym(library, "hdInitDevice");
  *(void **)&disable = dlsym(library, "hdDisableDevice");
  *(void **)&current = dlsym(library, "hdGetCurrentDevice");
  *(void **)&beginFrame = dlsym(library, "hdBeginFrame");
  *(void **)&endFrame = dlsym(library, "hdEndFrame");
  *(void **)&getDoublev = dlsym(library, "hdGetDoublev");
  *(void **)&start = dlsym(library, "hdStartScheduler");
  *(void **)&stop = dlsym(library, "hdStopScheduler");
  *(void **)&synchronous = dlsym(library, "hdScheduleSynchronous");
  *(void **)&lastError = dlsym(library, "hdGetError");
  device = init(0);
  start();
  synchronous(readPosition, 0, 32767);
  stop();
  disable(device);
  printf("dlopen device %u position %.3f %.3f %.3f error %u\n", device, position[0], position[1], position[2], lastError().error);
  dlclose(library);
  return 0;
}
