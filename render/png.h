#pragma once
/// PNG files. The same picture gives the same bytes: fixed filter and level, no time stamp.
/// Errors are std::runtime_error: one line that names the file.
#include <string>

#include "render/frame.h"

namespace halsted::render {

void writePng(const std::string& path, const Frame&);   // RGB: alpha is always 255 and is not stored
Frame readPng(const std::string& path);                 // any PNG up to 8192x8192, as RGBA

}  // namespace halsted::render
