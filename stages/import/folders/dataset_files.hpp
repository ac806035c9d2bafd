#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stages/import/folders/distinct_names.hpp"
#include "stages/import/folders/import_request.hpp"
#include "stages/import/folders/recording_descriptor.hpp"

namespace morphe::imports {

/// A file of a dataset that a format reads, and the properties found in it.
struct DatasetFile {
  std::filesystem::path path;
  std::string display_name;        ///< path relative to the dataset
  std::string names;               ///< ImportRequest::name_map if the file uses it, otherwise ""
  bool from_folder = false;        ///< true if found in a folder rather than given directly
  int request_index = 0;           ///< index in ImportRequest::paths of the path it came from
  RecordingDescriptor descriptor;  ///< its folders, format and points
  ReachingHand hand;
};

/// The contents of a dataset.
struct DatasetContents {
  std::vector<NamedEntry> entries;    ///< recordings that manifests list
  std::vector<DatasetFile> files;     ///< files that may be recordings or static trials
  std::vector<SkippedFile> left_out;  ///< all other files
};
/// Reads each file of a request once. Files given directly that cannot be read are kept, for the
/// import to report the error. Throws InputError for an unreadable manifest, UnresolvedImport if
/// there is neither an entry nor a file, and a file lacks only conventions or names.
DatasetContents dataset_files(const ImportRequest& request);

/// Returns true if the name of the file, or of one of its folders, is that of a static trial.
bool has_static_name(const DatasetFile& file);
/// Returns true if has_static_name() and the file's points are stationary.
bool is_static_trial(const DatasetFile& file);

/// Moves to `left_out` the files of folders that have the bytes of an earlier one, or that are the
/// same recording as an earlier one with the same folder and stem, but another format.
void remove_duplicates(std::vector<DatasetFile>& files, std::vector<SkippedFile>& left_out);

/// Returns candidates for the recording's name, the best first; empty for a file given directly.
std::vector<std::string> candidate_names(const DatasetFile& file);

}  // namespace morphe::imports
