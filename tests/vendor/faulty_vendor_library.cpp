/// A vendor's library whose devices break: the few functions that the driver calls, 1 kHz, two devices ("left", also the default one, and
/// "right") that stand still at x = 10 mm and 110 mm until HALSTED_FAULTY_VENDOR says otherwise:
///   nan      the left one sends numbers that are none from the 300th tick to the 500th
///   lost     a communication error of the left one in the 300th tick; it cannot be opened again
///   lost-right  the same of the right one
///   replug   the same of the left one; it can be opened again at the third attempt, and stands at x = 20 mm then
///   swap     as replug, but another device answers to its name at first
///   stall    the servo thread sleeps 500 ms in the 300th tick
/// What was pushed last, and what was called in which order, can be asked for.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

namespace {

using Callback = unsigned int (*)(void*);
struct Error { unsigned int code; int internalCode; unsigned int device; };

constexpr unsigned int kCommError = 0x0302, kDeviceFault = 0x0300, kNoHandle = 0xffffffffu;
constexpr int kDevices = 2;

struct Scheduled { Callback call; void* data; };

std::thread servo;
std::atomic<bool> stop{false};
std::array<Scheduled, kDevices> scheduled{};
std::array<bool, kDevices> isOpen{};
std::array<int, kDevices> opens{};             // successful ones and refused ones
std::atomic<double> pushed{0.0};               // [N] on the left device
std::string calls;
unsigned int current = 0;
int tick = 0;
Error waiting{0, 0, 0};

bool mode(const char* name) {
  const char* wanted = std::getenv("HALSTED_FAULTY_VENDOR");
  return wanted && std::string(wanted) == name;
}

bool comesBack() { return mode("replug") || mode("swap"); }
bool cameBack() { return comesBack() && opens[0] > 3; }

void run() {
  auto next = std::chrono::steady_clock::now();
  while (!stop.load()) {
    std::this_thread::sleep_until(next += std::chrono::milliseconds(1));
    ++tick;
    if (mode("stall") && tick == 300) std::this_thread::sleep_for(std::chrono::milliseconds(500));
    if (tick == 300 && (mode("lost") || (comesBack() && opens[0] == 1))) waiting = {kCommError, 0, 0};
    if (tick == 300 && mode("lost-right")) waiting = {kCommError, 0, 1};
    for (const Scheduled& callback : scheduled)
      if (callback.call) callback.call(callback.data);
  }
}

bool refuses(unsigned int device) {
  if (device == 0) return (mode("lost") && opens[0] > 1) || (comesBack() && opens[0] > 1 && opens[0] < (mode("swap") ? 3 : 4));
  return mode("lost-right") && opens[1] > 1;
}

}  // namespace

extern "C" {
unsigned int hdInitDevice(const char* name) {
  const unsigned int device = name && std::string(name) == "right" ? 1 : 0;
  calls += servo.joinable() ? "init-while-running " : "init ";
  ++opens[device];
  if (isOpen[device] || refuses(device)) {
    waiting = {kDeviceFault, 0, device};
    return kNoHandle;
  }
  isOpen[device] = true;
  return current = device;
}
void hdDisableDevice(unsigned int device) {
  calls += servo.joinable() ? "disable-while-running " : "disable ";
  isOpen[device] = false;
}
void hdMakeCurrentDevice(unsigned int device) { current = device; }
void hdBeginFrame(unsigned int device) { current = device; }
void hdEndFrame(unsigned int) {}
Error hdGetError() {
  const Error error = waiting;
  waiting = {0, 0, 0};
  return error;
}
void hdEnable(unsigned int) {}
void hdGetDoublev(unsigned int parameter, double* values) {
  if (parameter == 0x2052) {
    const double x = current == 1 ? 110.0 : cameBack() ? 20.0 : 10.0;  // [mm]
    const double pose[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 20, 30, 1};
    std::memcpy(values, pose, sizeof pose);
    if (mode("nan") && current == 0 && tick >= 300 && tick < 500) values[12] = std::nan("");
  } else {
    values[0] = parameter == 0x2602 ? 0.5 : 3.0;
  }
}
void hdGetIntegerv(unsigned int, int* values) { values[0] = 0; }
const char* hdGetString(unsigned int parameter) {
  if (parameter != 0x2504) return "faulty";
  if (mode("swap") && current == 0 && opens[0] == 3) return "SERIAL-OF-ANOTHER";
  return current == 1 ? "SERIAL-RIGHT" : "SERIAL-LEFT";
}
void hdSetDoublev(unsigned int, const double* f) {
  if (current == 0) pushed.store(std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]));
}
unsigned int hdCheckCalibration() { return 0x5000; }
void hdUpdateCalibration(unsigned int) {}
void hdStartScheduler() {
  calls += "start ";
  stop.store(false);
  tick = 0;
  servo = std::thread(run);
}
void hdStopScheduler() {
  stop.store(true);
  if (servo.joinable()) servo.join();
  servo = {};
  calls += "stop ";
}
unsigned long hdScheduleAsynchronous(Callback call, void* data, unsigned short) {
  calls += "schedule ";
  const std::size_t free = scheduled[0].call ? 1 : 0;
  scheduled[free] = {call, data};
  return free + 1;
}
void hdUnschedule(unsigned long handle) {
  calls += "unschedule ";
  scheduled[handle - 1] = {};
}

double faultyVendorPush() { return pushed.load(); }
const char* faultyVendorCalls() { return calls.c_str(); }        // while its scheduler stands
void faultyVendorForget() {
  calls.clear();
  opens = {};
  waiting = {0, 0, 0};
}
}
