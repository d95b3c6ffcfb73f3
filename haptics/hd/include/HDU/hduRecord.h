/* Writes what a device does, a line a tick, once the ticks are over. */
#ifndef HALSTED_HDU_RECORD_H
#define HALSTED_HDU_RECORD_H

#include <stdio.h>

#include <HD/hd.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Called every tick of a recording, on the servo thread: text of the program's own, appended to the line; may be null. */
typedef char *(HDCALLBACK *HDURecordCallback)(void *pUserData);

/* Records nData ticks of the current device: time since the first tick [s], position [mm], force [N]. HD_FALSE when it cannot start;
   the file belongs to the library until the lines are in it and is not closed. */
HDboolean hduStartRecord(FILE *file, HDURecordCallback pCallback, void *pCallbackData, unsigned int nData);

#ifdef __cplusplus
}
#endif

#endif
