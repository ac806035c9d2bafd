#include "stages/import/folders/dataset_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <span>
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

bool has_recordings_key(const fs::path& yaml) {
  std::ifstream stream(yaml);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("recordings:")) return true;
  }
  return false;
}

/// Creates a file found below `root`. Its folders are `above` and those between root and file.
DatasetFile file_below(const fs::path& path, const fs::path& root,
                       const std::vector<std::string>& above) {
  DatasetFile file;
  file.path = path;
  file.from_folder = true;
  const fs::path below = path.lexically_relative(root);
  file.display_name = below.generic_string();
  file.descriptor.folders = above;
  for (std::string& folder : folder_names(below.parent_path()))
    file.descriptor.folders.push_back(std::move(folder));
  file.descriptor.stem = path.stem().string();
  return file;
}

/// A manifest of a folder, which determines the recordings of all files below it.
struct FolderManifest {
  fs::path file;
  std::set<fs::path> listed;  ///< the files that its entries name, with links resolved
};

FolderManifest read_folder_manifest(const ImportRequest& request, const DatasetFile& manifest,
                                    std::vector<NamedEntry>& entries) {
  FolderManifest read{manifest.path, {}};
  for (ManifestEntry& entry : entries_of(request, manifest.path, true)) {
    for (const std::string* used : paths_of(entry)) {
      if (!used->empty()) read.listed.insert(fs::weakly_canonical(*used));
    }
    const std::string name = entry.name.empty() ? fs::path(entry.file).stem().string() : entry.name;
    const std::vector<std::string>& folders = manifest.descriptor.folders;
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
  if (!format && store::has_hdf5_signature(path))
    return "an HDF5 file; if it contains demonstrations, give the file itself";
  if (is_yaml(path) && has_recordings_key(path)) return "a manifest; give the file itself";
  if (!format) return "not a recording";
  if (!request.format.empty() && format->name != request.format)
    return fmt::format("format {}, but {} was requested", format->name, request.format);
  if (format->name == "clip-npz" && !holds_a_clip(path))
    return "not a recording: a .npz file without a key of a clip, such as mano_right_joints";
  return format->name == "mot" ? "only joint angles, from which no arm can be reconstructed" : "";
}

void add_folder(const ImportRequest& request, const fs::path& folder,
                const std::vector<std::string>& above, DatasetContents& contents) {
  FolderFiles found = list_files(folder, request.results_folder);
  std::vector<SkippedFile>& left_out = contents.left_out;
  std::ranges::move(found.left_out, std::back_inserter(left_out));
  std::vector<FolderManifest> manifests;
  for (const fs::path& path : found.files) {
    if (path.filename() != "recordings.yaml" && path.filename() != "recordings.yml") continue;
    manifests.push_back(
        read_folder_manifest(request, file_below(path, folder, above), contents.entries));
  }
  for (const fs::path& path : found.files) {
    const FolderManifest* const manifest = manifest_above(path, manifests);
    if (manifest &&
        (path == manifest->file || manifest->listed.contains(fs::weakly_canonical(path)))) {
      continue;
    }
    std::error_code error;
    if (fs::equivalent(path, request.static_trial, error)) continue;
    try {
      const RecordingFormat* const format = recognised_format(path);
      std::string reason = skip_reason(request, path, format);
      if (reason.empty() && manifest) {
        reason = fmt::format("not listed in {}",
                             manifest->file.lexically_relative(folder).generic_string());
      }
      if (!reason.empty()) {
        left_out.push_back({path, reason});
        continue;
      }
      contents.files.push_back(file_below(path, folder, above));
      contents.files.back().descriptor.format = format->name;
    } catch (const InputError& unreadable) {
      left_out.push_back(skipped_file_from_error(path, unreadable));
    }
  }
}

DatasetFile direct_file(const ImportRequest& request, const fs::path& path) {
  DatasetFile file;
  file.path = path;
  file.display_name = path.filename().string();
  file.names = request.name_map.string();
  file.descriptor.folders = folder_names(path.parent_path());
  file.descriptor.stem = path.stem().string();
  const RecordingFormat* const format = request.format.empty() ? recognised_format(path) : nullptr;
  file.descriptor.format = format ? format->name : request.format;
  return file;
}

/// Reads a file as it will be imported, but without its static trial and hand, still to be found.
Demonstration read_file(const ImportRequest& request, const DatasetFile& file) {
  ManifestEntry entry;
  entry.file = file.path.string();
  entry.format = file.descriptor.format;
  entry.names = file.names;
  entry.conventions = request.conventions;
  return read_recording(entry, false);  // its hand, which the audit must know, is yet to be found
}

/// Renames the markers that are in the map, since static trials are paired by the names of points.
void rename_known_markers(const NameMap& names, Demonstration& demonstration) {
  if (!demonstration.streams.markers) return;
  for (std::string& name : demonstration.streams.markers->names) {
    if (const auto entry = names.find(name); entry != names.end()) name = entry->second;
  }
}

/// Reads a file with the request's name map or, if that fails, without. `file.names` becomes the
/// map if the import is to use it: also if only a static trial may have the names that are missing.
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
    file.names = request.name_map.string();
    Demonstration demonstration = *question.demonstration;
    rename_known_markers(read_names(request.name_map), demonstration);
    return demonstration;
  }
}

