#pragma once
/// What holds and drags a needle inside tissue: friction along it, the tip's cut, winding round it, and the grasp that winding builds.
/// All of it is elasto-plastic: it holds at rest, gives back no more than was put in, and its force has no jump.
#include "sim/needling/needling_params.h"

namespace halsted {

/// Modified Karnopp friction (Okamura et al. 2004), a Coulomb and a viscous part, in the form that a position-driven hand needs (Hayward
/// and Armstrong 2000): the shaft holds the tissue by a spring. Up to the static bound it stays; beyond, it slides, the bound weakens to
/// the sliding one, and what the spring carries above it is the viscous part of the sliding speed. At a steady speed v the force is
/// bound + viscous v; a device is never asked for more than the spring, which no explicit damping of 40 N s/m on its 45 g could be.
struct ShaftFriction {
  double held = 0.0;                           // [m] tissue carried along, positive inward
  double slid = 0.0;                           // [m] since it last stood still
  double force = 0.0;                          // [N] on the needle along the axis, positive outward
  double drag = 0.0;                           // [N] the viscous part of it
};
struct ShaftBound { double sliding = 0.0, viscous = 0.0; };   // [N], [N s/m]
void slideShaft(const NeedlingParams&, double travel, const ShaftBound&, ShaftFriction&);   // travel [m]

/// The cut goes on only where no cut was before.
struct TipCut {
  double reached = 0.0;                        // [m] depth of the cut along the axis
  double force = 0.0;                          // [N] on the needle, positive outward
};
void advanceTip(const NeedlingParams&, double depth, double bound, TipCut&);           // depth [m], bound [N]

/// Tissue wound round the shaft (torque grows faster than the angle, Han 2015) and needle grasp (Langevin 2001).
struct Winding {
  double angle = 0.0;                          // [rad] held by the shaft
  double turned = 0.0;                         // [rad] net rotation since it went in
  double length = 0.0;                         // [m] shaft inside at the last step
  double torque = 0.0;                         // [N m] on the needle
  double grasp = 1.0;                          // [1] factor of friction
};
void windShaft(const NeedlingParams&, double turn, double length, Winding&);           // turn [rad] in this step, length [m]

}  // namespace halsted
