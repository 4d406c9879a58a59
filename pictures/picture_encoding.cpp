#include "pictures/picture_encoding.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cassert>
#include <cstring>
#include <memory>
#include <string>

#include "files/error.h"

namespace prairie {
namespace {

std::vector<std::byte> encode(const char* format, const OIIO::ImageSpec& spec, const void* pixels) {
  OIIO::Filesystem::IOVecOutput memory;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
  const auto fail = [&](const std::string& found) {
    throw OutputFailure("", "", found, std::string("an encoder for ") + format);
  };
  if (output == nullptr) fail(OIIO::geterror());
  // The proxy gives the bytes somewhere to go; the name only names the format.
  if (!output->set_ioproxy(&memory) || !output->open(std::string("memory.") + format, spec) ||
      !output->write_image(spec.format, pixels) || !output->close()) {
    fail(output->geterror());
  }
  const std::vector<unsigned char>& bytes = memory.buffer();
  std::vector<std::byte> result(bytes.size());
  std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

[[maybe_unused]] std::size_t value_count(int width, int height, int channels) {
  assert(width > 0 && height > 0);
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
         static_cast<std::size_t>(channels);
}

}  // namespace

std::vector<std::byte> encode_png_rgb8(int width, int height, std::span<const std::uint8_t> rgb) {
  assert(rgb.size() == value_count(width, height, 3));
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "sRGB");
  return encode("png", spec, rgb.data());
}

std::vector<std::byte> encode_png_grey8(int width, int height, std::span<const std::uint8_t> grey) {
  assert(grey.size() == value_count(width, height, 1));
  return encode("png", OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT8), grey.data());
}

std::vector<std::byte> encode_png_grey16(int width, int height, std::span<const std::uint16_t> grey) {
  assert(grey.size() == value_count(width, height, 1));
  return encode("png", OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT16), grey.data());
}

std::vector<std::byte> encode_exr_rgb(int width, int height, std::span<const float> rgb) {
  assert(rgb.size() == value_count(width, height, 3));
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("compression", "zip");
  // OpenImageIO would write the time of day.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  return encode("exr", spec, rgb.data());
}

}  // namespace prairie
