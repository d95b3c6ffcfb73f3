/* Linkage of the HD functions: plain C, default visibility. The macros are empty for a program that uses the library. */
#ifndef HALSTED_HD_EXPORT_H
#define HALSTED_HD_EXPORT_H

#if defined(HALSTED_HD_BUILD) && defined(__GNUC__)
#define HDAPI __attribute__((visibility("default")))
#else
#define HDAPI
#endif

#ifndef HDAPIENTRY
#define HDAPIENTRY
#endif

#endif
