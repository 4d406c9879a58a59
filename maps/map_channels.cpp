#include "maps/map_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace prairie {
namespace {

bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// A number as people of GIS count bands, from 1: "4", "band 4", "Band_4".
int numbered_channel(std::string_view name) {
  constexpr std::string_view kBand = "band";
  if (name.size() > kBand.size() && equal_but_for_case(name.substr(0, kBand.size()), kBand)) {
    name.remove_prefix(kBand.size());
    while (!name.empty() && (name.front() == ' ' || name.front() == '_')) name.remove_prefix(1);
  }
  int number = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? number : 0;
}

bool is_nameless(const StoredRaster& raster) {
  const std::string& first = raster.channels()[0].name;
  return first.empty() || equal_but_for_case(std::string_view(first).substr(0, 7), "channel");
}

/// The index of the channel called `name`, or −1.
int find_channel(const StoredRaster& raster, const std::string& name) {
  const std::vector<StoredChannel>& channels = raster.channels();
  const int count = static_cast<int>(channels.size());
  if (name.empty()) return -1;
  for (int k = 0; k < count; ++k) {
    if (channels[static_cast<std::size_t>(k)].name == name) return k;
  }
  for (int k = 0; k < count; ++k) {
    if (equal_but_for_case(channels[static_cast<std::size_t>(k)].name, name)) return k;
  }
  if (const int number = numbered_channel(name); number >= 1 && number <= count) return number - 1;
  // Formats that do not name the channels of a picture: by their customary places.
  constexpr std::string_view kPlaces = "RGBA";
  const std::size_t place = name.size() == 1 ? kPlaces.find(name[0]) : std::string_view::npos;
  const bool is_picture = (count == 3 || count == 4) && is_nameless(raster);
  return is_picture && place < channels.size() ? static_cast<int>(place) : -1;
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool have_one_type(const StoredRaster& raster) {
  const SampleType first = raster.channels()[0].type;
  return std::ranges::all_of(raster.channels(), [&](const StoredChannel& channel) {
    return channel.type.bits == first.bits && channel.type.largest == first.largest;
  });
}

}  // namespace

BadInput ambiguous_channels(const StoredRaster& raster, const MapSpec& spec) {
  return BadInput(spec.file.string(), spec.field, fmt::format("channels {}", raster.channel_list()),
                  "one channel (or three equal ones), or `channel` naming one of them");
}

MapChannels choose_channels(const StoredRaster& raster, const MapSpec& spec, MapMeaning meaning) {
  const int count = static_cast<int>(raster.channels().size());
  if (spec.channel) {
    const int channel = find_channel(raster, *spec.channel);
    if (channel >= 0) return {{channel, 1}};
    throw BadInput(
        spec.file.string(), spec.field,
        fmt::format("`channel` \"{}\" in a file of channels {}", *spec.channel, raster.channel_list()),
        fmt::format("the name of one of the file's channels, or its number, 1 to {}", count));
  }
  const bool has_alpha = raster.alpha_channel().has_value();
  const int colours = count - (has_alpha ? 1 : 0);
  if (meaning == MapMeaning::kColor) {
    const int red = find_channel(raster, "R");
    if (colours == 1) return {{0, 1}};
    if (red >= 0 && find_channel(raster, "G") == red + 1 && find_channel(raster, "B") == red + 2)
      return {{red, 3}};
    if (colours == 3) return {{0, 3}};
    throw BadInput(spec.file.string(), spec.field, fmt::format("channels {}", raster.channel_list()),
                   "channels R, G, B, or `channel` naming one of them");
  }
  if (count == 1) return {{0, 1}};
  // Where reading obeys alpha as a mask, the values stand for themselves.
  if (have_one_type(raster) && (colours == 1 || colours == 3)) return {{0, count}, true, has_alpha};
  throw ambiguous_channels(raster, spec);
}

bool all_grey(const MapChannels& channels, double opaque, std::span<const double> values) {
  const std::size_t stride = static_cast<std::size_t>(channels.run.count);
  const std::size_t greys = stride - (channels.has_alpha ? 1 : 0);
  for (std::size_t pixel = 0; pixel < values.size(); pixel += stride) {
    for (std::size_t channel = 1; channel < greys; ++channel) {
      if (!same(values[pixel], values[pixel + channel])) return false;
    }
    if (channels.has_alpha && values[pixel + greys] != opaque && !std::isnan(values[pixel])) return false;
  }
  return true;
}

}  // namespace prairie
