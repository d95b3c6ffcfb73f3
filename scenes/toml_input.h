#pragma once
/// What every reader of a TOML file here shares. Include only from .cpp files: toml++ is heavy.
#include <string>

#include "scenes/input_text.h"

namespace halsted::scenes {
/// Throws std::logic_error.
[[noreturn]] void tomlAssertionFailed(const char* expression);
}  // namespace halsted::scenes

// toml++ 3.3 asserts on some bad input (a table header "[!"). Whatever the build type, that must be a refusal, not the end.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expression) ((expression) ? static_cast<void>(0) : ::halsted::scenes::tomlAssertionFailed(#expression))
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace halsted::scenes {

/// Throws InputError "origin:line: message" for text that is not TOML. The only way into toml++: see toml_guard.h.
toml::table parseToml(const std::string& text, const std::string& origin);

/// "origin:line: key" of a node.
std::string whereIs(const std::string& origin, const toml::node& node, const std::string& key);

/// What a wrong node is, in a user's words: "a string", "a table", ...
const char* kindOf(const toml::node& node);

/// A number (integers count as numbers), a string; else InputError "where: must be ...".
double requireNumber(const toml::node& node, const std::string& where);  // [1]
std::string requireText(const toml::node& node, const std::string& where);

}  // namespace halsted::scenes
