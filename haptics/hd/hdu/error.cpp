/// hduPrintError and the two questions about an error. No C++ library in it.
#include <HDU/hduError.h>

extern "C" {

void hduPrintError(FILE* stream, const HDErrorInfo* error, const char* message) {
  if (!stream || !error) return;
  fprintf(stream, "%s: %s (device %u, internal %d)\n", message ? message : "HD error", hdGetErrorString(error->errorCode), error->hHD,
          error->internalErrorCode);
  fflush(stream);
}

HDboolean hduIsForceError(const HDErrorInfo* error) {
  switch (error->errorCode) {
    case HD_WARM_MOTORS:
    case HD_EXCEEDED_MAX_FORCE:
    case HD_EXCEEDED_MAX_VELOCITY:
    case HD_FORCE_ERROR: return HD_TRUE;
    default: return HD_FALSE;
  }
}

HDboolean hduIsSchedulerError(const HDErrorInfo* error) {
  switch (error->errorCode) {
    case HD_COMM_ERROR:
    case HD_COMM_CONFIG_ERROR:
    case HD_TIMER_ERROR:
    case HD_INVALID_PRIORITY:
    case HD_SCHEDULER_FULL: return HD_TRUE;
    default: return HD_FALSE;
  }
}

}  // extern "C"
