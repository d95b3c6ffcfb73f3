/* Devices, frames, state, capabilities, calibration, errors. What each call does: haptics/hd/README.md. */
#ifndef HALSTED_HD_DEVICE_H
#define HALSTED_HD_DEVICE_H

#include <HD/hdDefines.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Devices. The one that was opened, begun or made current last is the current one of the calling thread. */
HDAPI HHD HDAPIENTRY hdInitDevice(HDstring pConfigName);
HDAPI void HDAPIENTRY hdDisableDevice(HHD hHD);
HDAPI void HDAPIENTRY hdMakeCurrentDevice(HHD hHD);
HDAPI HHD HDAPIENTRY hdGetCurrentDevice(void);

/* Frames: begin takes a snapshot of the device, end sends what was commanded. */
HDAPI void HDAPIENTRY hdBeginFrame(HHD hHD);
HDAPI void HDAPIENTRY hdEndFrame(HHD hHD);

/* Errors: a stack of the whole process, the last one first; HD_SUCCESS when it is empty. */
HDAPI HDErrorInfo HDAPIENTRY hdGetError(void);
HDAPI HDstring HDAPIENTRY hdGetErrorString(HDerror errorCode);

/* Capabilities of the current device. */
HDAPI void HDAPIENTRY hdEnable(HDenum cap);
HDAPI void HDAPIENTRY hdDisable(HDenum cap);
HDAPI HDboolean HDAPIENTRY hdIsEnabled(HDenum cap);

/* State of the current device. A call that raises an error leaves `params` as it was. */
HDAPI void HDAPIENTRY hdGetBooleanv(HDenum pname, HDboolean *params);
HDAPI void HDAPIENTRY hdGetIntegerv(HDenum pname, HDint *params);
HDAPI void HDAPIENTRY hdGetFloatv(HDenum pname, HDfloat *params);
HDAPI void HDAPIENTRY hdGetDoublev(HDenum pname, HDdouble *params);
HDAPI void HDAPIENTRY hdGetLongv(HDenum pname, HDlong *params);
HDAPI HDstring HDAPIENTRY hdGetString(HDenum pname);

HDAPI void HDAPIENTRY hdSetBooleanv(HDenum pname, const HDboolean *params);
HDAPI void HDAPIENTRY hdSetIntegerv(HDenum pname, const HDint *params);
HDAPI void HDAPIENTRY hdSetFloatv(HDenum pname, const HDfloat *params);
HDAPI void HDAPIENTRY hdSetDoublev(HDenum pname, const HDdouble *params);
HDAPI void HDAPIENTRY hdSetLongv(HDenum pname, const HDlong *params);

/* Calibration of the current device. */
HDAPI HDenum HDAPIENTRY hdCheckCalibration(void);
HDAPI HDenum HDAPIENTRY hdCheckCalibrationStyle(void);
HDAPI void HDAPIENTRY hdUpdateCalibration(HDenum style);
HDAPI void HDAPIENTRY hdUpdateCalibrationMessage(HDenum style);

/* The current transform with its gimbal angles multiplied by the three scales; column-major. */
HDAPI void HDAPIENTRY hdScaleGimbalAngles(HDdouble scaleX, HDdouble scaleY, HDdouble scaleZ, HDdouble nT[16]);

/* Any licence is accepted: this library asks for none. */
HDAPI HDboolean HDAPIENTRY hdDeploymentLicense(const char *vendorName, const char *applicationName, const char *password);

#ifdef __cplusplus
}
#endif

#endif
