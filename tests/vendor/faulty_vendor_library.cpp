/// A vendor's library with a broken device: the few functions that the driver calls, 1 kHz, steady at (10, 20, 30) mm until
/// HALSTED_FAULTY_VENDOR says otherwise: "nan" sends numbers that are none from the 300th tick to the 500th, "lost" reports a
/// communication error from the 300th tick on, "stall" sleeps 500 ms in the 300th. What was pushed last can be asked for.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <utility>

namespace {

using Callback = unsigned int (*)(void*);
struct Error { unsigned int code; int internalCode; unsigned int device; };

std::thread servo;
std::atomic<bool> stop{false};
std::atomic<Callback> callback{nullptr};
std::atomic<void*> argument{nullptr};
std::atomic<double> pushed{0.0};               // [N]
int tick = 0;
bool errorWaits = false;

bool mode(const char* name) {
  const char* wanted = std::getenv("HALSTED_FAULTY_VENDOR");
  return wanted && std::string(wanted) == name;
}

void run() {
  auto next = std::chrono::steady_clock::now();
  while (!stop.load()) {
    std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    ++tick;
    if (mode("stall") && tick == 300) std::this_thread::sleep_for(std::chrono::milliseconds(500));
    errorWaits = mode("lost") && tick >= 300;
    if (const Callback call = callback.load()) call(argument.load());
  }
}

}  // namespace

extern "C" {
unsigned int hdInitDevice(const char*) { return 0; }
void hdDisableDevice(unsigned int) {}
void hdMakeCurrentDevice(unsigned int) {}
void hdBeginFrame(unsigned int) {}
void hdEndFrame(unsigned int) {}
Error hdGetError() { return std::exchange(errorWaits, false) ? Error{0x0302, 0, 0} : Error{0, 0, 0}; }
void hdEnable(unsigned int) {}
void hdGetDoublev(unsigned int parameter, double* values) {
  if (parameter == 0x2052) {
    const double pose[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 20, 30, 1};
    std::memcpy(values, pose, sizeof pose);
    if (mode("nan") && tick >= 300 && tick < 500) values[12] = std::nan("");
  } else {
    values[0] = parameter == 0x2602 ? 0.5 : 3.0;
  }
}
void hdGetIntegerv(unsigned int, int* values) { values[0] = 0; }
const char* hdGetString(unsigned int) { return "faulty"; }
void hdSetDoublev(unsigned int, const double* f) { pushed.store(std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2])); }
unsigned int hdCheckCalibration() { return 0x5000; }
void hdUpdateCalibration(unsigned int) {}
void hdStartScheduler() {
  stop.store(false);
  tick = 0;
  servo = std::thread(run);
}
void hdStopScheduler() {
  stop.store(true);
  if (servo.joinable()) servo.join();
}
unsigned long hdScheduleAsynchronous(Callback call, void* data, unsigned short) {
  argument.store(data);
  callback.store(call);
  return 1;
}
void hdUnschedule(unsigned long) { callback.store(nullptr); }

double faultyVendorPush() { return pushed.load(); }
}
