/// hduStartRecord. No C++ library in it.
#include <HDU/hduRecord.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

namespace {

constexpr unsigned kTextSize = 64;

struct Line {
  double time;      // [s]
  double position[3];  // [mm]
  double force[3];     // [N]
  char text[kTextSize];
};

struct Recording {
  FILE* file;
  HDURecordCallback callback;
  void* data;
  HHD device;
  unsigned count, next;
  Line* lines;
};

double now() {
  timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void write(const Recording& recording) {
  for (unsigned i = 0; i < recording.count; ++i) {
    const Line& line = recording.lines[i];
    fprintf(recording.file, "%.6f %.4f %.4f %.4f %.4f %.4f %.4f%s%s\n", line.time - recording.lines[0].time, line.position[0],
            line.position[1], line.position[2], line.force[0], line.force[1], line.force[2], line.text[0] ? " " : "", line.text);
  }
  fflush(recording.file);
}

/// Lowest priority: after the tick's other callbacks. Its own frame only when they opened none.
HDCallbackCode HDCALLBACK recordTick(void* data) {
  Recording& recording = *static_cast<Recording*>(data);
  Line& line = recording.lines[recording.next];
  hdMakeCurrentDevice(recording.device);
  line.time = now();
  hdGetDoublev(HD_CURRENT_POSITION, line.position);
  hdGetDoublev(HD_CURRENT_FORCE, line.force);
  const char* text = recording.callback ? recording.callback(recording.data) : nullptr;
  if (text) strncpy(line.text, text, kTextSize - 1);
  if (++recording.next < recording.count) return HD_CALLBACK_CONTINUE;
  write(recording);  // this one tick lasts as long as the writing
  free(recording.lines);
  free(&recording);
  return HD_CALLBACK_DONE;
}

}  // namespace

extern "C" HDboolean hduStartRecord(FILE* file, HDURecordCallback pCallback, void* pCallbackData, unsigned int nData) {
  const HHD device = hdGetCurrentDevice();
  if (!file || nData == 0 || device == HD_INVALID_HANDLE) return HD_FALSE;
  auto* recording = static_cast<Recording*>(malloc(sizeof(Recording)));
  auto* lines = static_cast<Line*>(calloc(nData, sizeof(Line)));
  if (recording && lines) {
    *recording = {file, pCallback, pCallbackData, device, nData, 0, lines};
    if (hdScheduleAsynchronous(recordTick, recording, HD_MIN_SCHEDULER_PRIORITY) != HD_INVALID_HANDLE) return HD_TRUE;
  }
  free(recording);
  free(lines);
  return HD_FALSE;
}
