/// HLU: what a call without an HL context does, which is to raise the error of the HL call that it would begin with.
#include <HLU/hlu.h>

extern "C" {

void hluFitWorkspace(const HLdouble*) { hlMatrixMode(HL_TOUCHWORKSPACE); }
void hluFitWorkspaceNonUniform(const HLdouble*) { hlMatrixMode(HL_TOUCHWORKSPACE); }
void hluFitWorkspaceBox(const HLdouble*, const HLdouble*, const HLdouble*) { hlMatrixMode(HL_TOUCHWORKSPACE); }
void hluFitWorkspaceBoxNonUniform(const HLdouble*, const HLdouble*, const HLdouble*) { hlMatrixMode(HL_TOUCHWORKSPACE); }

HLdouble hluScreenToModelScale(const HLdouble*, const HLdouble*, const HLint*) {
  hlMatrixMode(HL_TOUCHWORKSPACE);
  return 0.0;
}

void hluModelToWorldTransform(const HLdouble*, HLdouble*) { hlMatrixMode(HL_TOUCHWORKSPACE); }

}  // extern "C"
