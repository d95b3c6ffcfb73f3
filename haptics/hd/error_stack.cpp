#include "haptics/hd/error_stack.h"

namespace halsted::haptics::hd {

void ErrorStack::push(HDerror code, HHD device) noexcept {
  const Hold hold(mutex_);
  ring_[top_] = {code, 0, device};
  top_ = (top_ + 1) % kDepth;
  if (count_ < kDepth) ++count_;
}

HDErrorInfo ErrorStack::pop() noexcept {
  const Hold hold(mutex_);
  if (count_ == 0) return {HD_SUCCESS, 0, HD_INVALID_HANDLE};
  --count_;
  top_ = (top_ + kDepth - 1) % kDepth;
  return ring_[top_];
}

const char* errorText(HDerror code) noexcept {
  switch (code) {
    case HD_SUCCESS: return "HD_SUCCESS: no error";
    case HD_INVALID_ENUM: return "HD_INVALID_ENUM: no such parameter, capability or style";
    case HD_INVALID_VALUE: return "HD_INVALID_VALUE: value out of range";
    case HD_INVALID_OPERATION: return "HD_INVALID_OPERATION: not possible in this state";
    case HD_INVALID_INPUT_TYPE: return "HD_INVALID_INPUT_TYPE: the parameter is not of this type";
    case HD_BAD_HANDLE: return "HD_BAD_HANDLE: no open device has this handle";
    case HD_WARM_MOTORS: return "HD_WARM_MOTORS: motors are warm, force is reduced";
    case HD_EXCEEDED_MAX_FORCE: return "HD_EXCEEDED_MAX_FORCE: force above the device's maximum";
    case HD_EXCEEDED_MAX_FORCE_IMPULSE: return "HD_EXCEEDED_MAX_FORCE_IMPULSE: force changed faster than the limit";
    case HD_EXCEEDED_MAX_VELOCITY: return "HD_EXCEEDED_MAX_VELOCITY: device moved faster than the limit";
    case HD_FORCE_ERROR: return "HD_FORCE_ERROR: the commanded force cannot be rendered";
    case HD_DEVICE_FAULT: return "HD_DEVICE_FAULT: device not found or not working";
    case HD_DEVICE_ALREADY_INITIATED: return "HD_DEVICE_ALREADY_INITIATED: device is already open";
    case HD_COMM_ERROR: return "HD_COMM_ERROR: the device does not answer";
    case HD_COMM_CONFIG_ERROR: return "HD_COMM_CONFIG_ERROR: the device's configuration is wrong";
    case HD_TIMER_ERROR: return "HD_TIMER_ERROR: the servo loop could not start";
    case HD_ILLEGAL_BEGIN: return "HD_ILLEGAL_BEGIN: second frame of one device in a tick";
    case HD_ILLEGAL_END: return "HD_ILLEGAL_END: end without begin";
    case HD_FRAME_ERROR: return "HD_FRAME_ERROR: outside a frame, or the frame was not closed";
    case HD_INVALID_PRIORITY: return "HD_INVALID_PRIORITY: priority out of range";
    case HD_SCHEDULER_FULL: return "HD_SCHEDULER_FULL: too many callbacks";
    case HD_INVALID_LICENSE: return "HD_INVALID_LICENSE: licence not valid";
    default: return "unknown error code";
  }
}

}  // namespace halsted::haptics::hd
