/// The names of the HL API: each is its own text.
#include <HL/hlDefines.h>

extern "C" {
#define HALSTED_HL_NAME(NAME) const HLenum NAME = #NAME;
#include <HL/hlNames.h>
}
