#pragma once
/// Where the sources are, for tests that read scenes and golden files. Any thread.
#include <string>

namespace halsted::testing {

std::string sourceFolder();                    // the checkout, without a trailing slash

}  // namespace halsted::testing
