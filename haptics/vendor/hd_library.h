#pragma once
/// The vendor's libHD.so, loaded at run time: the functions that this program calls, by their documented names and types.
/// One library and one scheduler a process; loaded and dropped on the main thread.
#include <memory>
#include <string>

namespace halsted::haptics {

struct HdErrorInfo { unsigned int code; int internalCode; unsigned int device; };   // returned by value, 12 bytes

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
  /// The scheduler runs from the first device to the last.
  void deviceAdded();
  void deviceRemoved();

 private:
  HdLibrary() = default;

  void* handle_ = nullptr;
  std::string path_;
  HdFunctions functions_;
  int devices_ = 0;
};

}  // namespace halsted::haptics
