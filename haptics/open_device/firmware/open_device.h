#ifndef HALSTED_OPEN_DEVICE_H
#define HALSTED_OPEN_DEVICE_H
/* The device's side of the open wire protocol (../PROTOCOL.md), for a microcontroller or a host: C99, no heap, no floating point, no
 * library but <stdint.h>, <stddef.h> and memcpy. One context; call everything from the same loop or interrupt level.
 *
 * The loop of a device:
 *   whenever bytes arrive     hodReceive(&device, bytes, count, now);
 *   once a servo period       hodForce(&device, now, force);  drive the motors with `force`, always, also when it is zero
 *                             count = hodState(&device, &sample, now, packet);  send `count` bytes, when there are any */
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  kHodVersion = 1,
  kHodSync0 = 0xC3, kHodSync1 = 0x5A,
  kHodHeader = 6, kHodCheck = 2, kHodMaxPayload = 56, kHodMaxFrame = 64,
  kHodHello = 0x01, kHodForce = 0x02, kHodStop = 0x03,
  kHodIdentity = 0x81, kHodState = 0x82, kHodRefused = 0x83,
  kHodIdentityBytes = 32, kHodStateBytes = 30, kHodForceBytes = 8, kHodRefusedBytes = 2
};
enum { kHodEnable = 1, kHodHome = 2 };                                        /* flags of FORCE */
enum { kHodHomed = 1, kHodForceOn = 2, kHodWatchdog = 4, kHodHot = 8, kHodFault = 16 };   /* status of STATE */
enum { kHodWatchdogMicroseconds = 10000, kHodRampMicroseconds = 100000, kHodSilenceMicroseconds = 100000 };

typedef struct {
  uint16_t firmware;              /* version of the device's own program */
  uint16_t rate;                  /* Hz, of STATE */
  uint16_t peakForce;             /* mN */
  uint16_t continuousForce;       /* mN */
  uint16_t stiffness;             /* N/m that it shows without buzzing */
  uint16_t positionStep;          /* 0.1 um */
  char serial[16];                /* printable, zero padded; must be its own */
} HodIdentity;

typedef struct {
  int32_t position[3];            /* 0.1 um; x right, y up, z toward the user, origin in the middle of the workspace */
  int16_t orientation[4];         /* w x y z, 32767 = 1 */
  uint16_t jaw;                   /* 0 closed, 65535 open */
  uint16_t buttons;               /* bit 0 closes the jaws */
  uint8_t status;                 /* kHodHomed, kHodHot, kHodFault: the device knows; the others are filled in */
} HodSample;

typedef struct {
  HodIdentity identity;
  uint8_t buffer[kHodMaxFrame];
  size_t size;
  uint8_t answer;                 /* type of the frame that is owed: identity or refused, else 0 */
  uint8_t sequence, lastForce;
  uint8_t streaming, enabled, homing, tripped, homed;
  int16_t force[3];               /* mN, as commanded and clamped */
  uint32_t lastCommand;           /* us */
  uint32_t rampStart;             /* us */
  uint32_t accepted, rejected;    /* frames */
} HodDevice;

void hodBegin(HodDevice *device, const HodIdentity *identity);
void hodReceive(HodDevice *device, const uint8_t *bytes, size_t count, uint32_t now);
/* The force that the motors may show now, mN. Returns 1 when it is allowed to be other than zero. */
int hodForce(HodDevice *device, uint32_t now, int16_t force[3]);
/* One packet to send, or 0 bytes. `packet` holds kHodMaxFrame. */
size_t hodState(HodDevice *device, const HodSample *sample, uint32_t now, uint8_t *packet);

uint16_t hodChecksum(const uint8_t *bytes, size_t count);      /* CRC-16/CCITT-FALSE */

#ifdef __cplusplus
}
#endif
#endif
