#include "stages/import/folders/dataset_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <set>
#include <system_error>

#include "core/store/hdf5_signature.hpp"
#include "stages/import/clips/readers.hpp"
#include "stages/import/folders/folder_files.hpp"
#include "stages/import/folders/manifest_entries.hpp"
#include "stages/import/folders/read_recording.hpp"
#include "stages/import/guess/name_map.hpp"
#include "stages/import/guess/unresolved_import.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

bool is_yaml(const fs::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

bool holds_key_recordings(const fs::path& yaml) {
  std::ifstream stream(yaml);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("recordings:")) return true;
  }
  return false;
}

/// Creates the file with its folders below `root`, preceded by `above`, and its names.
DatasetFile file_below(const fs::path& path, const fs::path& root,
                       const std::vector<std::string>& above) {
  DatasetFile file;
  file.path = path;
  file.from_folder = true;
  const fs::path below = path.lexically_relative(root);
  file.display_name = below.generic_string();
  file.sketch.folders = above;
  for (std::string& folder : folder_names(below.parent_path())) {
    file.sketch.folders.push_back(std::move(folder));
  }
  file.sketch.stem = path.stem().string();
  return file;
}

/// A manifest of a folder, which determines the recordings of all files below it.
struct FolderManifest {
  fs::path file;
  std::set<fs::path> uses;  ///< the files that it lists, with links resolved
};

FolderManifest read_folder_manifest(const ImportRequest& request, const DatasetFile& manifest,
                                    std::vector<NamedEntry>& entries) {
  FolderManifest read{manifest.path, {}};
  for (ManifestEntry& entry : entries_of(request, manifest.path, true)) {
    for (const std::string& used :
         {entry.file, entry.static_trial, entry.glove, entry.glove_static_trial,
          entry.glove_calibration, entry.names}) {
      if (!used.empty()) read.uses.insert(fs::weakly_canonical(used));
    }
    const std::string name = entry.name.empty() ? fs::path(entry.file).stem().string() : entry.name;
    const std::vector<std::string>& folders = manifest.sketch.folders;
    entries.push_back(
        {std::move(entry), {name, joined_name(folders, name), joined_name(folders, name, true)}});
  }
  return read;
}

const FolderManifest* manifest_above(const fs::path& path,
                                     const std::vector<FolderManifest>& manifests) {
  const auto above = std::ranges::find_if(manifests, [&](const FolderManifest& manifest) {
    const fs::path below = path.lexically_relative(manifest.file.parent_path());
    return !below.empty() && *below.begin() != "..";
  });
  return above == manifests.end() ? nullptr : &*above;
}

/// Returns the reason to skip a file of a folder, "" if it may be a recording.
std::string skip_reason(const ImportRequest& request, const fs::path& path,
                        const RecordingFormat* format) {
  if (format == nullptr && store::has_hdf5_signature(path))
    return "an HDF5 file; if it contains demonstrations, give the file itself";
  if (is_yaml(path) && holds_key_recordings(path)) return "a manifest; give the file itself";
  if (format == nullptr) return "not a recording";
  if (!request.format.empty() && format->name != request.format) {
    return fmt::format("format {}, but {} was requested", format->name, request.format);
  }
  if (format->name == "clip-npz" && !holds_a_clip(path)) {
    return "not a recording: a .npz file without a key of a clip, such as mano_right_joints";
  }
  return format->name == "mot" ? "only joint angles, from which no arm can be reconstructed" : "";
}

/// Adds the files of a folder that may be recordings.
void add_folder(const ImportRequest& request, const fs::path& folder,
                const std::vector<std::string>& above, std::vector<NamedEntry>& entries,
                std::vector<DatasetFile>& files, std::vector<SkippedFile>& left_out) {
  FolderFiles found = list_files(folder, request.results_folder);
  left_out.insert(left_out.end(), found.left_out.begin(), found.left_out.end());
  std::vector<FolderManifest> manifests;
  for (const fs::path& path : found.files) {
    if (path.filename() != "recordings.yaml" && path.filename() != "recordings.yml") continue;
    manifests.push_back(read_folder_manifest(request, file_below(path, folder, above), entries));
  }
  for (const fs::path& path : found.files) {
    const FolderManifest* const manifest = manifest_above(path, manifests);
    if (manifest != nullptr &&
        (path == manifest->file || manifest->uses.contains(fs::weakly_canonical(path)))) {
      continue;
    }
    std::error_code error;
    if (fs::equivalent(path, request.static_trial, error)) continue;
    try {
      const RecordingFormat* const format = recognised_format(path);
      std::string why = skip_reason(request, path, format);
      if (why.empty() && manifest != nullptr) {
        why = fmt::format("not listed in {}",
                          manifest->file.lexically_relative(folder).generic_string());
      }
      if (!why.empty()) {
        left_out.push_back({path, why});
        continue;
      }
      files.push_back(file_below(path, folder, above));
      files.back().sketch.format = format->name;
    } catch (const InputError& fault) {
      left_out.push_back(skipped_file_from_error(path, fault));
    }
  }
}

DatasetFile direct_file(const ImportRequest& request, const fs::path& path) {
  DatasetFile file;
  file.path = path;
  file.display_name = path.filename().string();
  file.names = request.name_map.string();
  file.sketch.folders = folder_names(path.parent_path());
  file.sketch.stem = path.stem().string();
  const RecordingFormat* const format = request.format.empty() ? recognised_format(path) : nullptr;
  file.sketch.format = format != nullptr ? format->name : request.format;
  return file;
}

/// Reads a file as it will be imported, except for properties still to be determined.
Demonstration read_file(const ImportRequest& request, const DatasetFile& file) {
  ManifestEntry entry;
  entry.file = file.path.string();
  entry.format = file.sketch.format;
  entry.names = file.names;
  entry.conventions = request.conventions;
  return read_recording(entry);
}

