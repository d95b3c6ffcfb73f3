#pragma once
/// The FTDI serial chip that sits in some devices: its control requests, and the two modem status bytes that begin every IN packet.
#include "haptics/usb/usb.h"

namespace halsted::haptics {

inline constexpr std::uint8_t kFtdiRequestType = 0x40;           // vendor request, host to device
enum FtdiRequest : std::uint8_t { kFtdiReset = 0, kFtdiModem = 1, kFtdiFlow = 2, kFtdiBaud = 3, kFtdiData = 4, kFtdiLatency = 9 };
inline constexpr std::uint16_t kFtdiPurgeIn = 1, kFtdiPurgeOut = 2;
inline constexpr std::uint16_t kFtdiDtrHigh = 0x0101, kFtdiDtrLow = 0x0100, kFtdiRtsHigh = 0x0202, kFtdiRtsLow = 0x0200;
inline constexpr std::uint16_t kFtdiBaud9600 = 0x4138, kFtdiBaud140000 = 0x15, kFtdiBaud1500000 = 2;   // divisors
inline constexpr std::uint16_t kFtdi8n1 = 8;
inline constexpr std::size_t kFtdiStatusBytes = 2, kFtdiPacket = 64, kFtdiPayload = 62;

UsbStatus ftdiSet(UsbLink&, FtdiRequest, std::uint16_t value);
UsbStatus ftdiPurge(UsbLink&);
/// Fills `bytes` from the serial stream, over as many packets as it takes; `got` says how many came.
struct FtdiIn {
  std::uint8_t endpoint = 0x81;
  double timeout = 50e-3;                      // [s] for each packet
  int patience = 20;                           // packets of status only, one each latency period, until the device has nothing to say
};
UsbStatus ftdiRead(UsbLink&, const FtdiIn&, std::span<std::uint8_t> bytes, std::size_t& got);

}  // namespace halsted::haptics
