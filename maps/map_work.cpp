#include "maps/map_work.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "files/byte_message.h"
#include "files/fallible_work.h"
#include "maps/map_files.h"

namespace prairie {
namespace {

constexpr const char* kDecode = "decode a map";
constexpr const char* kLayout = "layout of a map";

void put_pair(MessageWriter& message, const auto& pair) {
  message.put(static_cast<std::uint8_t>(pair.has_value()));
  if (pair) message.put((*pair)[0]).put((*pair)[1]);
}

template <class Number>
std::optional<std::array<Number, 2>> read_pair(MessageReader& message) {
  if (!message.has_value()) return std::nullopt;
  const auto first = message.number<Number>();
  return std::array{first, message.number<Number>()};
}

MessageWriter as_message(const char* work, const MapRequest& request) {
  const MapSpec& spec = request.spec;
  std::vector<std::string> files{spec.file.string()};
  for (const std::filesystem::path& file : spec.more_files) files.push_back(file.string());
  MessageWriter message;
  message.put(std::string_view(work)).put(files).put(spec.field).put(spec.channel).put(spec.spacing_m);
  put_pair(message, spec.range);
  message.put(spec.nodata).put(spec.scale).put(spec.crs);
  put_pair(message, spec.size_px);
  message.put(spec.curve).put(spec.max).put(static_cast<std::uint8_t>(spec.repeats));
  message.put(static_cast<std::uint8_t>(request.meaning)).put(request.scene_wkt);
  return message;
}

MapRequest request_of(MessageReader& message) {
  MapRequest request;
  MapSpec& spec = request.spec;
  const std::vector<std::string> files = message.texts();
  if (files.empty()) throw BrokenMessage();
  spec.file = files.front();
  spec.more_files.assign(files.begin() + 1, files.end());
  spec.field = message.text();
  spec.channel = message.optional_text();
  spec.spacing_m = message.optional_number<double>();
  spec.range = read_pair<double>(message);
  spec.nodata = message.optional_number<double>();
  spec.scale = message.optional_number<double>();
  spec.crs = message.optional_text();
  spec.size_px = read_pair<int>(message);
  spec.curve = message.number<double>();
  spec.max = message.number<double>();
  spec.repeats = message.number<std::uint8_t>() != 0;
  request.meaning = static_cast<MapMeaning>(message.number<std::uint8_t>());
  request.scene_wkt = message.text();
  return request;
}

void put_geo_reference(MessageWriter& message, const std::optional<GeoReference>& reference) {
  message.put(static_cast<std::uint8_t>(reference.has_value()));
  if (reference)
    message.put(reference->pixel_size_m).put(reference->west_m).put(reference->south_m).put(reference->wkt);
}

std::optional<GeoReference> geo_reference_of(MessageReader& message) {
  if (!message.has_value()) return std::nullopt;
  GeoReference reference;
  reference.pixel_size_m = message.number<double>();
  reference.west_m = message.number<double>();
  reference.south_m = message.number<double>();
  reference.wkt = message.text();
  return reference;
}

enum class Part : std::uint8_t { kFrame, kNodes, kSummary };

MessageWriter begun(Part part) {
  MessageWriter message;
  message.put(static_cast<std::uint8_t>(part));
  return message;
}

/// Sends what it is given.
class SendingSink : public MapSink {
 public:
  explicit SendingSink(const MessageSink& reply) : reply_(reply) {}

  void begin(const GridFrame& frame, int channels) override {
    MessageWriter message = begun(Part::kFrame);
    message.put(frame.columns).put(frame.rows).put(frame.spacing_m).put(frame.origin_m.x);
    message.put(frame.origin_m.y).put(static_cast<std::uint8_t>(frame.repeats)).put(channels);
    reply_(message.bytes());
  }

  void take(const NodeRect& rect, std::span<const float> values) override {
    MessageWriter message = begun(Part::kNodes);
    message.put(rect.column).put(rect.row).put(rect.columns).put(rect.rows).put(values);
    reply_(message.bytes());
  }

 private:
  const MessageSink& reply_;
};

/// Hands on what arrives, as far as it makes sense.
class ArrivingMap {
 public:
  explicit ArrivingMap(MapSink& sink) : sink_(sink) {}

  void take(std::span<const std::byte> bytes) {
    MessageReader message(bytes);
    const auto part = static_cast<Part>(message.number<std::uint8_t>());
    if (part == Part::kFrame) {
      take_frame(message);
    } else if (part == Part::kNodes) {
      take_nodes(message);
    } else {
      MapSummary summary;
      summary.geo_reference = geo_reference_of(message);
      summary.content_hash = message.number<std::uint64_t>();
      summary.has_gaps = message.number<std::uint8_t>() != 0;
      const std::vector<std::string> codes = message.texts(), texts = message.texts();
      for (std::size_t n = 0; n < std::min(codes.size(), texts.size()); ++n)
        summary.warnings.push_back({codes[n], texts[n]});
      summary_ = std::move(summary);
    }
  }

