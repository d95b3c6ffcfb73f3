#pragma once
/// How a command ends (DESIGN 5). Bad input throws scenes::InputError; a device or system fault throws SystemFault.
#include <stdexcept>

namespace halsted::app {

enum ExitCode : int { kDone = 0, kCheckFailed = 1, kBadInput = 2, kSystemFault = 3 };

/// A file that cannot be written, a device that is gone: one line, exit code 3.
struct SystemFault : std::runtime_error { using std::runtime_error::runtime_error; };

}  // namespace halsted::app
