#pragma once
/// GLSL 3.30 sources. Colours are linear inside and leave as their square root, a gamma of 2 that costs one instruction.
#include <string>

namespace halsted::render {

extern const char* const kRigidVertex;       // instruments, rods, field: ShapeVertex
extern const char* const kInstrumentDepthVertex;
extern const char* const kTissueVertex;
extern const char* const kTubeVertex;        // thread and needle: TubeVertex
extern const char* const kHoleVertex;
extern const char* const kDepthFragment;     // shadow map: nothing
extern const char* const kFieldFragment;     // the shadows on it
extern const char* const kFieldBareFragment; // all but shadows
extern const char* const kSteelFragment;
extern const char* const kTissueFragment;
extern const char* const kThreadFragment;
extern const char* const kNeedleFragment;
extern const char* const kHoleFragment;
extern const char* const kSmokeVertex;       // discs, each as dense as it is told
extern const char* const kSmokeFragment;

/// Head of a vertex shader: version and the lamp's direction as a constant.
std::string shaderHead();
/// Head of a fragment shader: that, and the functions that surfaces share. They use screen derivatives, which vertices have not.
std::string fragmentHead();

}  // namespace halsted::render
