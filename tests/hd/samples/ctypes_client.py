"""The library from Python. argv[1]: the library."""
import ctypes
import sys


class ErrorInfo(ctypes.Structure):
    _fields_ = [("errorCode", ctypes.c_uint), ("internalErrorCode", ctypes.c_int), ("hHD", ctypes.c_uint)]


hd = ctypes.CDLL(sys.argv[1])
hd.hdInitDevice.restype = ctypes.c_uint
hd.hdGetError.restype = ErrorInfo
hd.hdGetString.restype = ctypes.c_char_p
hd.hdScheduleAsynchronous.restype = ctypes.c_ulong
CALLBACK = ctypes.CFUNCTYPE(ctypes.c_uint, ctypes.c_void_p)

position = (ctypes.c_double * 3)()
ticks = 0


@CALLBACK
def servo(_):
    global ticks
    hd.hdBeginFrame(hd.hdGetCurrentDevice())
    hd.hdGetDoublev(0x2050, position)
    hd.hdEndFrame(hd.hdGetCurrentDevice())
    ticks += 1
    return 1 if ticks < 100 else 0


device = hd.hdInitDevice(None)
assert hd.hdGetError().errorCode == 0
model = hd.hdGetString(0x2501).decode()
handle = hd.hdScheduleAsynchronous(servo, None, ctypes.c_ushort(32767))
hd.hdStartScheduler()
hd.hdWaitForCompletion.restype = ctypes.c_ubyte
waited = hd.hdWaitForCompletion(ctypes.c_ulong(handle), 1)
hd.hdStopScheduler()
hd.hdDisableDevice(device)
print("ctypes", model, "ticks", ticks, "waited", waited, "error", hd.hdGetError().errorCode, "x", round(position[0], 3))
