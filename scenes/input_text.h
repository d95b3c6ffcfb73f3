#pragma once
/// Reading small text files and building the one-line messages of InputError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "scenes/scene.h"

namespace halsted::scenes {

/// The whole file. Throws InputError when it cannot be opened or is larger than `limit` bytes.
std::string readTextFile(const std::string& path, std::size_t limit);

/// Text from an input file made safe for a one-line message: control characters become '?', long text is shortened.
std::string quoted(const std::string& text);

/// Of the letter outside ASCII that begins at `i`: its length in bytes, 0 when it is not UTF-8.
std::size_t decodeLetter(const std::string& text, std::size_t i, std::uint32_t& letter);
bool isUtf8(const std::string& text);

/// A number as a person writes it (1000, 0.05, 1e+06); always with a point, whatever the locale.
std::string plainNumber(double value);  // value [1]

}  // namespace halsted::scenes
