#pragma once
/// Which parameter is what: its type, its count, where it comes from, whether it can be set. Under the device's lock; no heap.
#include "haptics/hd/open_device.h"

namespace halsted::haptics::hd {

enum class ValueType { kBoolean, kInteger, kLong, kReal };

struct Value {
  ValueType type = ValueType::kReal;
  int count = 0;
  double real[36] = {};                        // [1] unit by parameter, of the HD API
  long whole[6] = {};
};

/// HD_INVALID_ENUM when there is no such parameter to read.
HDerror readParameter(HDenum name, const OpenDevice::View&, Value&) noexcept;

/// Type and count that a parameter is set with; HD_INVALID_ENUM when it cannot be set.
HDerror settableParameter(HDenum name, Value&) noexcept;
HDerror writeParameter(HDenum name, const Value&, const OpenDevice::View&) noexcept;

/// 0 when there is no such capability.
std::uint32_t capabilityBit(HDenum name) noexcept;

}  // namespace halsted::haptics::hd
