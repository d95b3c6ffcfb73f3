#include "render/png.h"

#include <png.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace halsted::render {
namespace {

constexpr std::uint32_t kMostPixels = 8192;  // a side

/// libpng's simplified interface: no setjmp in our code. `fail` carries its message and frees what it holds.
[[noreturn]] void fail(const std::string& path, png_image& image, const std::string& reason) {
  const std::string text = path + ": " + (reason.empty() ? image.message : reason);
  png_image_free(&image);
  throw std::runtime_error(text);
}

}  // namespace

void writePng(const std::string& path, const Frame& frame) {
  if (frame.rgba.size() != 4u * frame.width * frame.height) throw std::runtime_error(path + ": the frame has no picture");
  std::vector<std::uint8_t> rgb(3u * frame.width * frame.height);
  for (std::size_t i = 0; i < rgb.size() / 3; ++i) std::memcpy(&rgb[3 * i], &frame.rgba[4 * i], 3);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(frame.width);
  image.height = static_cast<png_uint_32>(frame.height);
  image.format = PNG_FORMAT_RGB;
  errno = 0;
  if (!png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr))
    fail(path, image, errno ? std::strerror(errno) : "");
}

Frame readPng(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  errno = 0;
  if (!png_image_begin_read_from_file(&image, path.c_str())) fail(path, image, errno ? std::strerror(errno) : "");
  if (image.width > kMostPixels || image.height > kMostPixels) fail(path, image, "larger than 8192x8192");
  image.format = PNG_FORMAT_RGBA;
  Frame frame{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  frame.rgba.resize(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, frame.rgba.data(), 0, nullptr)) fail(path, image, "");
  return frame;
}

}  // namespace halsted::render
