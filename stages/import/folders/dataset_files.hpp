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
  std::string display_name;       ///< path relative to the dataset
  std::string names;              ///< the request's name map if the file uses it, otherwise ""
  bool from_folder = false;       ///< true if found in a folder rather than given directly
  std::size_t request_index = 0;  ///< index of the path of the request that it came from
  RecordingDescriptor sketch;     ///< its folders, format and points
  ReachingHand hand;              ///< the hand that reaches in it
};

/// Returns every file of the request that may be a recording or a static trial, each read once.
/// Recordings listed by manifests are added to `entries`, all other files to `left_out`. Throws
/// InputError if a manifest cannot be read; a file given directly that cannot be read is kept.
std::vector<DatasetFile> dataset_files(const ImportRequest& request,
                                       std::vector<NamedEntry>& entries,
                                       std::vector<SkippedFile>& left_out);

/// Returns true if its name or a folder's is that of a static trial.
bool has_static_name(const DatasetFile& file);
/// Returns true if in addition its points are stationary.
bool is_static_trial(const DatasetFile& file);

/// Removes duplicates of other files: identical bytes, or the same recording in another format
/// beside it.
void remove_duplicates(std::vector<DatasetFile>& files, std::vector<SkippedFile>& left_out);

/// Returns candidates for the file's name, the best first.
std::vector<std::string> candidate_names(const DatasetFile& file);

}  // namespace morphe::imports
