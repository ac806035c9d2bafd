#include "stages/import/folders/import_inputs.hpp"

#include <set>

#include "stages/import/folders/folder_files.hpp"
#include "stages/import/folders/manifest.hpp"
#include "stages/import/guess/name_map.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

using Paths = std::set<fs::path>;

void add_files_in(const fs::path& folder, Paths& files) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.is_regular_file(ignored)) files.insert(entry.path());
  }
}

/// Adds the files that readers may use with a recording in `folder`: trajectories of a headset,
/// the description of a task, profiles of hands, and meshes of objects.
void add_files_beside(const fs::path& folder, Paths& files) {
  for (const fs::path& place : {folder, folder / ".."}) {
    for (const char* sub : {"", "slam", "trajectory"}) add_files_in(place / sub, files);
    std::error_code ignored;
    for (const fs::directory_entry& object : fs::directory_iterator(place / "objects", ignored))
      add_files_in(object.path(), files);
  }
}

void add_manifest(const fs::path& manifest, Paths& recordings, Paths& files) {
  for (ManifestEntry& entry : read_manifest(manifest)) {
    for (const std::string* const named : paths_of(entry)) {
      if (!named->empty()) files.insert(*named);
    }
    recordings.insert(entry.file);
  }
}

bool is_manifest_name(const fs::path& file) {
  return file.filename() == "recordings.yaml" || file.filename() == "recordings.yml";
}

void add_folder(const ImportRequest& request, const fs::path& folder, Paths& recordings,
                Paths& files) {
  for (const fs::path& file : list_files(folder, request.results_folder).files) {
    files.insert(file);
    recordings.insert(file);
    if (is_manifest_name(file)) add_manifest(file, recordings, files);
  }
}

}  // namespace

std::vector<fs::path> import_inputs(const ImportRequest& request) {
  Paths files, recordings;
  for (const fs::path& path : request.paths) {
    if (fs::is_directory(path)) {
      add_folder(request, path, recordings, files);
      continue;
    }
    files.insert(path);
    const bool is_manifest = path.extension() == ".yaml" || path.extension() == ".yml";
    if (is_manifest) {
      add_manifest(path, recordings, files);
    } else {
      recordings.insert(path);
    }
  }
  Paths folders;
  for (const fs::path& recording : recordings)
    folders.insert(fs::absolute(recording).parent_path());
  for (const fs::path& folder : folders) add_files_beside(folder, files);
  for (const fs::path& map : {request.static_trial, request.name_map}) {
    if (!map.empty()) files.insert(map);
  }
  for (const fs::path& map : shipped_name_files()) files.insert(map);
  return {files.begin(), files.end()};
}

}  // namespace morphe::imports
