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
#include "stages/import/guess/import_question.hpp"
#include "stages/import/guess/name_map.hpp"
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

/// Its folders below `root`, behind `above`, and what it is called.
DatasetFile file_below(const fs::path& path, const fs::path& root,
                       const std::vector<std::string>& above) {
  DatasetFile file;
  file.path = path;
  file.in_folder = true;
  const fs::path below = path.lexically_relative(root);
  file.called = below.generic_string();
  file.sketch.folders = above;
  for (std::string& folder : folders_on(below.parent_path())) {
    file.sketch.folders.push_back(std::move(folder));
  }
  file.sketch.stem = path.stem().string();
  return file;
}

/// A manifest of a folder decides for all below it.
struct FolderManifest {
  fs::path file;
  std::set<fs::path> uses;  ///< without links
};

FolderManifest read_folder_manifest(const ImportRequest& request, const DatasetFile& manifest,
                                    std::vector<NamedEntry>& entries) {
  FolderManifest read{manifest.path, {}};
  for (ManifestEntry& entry : entries_of(request, manifest.path, true)) {
    for (const std::string& used : {entry.file, entry.static_trial, entry.glove, entry.static_glove,
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

/// Why a file of a folder is no recording to be read, "" if it may be one.
std::string why_not_read(const ImportRequest& request, const fs::path& path,
                         const RecordingFormat* format) {
  if (format == nullptr && store::has_hdf5_signature(path))
    return "an HDF5 file: if it holds demonstrations, give it by itself";
  if (is_yaml(path) && holds_key_recordings(path)) return "a manifest: give it by itself";
  if (format == nullptr) return "not a recording";
  if (!request.format.empty() && format->name != request.format) {
    return fmt::format("{}, not {}", format->name, request.format);
  }
  if (format->name == "clip-npz" && !holds_a_clip(path)) {
    return "not a recording: an .npz with no key of a clip, such as mano_right_joints";
  }
  return format->name == "mot" ? "joint angles alone, from which no arm can be rebuilt" : "";
}

/// Those files of a folder that may be recordings.
void add_folder(const ImportRequest& request, const fs::path& folder,
                const std::vector<std::string>& above, std::vector<NamedEntry>& entries,
                std::vector<DatasetFile>& files, std::vector<LeftOut>& left_out) {
  FolderFiles found = files_below(folder, request.results);
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
      std::string why = why_not_read(request, path, format);
      if (why.empty() && manifest != nullptr) {
        why = fmt::format("{} does not list it",
                          manifest->file.lexically_relative(folder).generic_string());
      }
      if (!why.empty()) {
        left_out.push_back({path, why});
        continue;
      }
      files.push_back(file_below(path, folder, above));
      files.back().sketch.format = format->name;
    } catch (const InputError& fault) {
      left_out.push_back(unreadable(path, fault));
    }
  }
}

DatasetFile direct_file(const ImportRequest& request, const fs::path& path) {
  DatasetFile file;
  file.path = path;
  file.called = path.filename().string();
  file.names = request.names.string();
  file.sketch.folders = folders_on(path.parent_path());
  file.sketch.stem = path.stem().string();
  const RecordingFormat* const format = request.format.empty() ? recognised_format(path) : nullptr;
  file.sketch.format = format != nullptr ? format->name : request.format;
  return file;
}

/// As it will be imported, but for what is still to be found out.
Demonstration read_file(const ImportRequest& request, const DatasetFile& file) {
  ManifestEntry entry;
  entry.file = file.path.string();
  entry.format = file.sketch.format;
  entry.names = file.names;
  entry.conventions = request.conventions;
  return read_recording(entry);
}

/// Recordings are told to belong together by the names of their points.
void rename_those_there(const NameMap& names, Demonstration& demonstration) {
  if (!demonstration.streams.markers) return;
  for (std::string& name : demonstration.streams.markers->names) {
    if (const auto found = names.find(name); found != names.end()) name = found->second;
  }
}

/// Names that are given for a folder are meant for the files that have them; of a recording given
/// directly, its static trial may have some.
Demonstration read_with_names(const ImportRequest& request, DatasetFile& file) {
  if (request.names.empty()) return read_file(request, file);
  file.names = request.names.string();
  try {
    return read_file(request, file);
  } catch (const InputError&) {
    file.names.clear();
  }
  try {
    Demonstration demonstration = read_file(request, file);
    if (!file.in_folder) file.names = request.names.string();
    return demonstration;
  } catch (const ImportQuestion& question) {
    if (!question.without_names) throw;
    file.names = request.names.string();  // the rest of them may be its static trial's
    Demonstration demonstration = *question.without_names;
    rename_those_there(read_names(request.names), demonstration);
    return demonstration;
  }
}

/// Keeps the first question, and of the others what they propose for further names.
void keep_question(const ImportQuestion& question, std::optional<ImportQuestion>& open) {
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

void look_into(const ImportRequest& request, DatasetFile& file) {
  const Demonstration demonstration = read_with_names(request, file);
  RecordingSketch sketch = sketch_of(demonstration);
  sketch.folders = std::move(file.sketch.folders);
  sketch.stem = std::move(file.sketch.stem);
  sketch.format = std::move(file.sketch.format);
  file.sketch = std::move(sketch);
  const std::optional<Side> said = hand_in_file(file.path, file.sketch.format);
  file.hand = said ? ReachingHand{*said, fmt::format("the {} hand reaches, as the file says",
                                                     name_of(*said))}
                   : reaching_hand(demonstration, file.sketch);
}

}  // namespace

std::vector<DatasetFile> dataset_files(const ImportRequest& request,
                                       std::vector<NamedEntry>& entries,
                                       std::vector<LeftOut>& left_out) {
  const bool several = std::ranges::count_if(request.paths, [](const fs::path& path) {
                         return fs::is_directory(path);
                       }) > 1;
  std::vector<DatasetFile> files, read;
  std::vector<std::size_t> tables;  // any table may look like points: beside recordings it is none
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
    for (std::size_t k = entries_before; k < entries.size(); ++k) entries[k].path = given;
    for (std::size_t k = files_before; k < files.size(); ++k) files[k].given = given;
  }
  std::optional<ImportQuestion> open;  // asked of the whole folder where none of it can be read
  for (DatasetFile& file : files) {
    try {
      look_into(request, file);
      read.push_back(std::move(file));
    } catch (const InputError& fault) {
      if (!file.in_folder) {  // what is wrong with it is told when it is imported
        file.names = request.names.string();
        read.push_back(std::move(file));
        continue;
      }
      const auto* const question = dynamic_cast<const ImportQuestion*>(&fault);
      if (question != nullptr) keep_question(*question, open);
      left_out.push_back(unreadable(file.path, fault));
      if (file.sketch.format == "point-csv") tables.push_back(left_out.size() - 1);
    }
  }
  if (read.empty() && entries.empty() && open) throw ImportQuestion(*open);
  for (const std::size_t k : tables) {
    if (read.empty()) continue;
    std::string& why = left_out[k].why;
    why = "not a recording as it stands: " +
          why.substr(std::min(why.find_first_not_of("0123456789: "), why.size()));
    left_out[k].failed = false;
  }
  return read;
}

bool named_as_static(const DatasetFile& file) {
  const auto says = [](const std::string& name) { return read_static_name(name).is_static; };
  return says(file.sketch.stem) || std::ranges::any_of(file.sketch.folders, says);
}

bool is_static_trial(const DatasetFile& file) {
  return named_as_static(file) && stands_still(file.sketch);
}

std::vector<std::string> names_for(const DatasetFile& file) {
  if (!file.in_folder) return {};
  const std::vector<std::string>& folders = file.sketch.folders;
  const std::string& stem = file.sketch.stem;
  const std::string ending = file.path.extension().string();
  const std::string short_name = joined_name(folders, stem);
  std::vector<std::string> names{short_name, joined_name(folders, stem, true)};
  if (ending.size() > 1) names.insert(names.begin() + 1, short_name + "_" + ending.substr(1));
  return names;
}

}  // namespace morphe::imports
