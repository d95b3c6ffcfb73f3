#pragma once
/// The vendor's libHD.so, loaded at run time: the functions that this program calls, by their documented names and types.
/// One library and one scheduler a process; loaded and dropped on the main thread, devices opened and closed on any that may wait.
#include <array>
#include <atomic>
#include <memory>
#include <string>

#include "haptics/hd/lock.h"

namespace halsted::haptics {

struct HdErrorInfo { unsigned int code; int internalCode; unsigned int device; };   // returned by value, 12 bytes
inline constexpr unsigned int kHdSuccess = 0, kHdInvalidHandle = 0xffffffffu;

/// Types as the interface fixes them on Linux x86-64.
struct HdFunctions {
  unsigned int (*initDevice)(const char*) = nullptr;
  void (*disableDevice)(unsigned int) = nullptr;
  void (*makeCurrentDevice)(unsigned int) = nullptr;
  void (*beginFrame)(unsigned int) = nullptr;
  void (*endFrame)(unsigned int) = nullptr;
  HdErrorInfo (*lastError)() = nullptr;
  void (*enable)(unsigned int) = nullptr;
  void (*readDoubles)(unsigned int, double*) = nullptr;
  void (*readIntegers)(unsigned int, int*) = nullptr;
  const char* (*readString)(unsigned int) = nullptr;
  void (*setDoubles)(unsigned int, const double*) = nullptr;
  unsigned int (*checkCalibration)() = nullptr;
  void (*updateCalibration)(unsigned int) = nullptr;
  void (*startScheduler)() = nullptr;
  void (*stopScheduler)() = nullptr;
  unsigned long (*scheduleAsynchronous)(unsigned int (*)(void*), void*, unsigned short) = nullptr;
  void (*unschedule)(unsigned long) = nullptr;
};

enum class HdLoad { kLoaded, kMissing, kIncomplete };

class HdLibrary {
 public:
  /// From HALSTED_VENDOR_LIBHD, else libHD.so on the loader's path. The same object while somebody holds it.
  static std::shared_ptr<HdLibrary> load(HdLoad& result);
  ~HdLibrary();
  HdLibrary(const HdLibrary&) = delete;
  HdLibrary& operator=(const HdLibrary&) = delete;

  const HdFunctions& call() const noexcept { return functions_; }
  const std::string& path() const noexcept { return path_; }

  /// Opens or closes devices as the interface's shut-down and start-up order wants it: while the scheduler stands. It runs afterwards if
  /// any device is open. `change` says how many more there are.
  template <typename Change> void whileStopped(Change&& change) {
    const hd::Hold hold(changing_);
    if (devices_ > 0) functions_.stopScheduler();
    devices_ += change();
    if (devices_ > 0) functions_.startScheduler();
  }
  /// Takes all errors that wait; for one who has nothing to do with them.
  void forgetErrors() const noexcept;
  /// Servo thread. Takes all errors that wait and gives each to the device that it names, or to the asker; true when the asker's
  /// device is lost. Errors of the force (warm motors, too fast) the library answers itself, by cutting it.
  bool isLost(unsigned int asker) noexcept;
  void opened(unsigned int device) noexcept;   // scheduler stands

 private:
  static constexpr unsigned int kMostDevices = 16;

  HdLibrary() = default;

  void* handle_ = nullptr;
  std::string path_;
  HdFunctions functions_;
  hd::InheritingMutex changing_;
  int devices_ = 0;
  std::array<std::atomic<bool>, kMostDevices> lost_{};            // by handle
};

}  // namespace halsted::haptics
