#pragma once
/// How thick fat and muscle are at one place of a patient's trunk, measured on the masks of a CT.
#include <string>

namespace halsted::scenes {

struct CtLayers { double fat = 0.0, muscle = 0.0; };   // [m]

/// `fatMask` is the subcutaneous fat; `skeletal_muscle` lies beside it. angleDegrees [deg] from the front to the patient's left, seen from
/// the middle of each slice. The median over a hand's breadth of slices and ten degrees. Throws InputError "where: ...".
CtLayers measureLayers(const std::string& fatMask, double angleDegrees, const std::string& where);

}  // namespace halsted::scenes