  MapSummary release() {
    if (!summary_) throw BrokenMessage();
    return *std::move(summary_);
  }

 private:
  void take_frame(MessageReader& message) {
    frame_.columns = message.number<int>();
    frame_.rows = message.number<int>();
    frame_.spacing_m = message.number<double>();
    frame_.origin_m.x = message.number<double>();
    frame_.origin_m.y = message.number<double>();
    frame_.repeats = message.number<std::uint8_t>() != 0;
    channels_ = message.number<int>();
    sink_.begin(frame_, channels_);
  }

  void take_nodes(MessageReader& message) {
    NodeRect rect;
    rect.column = message.number<int>();
    rect.row = message.number<int>();
    rect.columns = message.number<int>();
    rect.rows = message.number<int>();
    const std::vector<float> values = message.floats();
    const bool is_inside = rect.column >= 0 && rect.row >= 0 && rect.columns >= 0 && rect.rows >= 0 &&
                           rect.columns <= frame_.columns - rect.column &&
                           rect.rows <= frame_.rows - rect.row;
    if (!is_inside || values.size() != static_cast<std::size_t>(rect.columns) *
                                           static_cast<std::size_t>(rect.rows) *
                                           static_cast<std::size_t>(channels_))
      throw BrokenMessage();
    sink_.take(rect, values);
  }

  MapSink& sink_;
  GridFrame frame_;
  int channels_ = 0;
  std::optional<MapSummary> summary_;
};

/// Libraries that decode in several threads set aside memory for each.
void decode_in_one_thread() {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
}

void decode(std::span<const std::byte> bytes, const MessageSink& reply) {
  decode_in_one_thread();
  MessageReader message(bytes);
  SendingSink sink(reply);
  const MapSummary summary = decode_map(request_of(message), sink);
  MessageWriter last = begun(Part::kSummary);
  put_geo_reference(last, summary.geo_reference);
  std::vector<std::string> codes, texts;
  for (const Warning& warning : summary.warnings) {
    codes.push_back(warning.code);
    texts.push_back(warning.text);
  }
  last.put(summary.content_hash).put(static_cast<std::uint8_t>(summary.has_gaps)).put(codes).put(texts);
  reply(last.bytes());
}

void tell_layout(std::span<const std::byte> bytes, const MessageSink& reply) {
  decode_in_one_thread();
  MessageReader message(bytes);
  const MapLayout layout = layout_of_map(request_of(message));
  MessageWriter told;
  told.put(layout.columns).put(layout.rows).put(layout.spacing_m);
  put_geo_reference(told, layout.geo_reference);
  reply(told.bytes());
}

/// Larger files may take longer, and larger maps are worth more memory.
WorkLimits limits_for(const MapRequest& request, std::uint64_t memory_bytes) {
  constexpr std::uint64_t kDecoderBytes = 160ull << 20;  // tables, caches of blocks, the code of drivers
  constexpr double kCpu_s_per_byte = 2e-7;
  WorkLimits limits;
  limits.memory_bytes = kDecoderBytes + memory_bytes;
  for (const std::filesystem::path& file : files_of_map(request.spec)) {
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
    if (!unknown) limits.cpu_s += kCpu_s_per_byte * static_cast<double>(bytes);
  }
  return limits;
}

WorkInput input_of(const MapRequest& request) {
  return {request.spec.file.string(), request.spec.field};
}

}  // namespace

std::vector<std::pair<std::string, Work>> map_works() {
  return {{kDecode, decode}, {kLayout, tell_layout}};
}

MapSummary decode_map(const MapRequest& request, std::uint64_t memory_bytes, WorkerProcess* decoder,
                      MapSink& sink) {
  if (decoder == nullptr) return decode_map(request, sink);
  ArrivingMap map(sink);
  run_fallible(*decoder, as_message(kDecode, request).bytes(), limits_for(request, memory_bytes),
               input_of(request), [&map](std::span<const std::byte> bytes) { map.take(bytes); });
  return map.release();
}

MapLayout layout_of_map(const MapRequest& request, WorkerProcess* decoder) {
  if (decoder == nullptr) return layout_of_map(request);
  MapLayout layout;
  const auto take = [&layout](std::span<const std::byte> bytes) {
    MessageReader message(bytes);
    layout.columns = message.number<int>();
    layout.rows = message.number<int>();
    layout.spacing_m = message.optional_number<double>();
    layout.geo_reference = geo_reference_of(message);
  };
  run_fallible(*decoder, as_message(kLayout, request).bytes(), limits_for(request, 0), input_of(request),
               take);
  return layout;
}

}  // namespace prairie
