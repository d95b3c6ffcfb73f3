/// hdGet*, hdSet*, capabilities, calibration, gimbal.
#include <HD/hd.h>

#include <cmath>
#include <type_traits>

#include "haptics/hd/parameters.h"
#include "haptics/hd/session.h"

using namespace halsted;
using namespace halsted::haptics;
using namespace halsted::haptics::hd;

namespace {

/// Integers and truth values are read as int, long or boolean; encoders and DAC values as int or long; all else as float or double.
template <class T> constexpr bool fits(ValueType type, int count) {
  if (std::is_floating_point_v<T>) return type == ValueType::kReal;
  if (std::is_same_v<T, HDboolean>) return type == ValueType::kBoolean || (type == ValueType::kInteger && count == 1);
  return type != ValueType::kReal;
}

/// On the current device; HD_INVALID_OPERATION when there is none.
template <class Call> HDerror onCurrent(Session& session, Call&& call) {
  OpenDevice* device = session.find(session.currentDevice());
  return device ? device->with(call) : static_cast<HDerror>(HD_INVALID_OPERATION);
}

void raiseIf(Session& session, HDerror code) {
  if (code != HD_SUCCESS) session.raise(code);
}

/// Rates belong to the scheduler: readable as any number, with or without a device.
template <class T> bool readRate(const Session& session, HDenum name, T* out) {
  if (std::is_same_v<T, HDboolean>) return false;
  if (name == HD_UPDATE_RATE) *out = static_cast<T>(session.servo.rate());
  else if (name == HD_INSTANTANEOUS_UPDATE_RATE) *out = static_cast<T>(std::lround(session.servo.measuredRate() * 1e3) * 1e-3);
  else return false;
  return true;
}

template <class T> void read(HDenum name, T* out) {
  Session& session = Session::instance();
  if (!out) return session.raise(HD_INVALID_VALUE);
  if (readRate(session, name, out)) return;
  Value value;
  HDerror error = onCurrent(session, [&](const OpenDevice::View& device) { return readParameter(name, device, value); });
  if (error == HD_SUCCESS && !fits<T>(value.type, value.count)) error = HD_INVALID_INPUT_TYPE;
  if (error != HD_SUCCESS) return session.raise(error);
  for (int i = 0; i < value.count; ++i)
    out[i] = value.type == ValueType::kReal ? static_cast<T>(value.real[i]) : static_cast<T>(value.whole[i]);
}

template <class T> void write(HDenum name, const T* in) {
  Session& session = Session::instance();
  if (!in) return session.raise(HD_INVALID_VALUE);
  Value value;
  HDerror error = settableParameter(name, value);
  if (error == HD_SUCCESS && !fits<T>(value.type, value.count)) error = HD_INVALID_INPUT_TYPE;
  if (error != HD_SUCCESS) return session.raise(error);
  for (int i = 0; i < value.count; ++i) {
    if constexpr (std::is_floating_point_v<T>) value.real[i] = in[i];
    else value.whole[i] = in[i];
  }
  raiseIf(session, onCurrent(session, [&](const OpenDevice::View& device) { return writeParameter(name, value, device); }));
}

/// Changes a capability; returns what it was.
bool change(HDenum name, bool on) {
  Session& session = Session::instance();
  const std::uint32_t bit = capabilityBit(name);
  if (bit == 0) {
    session.raise(HD_INVALID_ENUM);
    return on;
  }
  bool before = on;
  raiseIf(session, onCurrent(session, [&](const OpenDevice::View& device) {
            before = (device.capabilities & bit) != 0;
            device.capabilities = on ? device.capabilities | bit : device.capabilities & ~bit;
            return static_cast<HDerror>(HD_SUCCESS);
          }));
  return before;
}

constexpr HDenum kStyles = HD_CALIBRATION_ENCODER_RESET | HD_CALIBRATION_AUTO | HD_CALIBRATION_INKWELL;

HDerror calibrate(HDenum style, const OpenDevice::View& device) {
  if (style == 0 || (style & ~kStyles) != 0) return HD_INVALID_ENUM;
  if ((style & device.calibrationStyle) == 0) return HD_INVALID_OPERATION;
  const bool needsInkwell = (style & device.calibrationStyle) == HD_CALIBRATION_INKWELL;
  if (!device.calibrated && needsInkwell && !device.docked) return HD_INVALID_OPERATION;
  device.calibrated = true;
  return HD_SUCCESS;
}

}  // namespace

