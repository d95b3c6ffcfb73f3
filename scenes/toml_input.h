#pragma once
/// What every reader of a TOML file here shares. Include only from .cpp files: toml++ is heavy.
#include <string>
#include <toml++/toml.h>

#include "scenes/input_text.h"

namespace halsted::scenes {

/// Throws InputError "origin:line: message" for text that is not TOML.
toml::table parseToml(const std::string& text, const std::string& origin);

/// "origin:line: key" of a node.
std::string whereIs(const std::string& origin, const toml::node& node, const std::string& key);

/// What a wrong node is, in a user's words: "a string", "a table", ...
const char* kindOf(const toml::node& node);

/// A number (integers count as numbers), a string; else InputError "where: must be ...".
double requireNumber(const toml::node& node, const std::string& where);  // [1]
std::string requireText(const toml::node& node, const std::string& where);

}  // namespace halsted::scenes
