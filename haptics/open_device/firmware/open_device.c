#include "open_device.h"

#include <string.h>

static void put16(uint8_t *at, uint16_t value) {
  at[0] = (uint8_t)(value & 0xff);
  at[1] = (uint8_t)(value >> 8);
}

static void put32(uint8_t *at, uint32_t value) {
  put16(at, (uint16_t)(value & 0xffff));
  put16(at + 2, (uint16_t)(value >> 16));
}

static int16_t take16(const uint8_t *at) {
  const uint16_t bits = (uint16_t)(at[0] | at[1] << 8);
  return (int16_t)(bits < 0x8000 ? bits : (int32_t)bits - 0x10000);
}

uint16_t hodChecksum(const uint8_t *bytes, size_t count) {
  uint16_t crc = 0xffff;
  for (size_t i = 0; i < count; ++i) {
    crc = (uint16_t)(crc ^ (uint16_t)bytes[i] << 8);
    for (int bit = 0; bit < 8; ++bit) crc = (uint16_t)(crc & 0x8000 ? crc << 1 ^ 0x1021 : crc << 1);
  }
  return crc;
}

/* Writes the header and the checksum round a payload that already stands at packet + kHodHeader. */
static size_t seal(HodDevice *device, uint8_t type, size_t payload, uint8_t *packet) {
  packet[0] = kHodSync0;
  packet[1] = kHodSync1;
  packet[2] = kHodVersion;
  packet[3] = type;
  packet[4] = device->sequence++;
  packet[5] = (uint8_t)payload;
  put16(packet + kHodHeader + payload, hodChecksum(packet + 2, kHodHeader - 2 + payload));
  return kHodHeader + payload + kHodCheck;
}

void hodBegin(HodDevice *device, const HodIdentity *identity) {
  memset(device, 0, sizeof *device);
  device->identity = *identity;
}

static void letGo(HodDevice *device) {
  device->enabled = 0;
  device->force[0] = device->force[1] = device->force[2] = 0;
}

static int16_t clampForce(int16_t value, uint16_t limit) {
  const int32_t most = limit;
  return (int16_t)(value > most ? most : value < -most ? -most : value);
}

static void acceptForce(HodDevice *device, const uint8_t *frame, uint32_t now) {
  const uint8_t *payload = frame + kHodHeader;
  const uint8_t flags = payload[6];
  const uint8_t before = device->enabled;
  for (int i = 0; i < 3; ++i) device->force[i] = clampForce(take16(payload + 2 * i), device->identity.peakForce);
  device->enabled = flags & kHodEnable ? 1 : 0;
  device->homing = flags & kHodHome ? 1 : 0;
  if (!device->enabled) letGo(device);
  if (device->enabled && (!before || device->tripped)) device->rampStart = now;   /* eases in */
  device->tripped = 0;
  device->streaming = 1;
  device->lastForce = frame[4];
  device->lastCommand = now;
}

static void acceptFrame(HodDevice *device, uint32_t now) {
  const uint8_t *frame = device->buffer;
  if (frame[2] != kHodVersion) {
    letGo(device);
    device->answer = kHodRefused;
    ++device->rejected;
    return;
  }
  ++device->accepted;
  if (frame[3] == kHodHello) {
    letGo(device);
    device->streaming = 0;
    device->answer = kHodIdentity;
  } else if (frame[3] == kHodForce && frame[5] >= kHodForceBytes) {
    acceptForce(device, frame, now);
  } else if (frame[3] == kHodStop) {
    letGo(device);
    device->streaming = 0;
  }                                            /* other types are for later versions: passed over */
}

/* Drops the first byte and what follows it up to the next possible beginning. */
static void resynchronise(HodDevice *device) {
  size_t at = 1;
  ++device->rejected;
  while (at < device->size && device->buffer[at] != kHodSync0) ++at;
  memmove(device->buffer, device->buffer + at, device->size - at);
  device->size -= at;
}

