// World files: six numbers in a text file beside an image, which say how large its pixels are and where they
// lie.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace prairie {

/// x = a·column + b·row + c, y = d·column + e·row + f, of the centre of pixel (column, row); row 0 is the top
/// one.
struct WorldFile {
  double a = 1.0, d = 0.0, b = 0.0, e = -1.0, c = 0.0, f = 0.0;  // in the order of the file's lines
};

/// Nothing unless `text` is six numbers apart by blanks.
std::optional<WorldFile> parse_world_file(std::string_view text);

/// The world file that belongs to `image`, if there is one: image.tfw for image.tif, image.tifw, image.wld,
/// ….
std::optional<std::filesystem::path> find_world_file(const std::filesystem::path& image);

/// Throws BadInput (naming the world file) if it cannot be read or is none.
WorldFile read_world_file(const std::filesystem::path& path);

}  // namespace prairie
