#pragma once
/// One device of the program: the virtual Touch in a scripted hand, its two snapshots, its frame, its commands.
/// Every call locks it for its own length; errors come back as codes for the caller to push. Servo and client threads.
#include <atomic>
#include <memory>
#include <optional>

#include <HD/hdDefines.h>

#include "haptics/hd/clock.h"
#include "haptics/hd/force_path.h"
#include "haptics/hd/lock.h"
#include "haptics/hd/motion.h"
#include "haptics/hd/settings.h"
#include "haptics/virtual_device.h"

namespace halsted::haptics::hd {

/// When a call happens.
struct Moment {
  Nanoseconds time = 0;                        // the tick's own time on the servo thread, else now
  std::uint64_t tick = 0;                      // 0: outside any tick
  bool forces = false;                         // the scheduler runs
};

class OpenDevice {
 public:
  /// Reads the motion file; throws MotionError or SettingsError, and is closed then.
  void open(const DeviceSettings&, Moment);
  /// Forces are zero from here; false when it was not open.
  bool close() noexcept;
  bool isOpen() const noexcept { return open_.load(std::memory_order_acquire); }
  bool isNamed(const std::string& name) noexcept;

  HDerror beginFrame(Moment) noexcept;
  /// `errors`: bits of ForceError.
  HDerror endFrame(Moment, std::uint32_t& errors) noexcept;
  /// What a tick owes a device that it left alone, or left in a frame. HD_FRAME_ERROR in the second case.
  HDerror endTick(Moment) noexcept;
  /// Motors off, ramp from zero next time.
  void relax() noexcept;

  /// One parameter at a time, under the lock. `Call` takes the parts below and returns an HDerror.
  struct View {
    DeviceState &current, &last;
    std::uint32_t& capabilities;
    SafetyLimits& safety;
    CommandKind& command;
    int& statusLight;
    unsigned calibrationStyle;                 // mask of HD_CALIBRATION_*
    const char *model, *serial;                // live as long as the process
    double heat;                               // [1]
    bool inFrame;
    bool& calibrated;
    bool docked;
  };
  template <class Call> HDerror with(Call&& call) {
    const Hold hold(mutex_);
    if (!isOpen()) return HD_BAD_HANDLE;
    return call(View{current_, last_, capabilities_, safety_, command_, statusLight_, settings_.calibrationStyle, model_, serial_,
                     path_.limits.heat, depth_ > 0, calibrated_, stylus_.docked});
  }
  /// Force output was switched on: it comes in gently.
  void engage() noexcept;

 private:
  void move(Nanoseconds time) noexcept;
  void takeSnapshot() noexcept;
  StylusState followMotion(double dt) noexcept;  // [s]
  void sendForce(Moment, std::uint32_t& errors) noexcept;
  void beginCommands() noexcept;
  void idle(Nanoseconds time) noexcept;

  InheritingMutex mutex_;
  std::atomic<bool> open_{false};
  DeviceSettings settings_;
  const char *model_ = "", *serial_ = "";
  std::unique_ptr<const Motion> motion_;
  std::optional<VirtualDevice> device_;
  std::size_t cursor_ = 0;
  double motionTime_ = 0.0;                    // [s]

  DeviceState current_, last_;
  MotionFilter filter_;
  StylusState stylus_;
  bool calibrated_ = true;

  std::uint32_t capabilities_ = kCapabilityDefaults;
  SafetyLimits safety_;
  ForcePathState path_;
  CommandKind command_ = kCommandNone;
  int statusLight_ = 0;

  int depth_ = 0;
  std::uint64_t frameTick_ = 0;                // tick of the last frame, 0: none or outside
  int idleTicks_ = 0;
  Pose pose_;                                  // last reading
  Nanoseconds lastRead_ = 0, lastSnapshot_ = 0, lastSent_ = 0;
};

}  // namespace halsted::haptics::hd
