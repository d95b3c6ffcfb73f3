#pragma once
/// A Touch in software, held by a simulated hand: force really moves it, and it moves the tool only as far as a hand would.
/// Closed loop and deterministic in virtual time: the state advances in read(dt), with + - * / and sqrt only.
/// Scripted hands are this device moved through setTarget; the mouse hand is the same device with its target from the window.
#include "haptics/device.h"

namespace halsted::haptics {

/// The mechanism. Values of the Touch (data sheet), except where marked.
struct TouchDynamics {
  double mass = 0.045;                         // [kg] apparent, at the tip
  double friction = 0.26;                      // [N] Coulomb, back-drive
  double viscosity = 0.1;                      // [N s/m] tuned: bearings and cables, an order below any hand
  double positionStep = 0.055e-3;              // [m] resolution
  double peakForce = 3.3;                      // [N]
  double continuousForce = 0.88;               // [N]
  double stiffness = 1020.0;                   // [N/m] nominal, weakest axis
  Vec3 halfExtent{0.080, 0.060, 0.035};        // [m] usable workspace 160 x 120 x 70 mm
  Vec3 workspaceCentre = Vec3::Zero();         // [m] the stops stand around this point
  double stopStiffness = 2000.0;               // [N/m] soft stop at its border
  double stopDamping = 5.0;                    // [N s/m] of the stop
};

/// The hand that holds the stylus: it aims, and looks whether it got there.
struct HandDynamics {
  double stiffness = 400.0;                    // [N/m] pen grip; measured grips span some 100 to 1000
  double damping = 8.5;                        // [N s/m] critical with 45 g: 2 sqrt(k m)
  double maxSpeed = 0.25;                      // [m/s] of the aim
  double maxAcceleration = 10.0;               // [m/s^2] of the aim
  double aimTime = 8e-3;                       // [s] the aim reaches a near target with this time constant
  double visualGain = 7000.0;                  // [N/(m s)] slow integral of what the eye sees; k / gain = 57 ms
  double visualForce = 2.0;                    // [N] the most that looking adds: anti-windup
  double visualDeadband = 0.03e-3;             // [m] the eye is content with this
  double turnTime = 15e-3;                     // [s] lag of the orientation
  double maxTurnRate = 12.0;                   // [rad/s]
  double jawRate = 7.0;                        // [1/s] opens in 0.14 s
  double mass = 0.0;                           // [kg] of the fingers that move with the stylus
};

class VirtualDevice final : public Device {
 public:
  explicit VirtualDevice(const Pose& start = {}, const TouchDynamics& = {}, const HandDynamics& = {},
                         const char* kind = "virtual") noexcept;

  DeviceReading read(double dt) noexcept override;                 // [s]
  bool write(const Vec3& force) noexcept override;                 // [N]
  void setTarget(const HandTarget&) noexcept override;
  DeviceLimits limits() const noexcept override;
  const char* kind() const noexcept override { return kind_; }

  /// Pulls the plug or puts it back, so that the loss of a device can be shown and tested.
  void setConnected(bool connected) noexcept { connected_ = connected; }

  const Vec3& position() const noexcept { return position_; }      // [m] before quantisation
  const Vec3& velocity() const noexcept { return velocity_; }      // [m/s]
  const Vec3& handForce() const noexcept { return handForce_; }    // [N] of the hand on the stylus

 private:
  void moveAim(double h) noexcept;                                 // [s]
  void look(double h) noexcept;                                    // [s]
  void moveTip(double h) noexcept;                                 // [s]
  void turn(double dt) noexcept;                                   // [s]

  TouchDynamics touch_;
  HandDynamics hand_;
  const char* kind_;
  HandTarget target_;
  Vec3 position_, velocity_;                   // [m] [m/s] of the tip
  Vec3 aim_, aimVelocity_;                     // [m] [m/s] where the hand means the tip to be
  Vec3 visual_;                                // [N] what looking has added
  Vec3 motor_, handForce_;                     // [N] held since the last write; last of the hand
  Quat orientation_;
  double jaw_ = 1.0;                           // [1]
  bool connected_ = true;
};

}  // namespace halsted::haptics
