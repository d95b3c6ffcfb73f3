#include "haptics/vendor/hd_library.h"

#include <dlfcn.h>

#include <cstdlib>

namespace halsted::haptics {
namespace {

constexpr int kMostErrors = 64;                // a library that never runs out of them must not hold a thread
constexpr unsigned int kHdDeviceFault = 0x0300, kHdTimerError = 0x0304;  // and the faults of the line between them

template <typename Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

bool findAll(void* library, HdFunctions& f) {
  return find(library, "hdInitDevice", f.initDevice) && find(library, "hdDisableDevice", f.disableDevice) &&
         find(library, "hdMakeCurrentDevice", f.makeCurrentDevice) && find(library, "hdBeginFrame", f.beginFrame) &&
         find(library, "hdEndFrame", f.endFrame) && find(library, "hdGetError", f.lastError) && find(library, "hdEnable", f.enable) &&
         find(library, "hdGetDoublev", f.readDoubles) && find(library, "hdGetIntegerv", f.readIntegers) &&
         find(library, "hdGetString", f.readString) && find(library, "hdSetDoublev", f.setDoubles) &&
         find(library, "hdCheckCalibration", f.checkCalibration) && find(library, "hdUpdateCalibration", f.updateCalibration) &&
         find(library, "hdStartScheduler", f.startScheduler) && find(library, "hdStopScheduler", f.stopScheduler) &&
         find(library, "hdScheduleAsynchronous", f.scheduleAsynchronous) && find(library, "hdUnschedule", f.unschedule);
}

std::string pathOf(void* library) {
  Dl_info info{};
  void* symbol = dlsym(library, "hdInitDevice");
  return symbol && dladdr(symbol, &info) && info.dli_fname ? info.dli_fname : "libHD.so";
}

}  // namespace

std::shared_ptr<HdLibrary> HdLibrary::load(HdLoad& result) {
  static std::weak_ptr<HdLibrary> inUse;       // main thread only
  result = HdLoad::kLoaded;
  if (auto library = inUse.lock()) return library;
  const char* given = std::getenv("HALSTED_VENDOR_LIBHD");
  std::shared_ptr<HdLibrary> library(new HdLibrary);
  library->handle_ = dlopen(given && *given ? given : "libHD.so", RTLD_NOW | RTLD_LOCAL);
  result = HdLoad::kMissing;
  if (!library->handle_) return nullptr;
  result = HdLoad::kIncomplete;
  if (!findAll(library->handle_, library->functions_)) return nullptr;
  library->path_ = pathOf(library->handle_);
  inUse = library;
  result = HdLoad::kLoaded;
  return library;
}

HdLibrary::~HdLibrary() {
  if (handle_) dlclose(handle_);
}

void HdLibrary::forgetErrors() const noexcept {
  for (int i = 0; i < kMostErrors && functions_.lastError().code != kHdSuccess; ++i) {}
}

bool HdLibrary::isLost(unsigned int asker) noexcept {
  for (int i = 0; i < kMostErrors; ++i) {
    const HdErrorInfo error = functions_.lastError();
    if (error.code == kHdSuccess) break;
    if (error.code < kHdDeviceFault || error.code > kHdTimerError) continue;
    const unsigned int device = error.device < kMostDevices ? error.device : asker;
    if (device < kMostDevices) lost_[device].store(true, std::memory_order_relaxed);
  }
  return asker < kMostDevices && lost_[asker].load(std::memory_order_relaxed);
}

void HdLibrary::opened(unsigned int device) noexcept {
  if (device < kMostDevices) lost_[device].store(false, std::memory_order_relaxed);
}

}  // namespace halsted::haptics