/* Takes one frame, or one wrong beginning, from the buffer; 0 when more bytes are needed. */
static int consume(HodDevice *device, uint32_t now) {
  const uint8_t *b = device->buffer;
  if (device->size >= 1 && b[0] != kHodSync0) return resynchronise(device), 1;
  if (device->size >= 2 && b[1] != kHodSync1) return resynchronise(device), 1;
  if (device->size < kHodHeader) return 0;
  if (b[5] > kHodMaxPayload) return resynchronise(device), 1;
  const size_t whole = (size_t)kHodHeader + b[5] + kHodCheck;
  if (device->size < whole) return 0;
  const uint16_t check = hodChecksum(b + 2, whole - 2 - kHodCheck);
  if (b[whole - 2] != (check & 0xff) || b[whole - 1] != check >> 8) return resynchronise(device), 1;
  acceptFrame(device, now);
  memmove(device->buffer, device->buffer + whole, device->size - whole);
  device->size -= whole;
  return 1;
}

void hodReceive(HodDevice *device, const uint8_t *bytes, size_t count, uint32_t now) {
  for (size_t i = 0; i < count; ++i) {
    device->buffer[device->size++] = bytes[i];
    while (device->size > 0 && consume(device, now)) {}
  }
}

int hodForce(HodDevice *device, uint32_t now, int16_t force[3]) {
  force[0] = force[1] = force[2] = 0;
  const uint32_t silence = now - device->lastCommand;
  if (device->streaming && silence > kHodSilenceMicroseconds) device->streaming = 0;
  if (!device->enabled) return 0;
  if (silence > kHodWatchdogMicroseconds) {
    letGo(device);
    device->tripped = 1;
    return 0;
  }
  if (!device->homed) return 0;
  const uint32_t ramp = now - device->rampStart;
  const int32_t share = ramp >= kHodRampMicroseconds ? 1000 : (int32_t)(ramp / (kHodRampMicroseconds / 1000));
  for (int i = 0; i < 3; ++i) force[i] = (int16_t)(device->force[i] * share / 1000);
  return 1;
}

static size_t sayIdentity(HodDevice *device, uint8_t *packet) {
  const HodIdentity *id = &device->identity;
  uint8_t *p = packet + kHodHeader;
  memset(p, 0, kHodIdentityBytes);
  p[0] = p[1] = kHodVersion;                   /* oldest and newest that it speaks */
  const uint16_t numbers[6] = {id->firmware, id->rate, id->peakForce, id->continuousForce, id->stiffness, id->positionStep};
  for (int i = 0; i < 6; ++i) put16(p + 2 + 2 * i, numbers[i]);
  p[14] = 3;                                   /* axes with force */
  memcpy(p + 16, id->serial, 16);
  return seal(device, kHodIdentity, kHodIdentityBytes, packet);
}

size_t hodState(HodDevice *device, const HodSample *sample, uint32_t now, uint8_t *packet) {
  const uint8_t owed = device->answer;
  uint8_t *p = packet + kHodHeader;
  device->homed = sample->status & kHodHomed ? 1 : 0;
  device->answer = 0;
  if (owed == kHodIdentity) return sayIdentity(device, packet);
  if (owed == kHodRefused) {
    p[0] = p[1] = kHodVersion;
    return seal(device, kHodRefused, kHodRefusedBytes, packet);
  }
  if (!device->streaming) return 0;
  put32(p, now);
  for (int i = 0; i < 3; ++i) put32(p + 4 + 4 * i, (uint32_t)sample->position[i]);
  for (int i = 0; i < 4; ++i) put16(p + 16 + 2 * i, (uint16_t)sample->orientation[i]);
  put16(p + 24, sample->jaw);
  put16(p + 26, sample->buttons);
  p[28] = (uint8_t)((sample->status & (kHodHomed | kHodHot | kHodFault)) | (device->enabled ? kHodForceOn : 0) |
                    (device->tripped ? kHodWatchdog : 0));
  p[29] = device->lastForce;
  return seal(device, kHodState, kHodStateBytes, packet);
}
