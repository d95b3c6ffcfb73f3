/// Devices, frames, errors, licence.
#include <HD/hd.h>

#include <cstdio>
#include <exception>

#include "haptics/hd/session.h"

using namespace halsted::haptics::hd;

namespace {

HHD fail(Session& session, HDerror code) {
  session.raise(code);
  return HD_INVALID_HANDLE;
}

/// One line on stderr says what is wrong with a file or a variable; the program gets the code.
HHD failWith(Session& session, HDerror code, const char* why) {
  std::fprintf(stderr, "halsted HD: %s\n", why);
  return fail(session, code);
}

HHD openDevice(Session& session, const char* name) {
  const Hold hold(session.opening);
  const Settings settings = readSettings();
  const DeviceSettings* wanted = findDevice(settings, name);
  if (!wanted) return fail(session, HD_DEVICE_FAULT);
  HHD handle = HD_INVALID_HANDLE;
  for (HHD i = Session::kMaxDevices; i-- > 0;) {
    if (!session.devices[i].isOpen()) handle = i;
    else if (session.devices[i].isNamed(wanted->name)) return fail(session, HD_DEVICE_ALREADY_INITIATED);
  }
  if (handle == HD_INVALID_HANDLE) return fail(session, HD_DEVICE_FAULT);
  session.devices[handle].open(*wanted, session.now());
  session.makeCurrent(handle);
  return handle;
}

}  // namespace

extern "C" {

HHD hdInitDevice(HDstring pConfigName) {
  Session& session = Session::instance();
  try {
    return openDevice(session, pConfigName);
  } catch (const SettingsError& error) {
    return failWith(session, HD_COMM_CONFIG_ERROR, error.what());
  } catch (const MotionError& error) {
    return failWith(session, HD_COMM_CONFIG_ERROR, error.what());
  } catch (const std::exception& error) {
    return failWith(session, HD_DEVICE_FAULT, error.what());
  }
}

void hdDisableDevice(HHD hHD) {
  Session& session = Session::instance();
  const Hold hold(session.opening);
  OpenDevice* device = session.find(hHD);
  if (!device || !device->close()) session.raise(HD_BAD_HANDLE);
}

void hdMakeCurrentDevice(HHD hHD) {
  Session& session = Session::instance();
  if (session.find(hHD)) session.makeCurrent(hHD);
  else session.raise(HD_BAD_HANDLE);
}

HHD hdGetCurrentDevice(void) {
  Session& session = Session::instance();
  const HHD current = session.currentDevice();
  if (current == HD_INVALID_HANDLE) session.raise(HD_INVALID_OPERATION);
  return current;
}

void hdBeginFrame(HHD hHD) {
  Session& session = Session::instance();
  OpenDevice* device = session.find(hHD);
  const HDerror error = device ? device->beginFrame(session.now()) : static_cast<HDerror>(HD_BAD_HANDLE);
  if (error != HD_BAD_HANDLE) session.makeCurrent(hHD);
  if (error != HD_SUCCESS) session.raise(error);
}

void hdEndFrame(HHD hHD) {
  Session& session = Session::instance();
  OpenDevice* device = session.find(hHD);
  std::uint32_t forceErrors = 0;
  const HDerror error = device ? device->endFrame(session.now(), forceErrors) : static_cast<HDerror>(HD_BAD_HANDLE);
  if (error != HD_SUCCESS) session.raise(error);
  session.raiseForceErrors(forceErrors, hHD);
}

HDErrorInfo hdGetError(void) { return Session::instance().errors.pop(); }
HDstring hdGetErrorString(HDerror errorCode) { return errorText(errorCode); }

HDboolean hdDeploymentLicense(const char*, const char*, const char*) { return HD_TRUE; }

}  // extern "C"
