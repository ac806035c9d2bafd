#pragma once

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "core/files/atomic_file.hpp"

namespace morphe::exports {

/// Files of one folder that appear together. Each is written as "<name>.part" and renamed by
/// commit(); without commit() the parts are removed.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Adds a file, which the caller writes at its part(). Throws InputError if the name was added
  /// before.
  files::AtomicFile& add(const std::string& name);
  void add(const std::string& name, const std::string& text) { add(name).write(text); }
  /// Renames all files. Throws InputError, without changing any file, if one of them exists with
  /// other content and `replace` is false. Throws InputError if a file cannot be renamed; the new
  /// files are then removed again, but replaced ones are not restored.
  void commit(bool replace);
  const std::vector<std::string>& names() const { return names_; }  ///< in the order of add()

 private:
  std::filesystem::path folder_;
  std::list<files::AtomicFile> files_;
  std::vector<std::string> names_;
  std::set<std::string> used_names_;
};

}  // namespace morphe::exports
