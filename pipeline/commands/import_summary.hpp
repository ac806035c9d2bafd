#pragma once

#include <filesystem>
#include <string>

#include "stages/import/import.hpp"

namespace morphe::commands {

/// Returns true for a demonstrations.h5, also a damaged one; false for a file to be imported.
bool is_demonstrations_file(const std::filesystem::path& file);

/// Returns the number of recordings found, the values that were assumed for them, and a line for
/// each file that was skipped or cannot be read; of many files with one reason, only the first and
/// the number of the others; and what to paste for those that lack something. Returns "" if no
/// value was assumed and no file skipped.
std::string import_summary_text(const imports::ImportResult& imported);

/// Returns the number of recordings that could not be read.
int count_failed(const imports::ImportResult& imported);

/// The manifest of the recordings found, written beside a result.
class GeneratedManifest {
 public:
  explicit GeneratedManifest(std::filesystem::path file) : file_(std::move(file)) {}
  /// Throws InputError if the file exists and is not as write() left it. To be called at first.
  void expect_replaceable() const;
  /// Returns the lines that list the recordings and the files that were not imported.
  std::string lines(const imports::ImportResult& imported) const;
  /// Writes or replaces the file.
  void write(const std::string& lines) const;

 private:
  std::filesystem::path file_;
};

}  // namespace morphe::commands
