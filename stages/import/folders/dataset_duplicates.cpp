#include <fmt/format.h>

#include <map>

#include "core/files/sha256.hpp"
#include "stages/import/folders/dataset_files.hpp"

namespace morphe::imports {

namespace fs = std::filesystem;

void remove_duplicates(std::vector<DatasetFile>& files, std::vector<SkippedFile>& left_out) {
  std::map<std::string, std::string> by_bytes;
  std::map<fs::path, const DatasetFile*> by_place;
  std::vector<DatasetFile> kept;
  kept.reserve(files.size());  // keeps the pointers of by_place valid
  for (DatasetFile& file : files) {
    if (!file.from_folder) {
      kept.push_back(std::move(file));
      continue;
    }
    const auto [same, is_new] =
        by_bytes.emplace(files::sha256_of_file(file.path), file.display_name);
    if (!is_new) {
      left_out.push_back({file.path, fmt::format("identical to {}", same->second)});
      continue;
    }
    const fs::path place = file.path.parent_path() / file.path.stem();
    const auto other = by_place.find(place);
    if (other != by_place.end() && other->second->descriptor.format != file.descriptor.format &&
        same_recording(other->second->descriptor, file.descriptor)) {
      left_out.push_back(
          {file.path, fmt::format("the same recording as {}", other->second->display_name)});
      continue;
    }
    kept.push_back(std::move(file));
    by_place.emplace(place, &kept.back());
  }
  files = std::move(kept);
}

}  // namespace morphe::imports