/// Renames the markers, since related recordings are identified by the names of their points.
void rename_known_markers(const NameMap& names, Demonstration& demonstration) {
  if (!demonstration.streams.markers) return;
  for (std::string& name : demonstration.streams.markers->names) {
    if (const auto found = names.find(name); found != names.end()) name = found->second;
  }
}

/// Reads a file with the request's name map. For a folder, the map applies to files that contain
/// its names; for a recording given directly, some of them may be in its static trial.
Demonstration read_with_names(const ImportRequest& request, DatasetFile& file) {
  if (request.name_map.empty()) return read_file(request, file);
  file.names = request.name_map.string();
  try {
    return read_file(request, file);
  } catch (const InputError&) {
    file.names.clear();
  }
  try {
    Demonstration demonstration = read_file(request, file);
    if (!file.from_folder) file.names = request.name_map.string();
    return demonstration;
  } catch (const UnresolvedImport& question) {
    if (!question.demonstration) throw;
    file.names = request.name_map.string();  // the remaining names may be its static trial's
    Demonstration demonstration = *question.demonstration;
    rename_known_markers(read_names(request.name_map), demonstration);
    return demonstration;
  }
}

/// Keeps the first question, and adds the names proposed by the others.
void merge_proposal(const UnresolvedImport& question, std::optional<UnresolvedImport>& open) {
  if (!open) {
    open = question;
    return;
  }
  for (const auto& name : question.proposal.names) {
    const bool there = std::ranges::any_of(open->proposal.names, [&](const auto& other) {
      return other.first == name.first || other.second == name.second;
    });
    if (!there) open->proposal.names.push_back(name);
  }
}

void inspect_file(const ImportRequest& request, DatasetFile& file) {
  const Demonstration demonstration = read_with_names(request, file);
  RecordingDescriptor sketch = recording_descriptor(demonstration);
  sketch.folders = std::move(file.sketch.folders);
  sketch.stem = std::move(file.sketch.stem);
  sketch.format = std::move(file.sketch.format);
  file.sketch = std::move(sketch);
  const std::optional<Side> said = hand_in_file(file.path, file.sketch.format);
  file.hand = said ? ReachingHand{*said, fmt::format("the {} hand reaches, as stated in the file",
                                                     name_of(*said))}
                   : reaching_hand(demonstration, file.sketch);
}

}  // namespace

std::vector<DatasetFile> dataset_files(const ImportRequest& request,
                                       std::vector<NamedEntry>& entries,
                                       std::vector<SkippedFile>& left_out) {
  const bool several = std::ranges::count_if(request.paths, [](const fs::path& path) {
                         return fs::is_directory(path);
                       }) > 1;
  std::vector<DatasetFile> files, read;
  // Any table may look like points: one that cannot be read beside recordings is not a recording.
  std::vector<std::size_t> tables;
  for (std::size_t given = 0; given < request.paths.size(); ++given) {
    const fs::path& path = request.paths[given];
    const std::size_t entries_before = entries.size(), files_before = files.size();
    if (fs::is_directory(path)) {
      const fs::path folder = path.has_filename() ? path : path.parent_path();
      std::vector<std::string> above;
      if (several) above.push_back(fs::weakly_canonical(folder).filename().string());
      add_folder(request, folder, above, entries, files, left_out);
    } else if (is_yaml(path)) {
      for (ManifestEntry& entry : entries_of(request, path, false)) {
        entries.push_back({std::move(entry), {}});
      }
    } else {
      files.push_back(direct_file(request, path));
    }
    for (std::size_t k = entries_before; k < entries.size(); ++k) entries[k].request_index = given;
    for (std::size_t k = files_before; k < files.size(); ++k) files[k].request_index = given;
  }
  std::optional<UnresolvedImport> open;  // question about the whole folder if no file can be read
  for (DatasetFile& file : files) {
    try {
      inspect_file(request, file);
      read.push_back(std::move(file));
    } catch (const InputError& fault) {
      if (!file.from_folder) {  // the error is reported by the import
        file.names = request.name_map.string();
        read.push_back(std::move(file));
        continue;
      }
      const auto* const question = dynamic_cast<const UnresolvedImport*>(&fault);
      if (question != nullptr) merge_proposal(*question, open);
      left_out.push_back(skipped_file_from_error(file.path, fault));
      if (file.sketch.format == "point-csv") tables.push_back(left_out.size() - 1);
    }
  }
  if (read.empty() && entries.empty() && open) throw UnresolvedImport(*open);
  for (const std::size_t k : tables) {
    if (read.empty()) continue;
    std::string& why = left_out[k].reason;
    why = "not readable as a recording: " +
          why.substr(std::min(why.find_first_not_of("0123456789: "), why.size()));
    left_out[k].failed = false;
  }
  return read;
}

bool has_static_name(const DatasetFile& file) {
  const auto says = [](const std::string& name) { return parse_static_name(name).is_static; };
  return says(file.sketch.stem) || std::ranges::any_of(file.sketch.folders, says);
}

bool is_static_trial(const DatasetFile& file) {
  return has_static_name(file) && is_stationary(file.sketch);
}

std::vector<std::string> candidate_names(const DatasetFile& file) {
  if (!file.from_folder) return {};
  const std::vector<std::string>& folders = file.sketch.folders;
  const std::string& stem = file.sketch.stem;
  const std::string ending = file.path.extension().string();
  const std::string short_name = joined_name(folders, stem);
  std::vector<std::string> names{short_name, joined_name(folders, stem, true)};
  if (ending.size() > 1) names.insert(names.begin() + 1, short_name + "_" + ending.substr(1));
  return names;
}

}  // namespace morphe::imports
