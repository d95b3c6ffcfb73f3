#pragma once
/// What toml++ must not see. Version 3.3 reaches code that it declares unreachable on many letters outside ASCII (in keys, after a
/// backslash, in text that does not end) and stops the program on some marks. So it is given ASCII only, and no key so long that the tables
/// which it asks for are deeper than the stack.
#include <string>

namespace halsted::scenes {

/// The same TOML in ASCII: letters in double quotes become \u and four digits, in comments '?'. Throws InputError "origin:line: ..." for control
/// characters, for bytes that are not UTF-8, for letters outside ASCII anywhere else, and for keys of more than 64 parts.
std::string asciiToml(const std::string& text, const std::string& origin);

}  // namespace halsted::scenes
