#include "maps/map_channels.h"

#include <OpenImageIO/strutil.h>
#include <fmt/format.h>

#include <cmath>

namespace prairie {
namespace {

/// The index of the channel called `name`, or −1.
int find_channel(const RasterFile& file, const std::string& name) {
  const OIIO::ImageSpec& spec = file.spec();
  for (int channel = 0; channel < spec.nchannels; ++channel) {
    if (spec.channel_name(channel) == name) return channel;
  }
  for (int channel = 0; channel < spec.nchannels; ++channel) {
    if (OIIO::Strutil::iequals(spec.channel_name(channel), name)) return channel;
  }
  // Formats that do not name channels: by their customary places.
  constexpr std::string_view kPlaces = "RGBA";
  const std::size_t place = name.size() == 1 ? kPlaces.find(name[0]) : std::string_view::npos;
  const bool nameless = spec.nchannels >= 3 && OIIO::Strutil::istarts_with(spec.channel_name(0), "channel");
  return nameless && place < static_cast<std::size_t>(spec.nchannels) ? static_cast<int>(place) : -1;
}

bool same(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

BadInput ambiguous_channels(const RasterFile& file, const MapSpec& spec) {
  return BadInput(spec.file.string(), spec.field, fmt::format("channels {}", file.channel_list()),
                  "one channel (or three equal ones), or `channel` naming one of them");
}

MapChannels choose_channels(const RasterFile& file, const MapSpec& spec, MapMeaning meaning) {
  const OIIO::ImageSpec& image = file.spec();
  if (spec.channel) {
    const int channel = find_channel(file, *spec.channel);
    if (channel >= 0) return {{channel, 1}};
    throw BadInput(
        spec.file.string(), spec.field,
        fmt::format("`channel` \"{}\" in a file of channels {}", *spec.channel, file.channel_list()),
        "the name of one of the file's channels");
  }
  // Alpha comes last wherever a format has one.
  const bool has_alpha = image.alpha_channel >= 0 && image.alpha_channel == image.nchannels - 1;
  const int colours = image.nchannels - (has_alpha ? 1 : 0);
  if (meaning == MapMeaning::kColor) {
    const int red = find_channel(file, "R");
    if (colours == 1) return {{0, 1}};
    if (red >= 0 && find_channel(file, "G") == red + 1 && find_channel(file, "B") == red + 2)
      return {{red, 3}};
    if (colours == 3) return {{0, 3}};
    throw BadInput(spec.file.string(), spec.field, fmt::format("channels {}", file.channel_list()),
                   "channels R, G, B, or `channel` naming one of them");
  }
  if (image.nchannels == 1) return {{0, 1}};
  const bool one_type = image.channelformats.empty();
  if (one_type && (colours == 1 || colours == 3)) return {{0, image.nchannels}, true, has_alpha};
  throw ambiguous_channels(file, spec);
}

bool all_grey(const MapChannels& channels, std::span<const float> samples) {
  const std::size_t stride = static_cast<std::size_t>(channels.run.count);
  const std::size_t greys = stride - (channels.has_alpha ? 1 : 0);
  for (std::size_t pixel = 0; pixel < samples.size(); pixel += stride) {
    for (std::size_t channel = 1; channel < greys; ++channel) {
      if (!same(samples[pixel], samples[pixel + channel])) return false;
    }
    if (channels.has_alpha && samples[pixel + greys] != 1.0f) return false;
  }
  return true;
}

}  // namespace prairie
