#pragma once
/// What must be refused before toml++ sees it. Version 3.3 stops the program (assertion, unreachable code) on control characters in
/// keys and on letters outside ASCII where neither a quote nor a comment holds them; TOML allows neither, so nothing is lost.
#include <string>

namespace halsted::scenes {

/// Throws InputError "origin:line: ...".
void refuseUnsafeToml(const std::string& text, const std::string& origin);

}  // namespace halsted::scenes
