/* Calling conventions. x86-64 Linux has one, so a callback needs no mark; programs write HDCALLBACK all the same.
   Nothing here asks whether `linux` is defined: strict -std modes leave it out, and some programs define it themselves, empty. */
#ifndef HALSTED_HD_COMPILER_CONFIG_H
#define HALSTED_HD_COMPILER_CONFIG_H

#ifndef HDCALLBACK
#define HDCALLBACK
#endif

#include <stddef.h> /* NULL, as HD_DEFAULT_DEVICE */

#endif
