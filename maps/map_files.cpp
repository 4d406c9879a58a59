#include "maps/map_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <system_error>

#include "files/error.h"
#include "files/input_file.h"
#include "maps/georaster/georaster.h"
#include "maps/georaster/vrt_sources.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 4096;

/// Beside a raster, or made of those beside it.
bool is_companion(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".msk" || extension == ".ovr" || extension == ".vrt";
}

void add_folder(const fs::path& folder, const std::string& field, std::vector<fs::path>& files) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file(error) && !is_companion(entry.path()) && is_georaster(entry.path()))
      found.push_back(entry.path());
  }
  if (error) throw BadInput(folder.string(), field, error.message(), "a folder that can be read");
  if (found.empty())
    throw BadInput(folder.string(), field, "a folder without rasters", "GeoTIFFs, .asc or .hgt");
  std::ranges::sort(found);
  files.insert(files.end(), found.begin(), found.end());
}

/// Extensions of world files: .tfw and .tifw for .tif, and .wld.
std::vector<std::string> world_file_extensions(const std::string& extension) {
  std::vector<std::string> result{".wld"};
  if (extension.size() > 2) result.push_back(extension.substr(0, 2) + extension.back() + "w");
  if (extension.size() > 1) result.push_back(extension + "w");
  return result;
}

void add_beside(const fs::path& raster, std::vector<fs::path>& found) {
  std::vector<std::string> extensions = world_file_extensions(raster.extension().string());
  extensions.push_back(".prj");
  std::error_code ignored;
  for (std::string extension : extensions) {
    for (int upper = 0; upper < 2; ++upper) {
      const fs::path path = fs::path(raster).replace_extension(extension);
      if (fs::is_regular_file(path, ignored)) found.push_back(path);
      for (char& c : extension) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  for (const char* extension : {".msk", ".aux.xml"}) {
    fs::path path = raster;
    path += extension;
    if (fs::is_regular_file(path, ignored)) found.push_back(path);
  }
}

}  // namespace

std::vector<fs::path> companions_of(const fs::path& raster, const std::string& field) {
  std::vector<fs::path> found;
  add_beside(raster, found);
  if (!is_vrt(raster)) return found;
  for (const fs::path& source : checked_vrt_sources(raster, field)) {
    found.push_back(source);
    add_beside(source, found);
  }
  return found;
}

std::vector<fs::path> files_of_map(const MapSpec& spec) {
  std::vector<fs::path> named{spec.file};
  named.insert(named.end(), spec.more_files.begin(), spec.more_files.end());
  std::vector<fs::path> files;
  for (const fs::path& path : named) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      add_folder(path, spec.field, files);
    } else {
      files.push_back(path);
    }
  }
  if (files.size() > kMostFiles)
    throw BadInput(spec.file.string(), spec.field, fmt::format("{} files", files.size()),
                   fmt::format("at most {}", kMostFiles));
  return files;
}

std::uint64_t content_hash(const std::vector<fs::path>& files, const std::string& field) {
  return inspect_inputs(files, field).hash;
}

}  // namespace prairie