extern "C" {

void hdGetBooleanv(HDenum pname, HDboolean* params) { read(pname, params); }
void hdGetIntegerv(HDenum pname, HDint* params) { read(pname, params); }
void hdGetFloatv(HDenum pname, HDfloat* params) { read(pname, params); }
void hdGetDoublev(HDenum pname, HDdouble* params) { read(pname, params); }
void hdGetLongv(HDenum pname, HDlong* params) { read(pname, params); }

void hdSetBooleanv(HDenum pname, const HDboolean* params) { write(pname, params); }
void hdSetIntegerv(HDenum pname, const HDint* params) { write(pname, params); }
void hdSetFloatv(HDenum pname, const HDfloat* params) { write(pname, params); }
void hdSetDoublev(HDenum pname, const HDdouble* params) { write(pname, params); }
void hdSetLongv(HDenum pname, const HDlong* params) { write(pname, params); }

HDstring hdGetString(HDenum pname) {
  Session& session = Session::instance();
  if (pname == HD_VERSION) return "3.30.0";
  HDstring text = "";
  const HDerror error = onCurrent(session, [&](const OpenDevice::View& device) -> HDerror {
    Value value;
    switch (pname) {
      case HD_DEVICE_MODEL_TYPE: text = device.model; return HD_SUCCESS;
      case HD_DEVICE_DRIVER_VERSION: text = HALSTED_VERSION; return HD_SUCCESS;
      case HD_DEVICE_VENDOR: text = "Halsted (virtual device)"; return HD_SUCCESS;
      case HD_DEVICE_SERIAL_NUMBER: text = device.serial; return HD_SUCCESS;
      default: return readParameter(pname, device, value) == HD_SUCCESS ? HD_INVALID_INPUT_TYPE : HD_INVALID_ENUM;
    }
  });
  raiseIf(session, error);
  return text;
}

void hdEnable(HDenum cap) {
  const bool before = change(cap, true);
  if (cap != HD_FORCE_OUTPUT || before) return;
  Session& session = Session::instance();
  if (OpenDevice* device = session.find(session.currentDevice())) device->engage();
}

void hdDisable(HDenum cap) { change(cap, false); }

HDboolean hdIsEnabled(HDenum cap) {
  Session& session = Session::instance();
  const std::uint32_t bit = capabilityBit(cap);
  bool on = false;
  const HDerror error = bit == 0 ? static_cast<HDerror>(HD_INVALID_ENUM) : onCurrent(session, [&](const OpenDevice::View& device) {
    on = (device.capabilities & bit) != 0;
    return static_cast<HDerror>(HD_SUCCESS);
  });
  raiseIf(session, error);
  return on ? HD_TRUE : HD_FALSE;
}

HDenum hdCheckCalibration(void) {
  Session& session = Session::instance();
  HDenum status = HD_CALIBRATION_NEEDS_MANUAL_INPUT;
  raiseIf(session, onCurrent(session, [&](const OpenDevice::View& device) {
            const bool byHand = device.calibrationStyle == HD_CALIBRATION_INKWELL && !device.docked;
            status = device.calibrated ? HD_CALIBRATION_OK : byHand ? HD_CALIBRATION_NEEDS_MANUAL_INPUT : HD_CALIBRATION_NEEDS_UPDATE;
            return static_cast<HDerror>(HD_SUCCESS);
          }));
  return status;
}

HDenum hdCheckCalibrationStyle(void) {
  Session& session = Session::instance();
  HDenum style = 0;
  raiseIf(session, onCurrent(session, [&](const OpenDevice::View& device) {
            style = device.calibrationStyle;
            return static_cast<HDerror>(HD_SUCCESS);
          }));
  return style;
}

void hdUpdateCalibration(HDenum style) {
  Session& session = Session::instance();
  raiseIf(session, onCurrent(session, [&](const OpenDevice::View& device) { return calibrate(style, device); }));
}

void hdUpdateCalibrationMessage(HDenum style) { hdUpdateCalibration(style); }

void hdScaleGimbalAngles(HDdouble scaleX, HDdouble scaleY, HDdouble scaleZ, HDdouble nT[16]) {
  Session& session = Session::instance();
  if (!nT) return session.raise(HD_INVALID_VALUE);
  raiseIf(session, onCurrent(session, [&](const OpenDevice::View& device) {
            const DeviceState& state = device.current;
            const TouchJoints joints(state.jointAngles[0], state.jointAngles[1], state.jointAngles[2]);
            const TouchGimbal gimbal(state.gimbalAngles[0] * scaleX, state.gimbalAngles[1] * scaleY, state.gimbalAngles[2] * scaleZ);
            const Vec3 position = Vec3(state.position[0], state.position[1], state.position[2]) * 1e-3;
            writeTransform(position, touchOrientation(joints, gimbal), nT);
            return static_cast<HDerror>(HD_SUCCESS);
          }));
}

}  // extern "C"
