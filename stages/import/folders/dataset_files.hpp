#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stages/import/folders/distinct_names.hpp"
#include "stages/import/folders/import_request.hpp"
#include "stages/import/folders/recording_sketch.hpp"

namespace morphe::imports {

/// A file of a dataset that a format reads, and what was seen in it.
struct DatasetFile {
  std::filesystem::path path;
  std::string called;      ///< its path below the dataset
  std::string names;       ///< the request's names, if it has them
  bool in_folder = false;  ///< found there, not given directly
  std::size_t given = 0;   ///< which path of the request it came from
  RecordingSketch sketch;
  ReachingHand hand;
};

/// Every file of the request that may be a recording or a static trial, each read once; what its
/// manifests list goes to `entries`, what is neither to `left_out`. InputError if a manifest cannot
/// be read; a file given directly that cannot is passed on.
std::vector<DatasetFile> dataset_files(const ImportRequest& request,
                                       std::vector<NamedEntry>& entries,
                                       std::vector<LeftOut>& left_out);

/// Its name or a folder's is that of a static trial.
bool named_as_static(const DatasetFile& file);
/// And its points stand still.
bool is_static_trial(const DatasetFile& file);

/// Takes away what repeats another file: its bytes, or in another format what lies beside it.
void leave_out_doubles(std::vector<DatasetFile>& files, std::vector<LeftOut>& left_out);

/// What it may be called, the best first.
std::vector<std::string> names_for(const DatasetFile& file);

}  // namespace morphe::imports
