#pragma once

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "core/files/atomic_file.hpp"

namespace morphe::exports {

/// Files of one folder that appear together: each is written as "<name>.part" and renamed by
/// commit(); without commit() all of them are removed.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Adds a file, to be written by the caller at part(). Throws InputError if the name is already
  /// in use.
  files::AtomicFile& add(const std::string& name);
  /// Adds a file with the given content.
  void add(const std::string& name, const std::string& text);
  /// Renames all files. Throws InputError, without changing any file, if a file with other content
  /// exists and may not be replaced.
  void commit(bool replace);
  /// Returns the names of the files.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::filesystem::path folder_;
  std::list<files::AtomicFile> files_;
  std::vector<std::string> names_;
  std::set<std::string> used_names_;
};

}  // namespace morphe::exports
