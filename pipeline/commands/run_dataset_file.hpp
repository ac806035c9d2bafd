#pragma once

#include <filesystem>
#include <string>

#include "pipeline/commands/import_summary.hpp"
#include "pipeline/commands/kept_import.hpp"

namespace morphe::commands {

/// The demonstrations.h5 of a run: the given one, or a file in the run's folder with the imported
/// recordings. This file has a temporary name until the plans are complete. Then publish() gives it
/// its name and writes a manifest of the recordings. If the run is stopped before, also by a signal
/// that ends the process at once, the file is kept, and used by the next run if the recordings and
/// the request are unchanged; after an error it is removed.
class RunDatasetFile {
 public:
  /// Imports the recordings, unless a stopped run has done so. `fresh` imports them in any case.
  RunDatasetFile(imports::ImportRequest request, const std::filesystem::path& folder, bool fresh);
  ~RunDatasetFile();
  RunDatasetFile(const RunDatasetFile&) = delete;
  RunDatasetFile& operator=(const RunDatasetFile&) = delete;
  const std::filesystem::path& file() const { return file_; }
  const std::string& key() const { return key_; }  ///< the paths, by which a run knows it
  int failed() const { return import_.failed; }    ///< number of recordings that could not be read
  /// Keeps the file for the next run.
  void keep() { kept_ = true; }
  /// Moves the file to its final name.
  void publish();

 private:
  void import(const imports::ImportRequest& request, bool fresh);

  std::filesystem::path file_, final_file_, record_;
  std::string key_;
  GeneratedManifest manifest_;
  bool writes_manifest_ = false, kept_ = false;
  KeptImport import_;
};

}  // namespace morphe::commands
