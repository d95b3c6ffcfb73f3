#pragma once
/// Files that a command is about to write: none may be the one that it reads, or another of them. Any thread.
#include <string>
#include <utility>
#include <vector>

namespace halsted::app {

/// `outputs` are option and path, an empty path for what was not asked for. Throws scenes::InputError where two of all these are one file,
/// by whatever names. What is no regular file, as /dev/null, may be named as often as one likes.
void checkOutputs(const std::string& input, const std::vector<std::pair<std::string, std::string>>& outputs);

}  // namespace halsted::app
