/* The HD API: all of it. */
#ifndef HALSTED_HD_H
#define HALSTED_HD_H

#define HD_VERSION_MAJOR 3
#define HD_VERSION_MINOR 30
#define HD_VERSION_BUILD 0
#define HD_VERSION_MAJOR_NUMBER HD_VERSION_MAJOR
#define HD_VERSION_MINOR_NUMBER HD_VERSION_MINOR
#define HD_VERSION_BUILD_NUMBER HD_VERSION_BUILD

#include <HD/hdCompilerConfig.h>
#include <HD/hdExport.h>

#include <HD/hdDefines.h>

#include <HD/hdDevice.h>
#include <HD/hdScheduler.h>

#endif
