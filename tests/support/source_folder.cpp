#include "tests/support/source_folder.h"

namespace halsted::testing {

std::string sourceFolder() { return HALSTED_SOURCE_DIR; }

}  // namespace halsted::testing
