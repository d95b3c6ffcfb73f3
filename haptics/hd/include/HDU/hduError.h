/* Printing and sorting of errors. */
#ifndef HALSTED_HDU_ERROR_H
#define HALSTED_HDU_ERROR_H

#include <stdio.h>

#include <HD/hd.h>

#ifdef __cplusplus
#include <ostream>
extern "C" {
#endif

/* One line: message, name of the error, device, internal code. */
void hduPrintError(FILE *stream, const HDErrorInfo *error, const char *message);

/* Forces were cut by the error: warm motors, too much force or speed, no renderable force. */
HDboolean hduIsForceError(const HDErrorInfo *error);

/* The servo loop or the line to the device is broken. */
HDboolean hduIsSchedulerError(const HDErrorInfo *error);

#ifdef __cplusplus
}

inline std::ostream &operator<<(std::ostream &os, const HDErrorInfo &error) {
  return os << hdGetErrorString(error.errorCode) << " (device " << error.hHD << ", internal " << error.internalErrorCode << ")";
}
#endif

#endif
