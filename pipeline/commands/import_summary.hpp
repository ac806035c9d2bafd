#pragma once

#include <filesystem>
#include <string>

#include "stages/import/import.hpp"

namespace morphe::commands {

/// Returns true for a demonstrations.h5, identified by its extension or its first bytes; any other
/// file is to be imported.
bool is_demonstrations_file(const std::filesystem::path& file);

/// Returns a summary for display: the recordings found in the folders of a request, the values that
/// were assumed for them, and a line for each file that was left out (if there are many with one
/// reason: the first of them and their number). Returns "" if there are no remarks.
std::string import_summary_text(const imports::ImportResult& imported);

/// Returns the number of recordings that could not be read.
int count_failed(const imports::ImportResult& imported);

/// The generated manifest of the recordings found, beside a result. A manifest that was written by
/// somebody else, or edited since, is not replaced.
class GeneratedManifest {
 public:
  /// Uses the given path.
  explicit GeneratedManifest(std::filesystem::path file) : file_(std::move(file)) {}
  /// Throws InputError if the file exists and must not be replaced. To be called before any other
  /// work.
  void expect_replaceable() const;
  /// Writes the manifest.
  void write(const imports::ImportResult& imported) const;

 private:
  std::filesystem::path file_;
};

}  // namespace morphe::commands