/// Sets `first` to the first question, and adds to it the names that later ones propose.
void merge_proposal(const UnresolvedImport& question, std::optional<UnresolvedImport>& first) {
  if (!first) {
    first = question;
    return;
  }
  for (const auto& name : question.proposal.names) {
    const bool proposed = std::ranges::any_of(first->proposal.names, [&](const auto& other) {
      return other.first == name.first || other.second == name.second;
    });
    if (!proposed) first->proposal.names.push_back(name);
  }
}

void inspect_file(const ImportRequest& request, DatasetFile& file) {
  const Demonstration demonstration = read_with_names(request, file);
  RecordingDescriptor descriptor = recording_descriptor(demonstration);
  descriptor.folders = std::move(file.descriptor.folders);
  descriptor.stem = std::move(file.descriptor.stem);
  descriptor.format = std::move(file.descriptor.format);
  file.descriptor = std::move(descriptor);
  const std::optional<Side> side = hand_in_file(file.path, file.descriptor.format);
  file.hand = side ? ReachingHand{*side, fmt::format("the {} hand reaches, as stated in the file",
                                                     name_of(*side))}
                   : reaching_hand(demonstration, file.descriptor);
}

}  // namespace

DatasetContents dataset_files(const ImportRequest& request) {
  DatasetContents contents;
  auto& [entries, files, left_out] = contents;
  const bool several_folders = std::ranges::count_if(request.paths, [](const fs::path& path) {
                                 return fs::is_directory(path);
                               }) > 1;
  std::vector<DatasetFile> kept;
  // Indices in left_out. Any table may look like one of points; if it cannot be read and has no
  // names of an arm, but another file can, it counts as a file that is not a recording.
  std::vector<std::size_t> unread_tables;
  for (int index = 0; index < std::ssize(request.paths); ++index) {
    const fs::path& path = request.paths[index];
    const std::size_t entries_before = entries.size(), files_before = files.size();
    if (fs::is_directory(path)) {
      const fs::path folder = path.has_filename() ? path : path.parent_path();
      std::vector<std::string> above;
      if (several_folders) above.push_back(fs::weakly_canonical(folder).filename().string());
      add_folder(request, folder, above, contents);
    } else if (is_yaml(path)) {
      for (ManifestEntry& entry : entries_of(request, path, false))
        entries.push_back({std::move(entry), {}});
    } else {
      files.push_back(direct_file(request, path));
    }
    for (NamedEntry& entry : std::span(entries).subspan(entries_before))
      entry.request_index = index;
    for (DatasetFile& file : std::span(files).subspan(files_before)) file.request_index = index;
  }
  std::optional<UnresolvedImport> first_question;  // asked if no file can be read
  for (DatasetFile& file : files) {
    try {
      inspect_file(request, file);
      kept.push_back(std::move(file));
    } catch (const InputError& unreadable) {
      if (!file.from_folder) {  // the error is reported by the import
        file.names = request.name_map.string();
        kept.push_back(std::move(file));
        continue;
      }
      const auto* const question = dynamic_cast<const UnresolvedImport*>(&unreadable);
      if (question) merge_proposal(*question, first_question);
      left_out.push_back(skipped_file_from_error(file.path, unreadable));
      const bool is_arm = question && !question->names_unresolved;
      if (file.descriptor.format == "point-csv" && !is_arm)
        unread_tables.push_back(left_out.size() - 1);
    }
  }
  if (kept.empty() && entries.empty() && first_question) throw UnresolvedImport(*first_question);
  for (const std::size_t k : unread_tables) {
    if (kept.empty()) continue;
    std::string& reason = left_out[k].reason;
    reason = "not readable as a recording: " +
             reason.substr(std::min(reason.find_first_not_of("0123456789: "), reason.size()));
    left_out[k].failed = false;
    left_out[k].question.reset();
  }
  files = std::move(kept);
  return contents;
}

bool has_static_name(const DatasetFile& file) {
  const auto is_static = [](const std::string& name) { return parse_static_name(name).is_static; };
  return is_static(file.descriptor.stem) || std::ranges::any_of(file.descriptor.folders, is_static);
}

bool is_static_trial(const DatasetFile& file) {
  return has_static_name(file) && is_stationary(file.descriptor);
}

std::vector<std::string> candidate_names(const DatasetFile& file) {
  if (!file.from_folder) return {};
  const std::vector<std::string>& folders = file.descriptor.folders;
  const std::string& stem = file.descriptor.stem;
  const std::string extension = file.path.extension().string();
  const std::string short_name = joined_name(folders, stem);
  std::vector<std::string> names{short_name, joined_name(folders, stem, true)};
  if (extension.size() > 1) names.insert(names.begin() + 1, short_name + "_" + extension.substr(1));
  return names;
}

}  // namespace morphe::imports
