#!/usr/bin/env python3
"""Logs what a device does to a CSV file: touch_logger.py LIBRARY SECONDS FILE. Written against the documented C interface only."""
import csv
import ctypes as ct
import sys
import time
from ctypes import byref

HD_CURRENT_BUTTONS, HD_CURRENT_POSITION, HD_CURRENT_VELOCITY = 0x2000, 0x2050, 0x2051
HD_CURRENT_TRANSFORM, HD_CURRENT_JOINT_ANGLES, HD_LAST_POSITION = 0x2052, 0x2100, 0x2250
HD_CURRENT_FORCE, HD_INSTANTANEOUS_UPDATE_RATE, HD_FORCE_OUTPUT = 0x2700, 0x2601, 0x4000


class HDErrorInfo(ct.Structure):
    _fields_ = [("errorCode", ct.c_uint), ("internalErrorCode", ct.c_int), ("hHD", ct.c_uint)]


class Touch:
    def __init__(self, library, name=None):
        self.hd = hd = ct.CDLL(library)
        hd.hdInitDevice.argtypes, hd.hdInitDevice.restype = [ct.c_char_p], ct.c_uint
        hd.hdGetError.restype = HDErrorInfo
        hd.hdGetErrorString.argtypes, hd.hdGetErrorString.restype = [ct.c_uint], ct.c_char_p
        hd.hdGetDoublev.argtypes = hd.hdSetDoublev.argtypes = [ct.c_uint, ct.POINTER(ct.c_double)]
        hd.hdGetIntegerv.argtypes = [ct.c_uint, ct.POINTER(ct.c_int)]
        hd.hdGetFloatv.argtypes = [ct.c_uint, ct.POINTER(ct.c_float)]
        hd.hdScheduleAsynchronous.restype = ct.c_ulong
        hd.hdUnschedule.argtypes = [ct.c_ulong]
        hd.hdGetSchedulerTimeStamp.restype = ct.c_double
        self.handle = hd.hdInitDevice(name)
        self.check("init")
        self.rows, self.late = [], 0
        self.callback = ct.CFUNCTYPE(ct.c_uint, ct.c_void_p)(self.tick)

    def check(self, doing):
        error = self.hd.hdGetError()
        if error.errorCode:
            raise RuntimeError(f"{doing}: {self.hd.hdGetErrorString(error.errorCode).decode()}")

    def vector(self, name, count=3):
        values = (ct.c_double * count)()
        self.hd.hdGetDoublev(name, values)
        return list(values)

    def tick(self, _):
        hd = self.hd
        hd.hdBeginFrame(self.handle)
        position, velocity = self.vector(HD_CURRENT_POSITION), self.vector(HD_CURRENT_VELOCITY)
        buttons = ct.c_int()
        hd.hdGetIntegerv(HD_CURRENT_BUTTONS, byref(buttons))
        force = [-0.05 * x for x in position]
        hd.hdSetDoublev(HD_CURRENT_FORCE, (ct.c_double * 3)(*force))
        hd.hdEndFrame(self.handle)
        self.late += hd.hdGetSchedulerTimeStamp() > 1e-3
        self.rows.append([len(self.rows), *position, *velocity, *self.vector(HD_CURRENT_JOINT_ANGLES), buttons.value, *force])
        return 1

    def run(self, seconds):
        self.hd.hdEnable(HD_FORCE_OUTPUT)
        scheduled = self.hd.hdScheduleAsynchronous(self.callback, None, ct.c_ushort(65535))
        self.hd.hdStartScheduler()
        self.check("start")
        time.sleep(seconds)
        rate = (ct.c_float * 1)()
        self.hd.hdGetFloatv(HD_INSTANTANEOUS_UPDATE_RATE, rate)
        self.hd.hdStopScheduler()
        self.hd.hdUnschedule(scheduled)
        self.check("stop")
        return rate[0]

    def close(self):
        self.hd.hdDisableDevice(self.handle)
        self.check("close")


def main():
    touch = Touch(sys.argv[1])
    rate = touch.run(float(sys.argv[2]))
    touch.close()
    header = "tick x_mm y_mm z_mm vx vy vz j1 j2 j3 buttons fx fy fz".split()
    with open(sys.argv[3], "w", newline="") as file:
        csv.writer(file).writerows([header, *touch.rows])
    reach = max(row[1] for row in touch.rows)
    pressed = sum(1 for a, b in zip(touch.rows, touch.rows[1:]) if b[10] & ~a[10])
    print(f"rows {len(touch.rows)} reach {reach:.1f} presses {pressed} rate {'ok' if rate > 0 else rate}")


if __name__ == "__main__":
    main()
