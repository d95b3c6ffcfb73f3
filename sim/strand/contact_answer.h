#pragma once
/// What one contact of the thread answers, where its two sides are: the law that thread_contacts.h describes. Physics thread; no heap.
#include "sim/strand/thread_contacts.h"

namespace halsted {

/// On the sample; the partner feels the opposite. The stiffness is symmetric, positive semi-definite: that of sliding friction is its secant.
struct ContactAnswer { Vec3 force; Mat3 stiffness; };   // [N], [N/m]

/// Sample minus partner, with the nodes at `x`. A solid has gone where it is sent, and on with the hand that gives way.
Vec3 relativePoint(const std::vector<Vec3>& x, const TouchingPoint&, const GivingTools&);   // [m]

/// False, and no force, where they do not touch. Writes the point's own forces.
bool answerAt(const Vec3& relative, TouchingPoint&, ContactAnswer&);   // [m]
/// The same, leaving the point's own forces as they are; and the force alone, zero where they do not touch.
bool wouldAnswer(const Vec3& relative, const TouchingPoint&, ContactAnswer&);   // [m]
Vec3 forceAt(const Vec3& relative, const TouchingPoint&);   // [N], [m]

}  // namespace halsted
