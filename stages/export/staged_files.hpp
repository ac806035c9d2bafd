#pragma once

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "core/files/atomic_file.hpp"

namespace morphe::exports {

/// Folders that were created for files: the destructor removes those that are still empty.
class CreatedFolders {
 public:
  CreatedFolders() = default;
  ~CreatedFolders();
  CreatedFolders(const CreatedFolders&) = delete;
  CreatedFolders& operator=(const CreatedFolders&) = delete;
  /// Creates a folder, with those above it. Throws InputError on failure.
  void create(const std::filesystem::path& folder);

 private:
  std::vector<std::filesystem::path> created_;  ///< the outer ones first
};

/// Files of one folder, or of folders in it, that appear together. Each is written as "<name>.part"
/// and renamed by commit(); without commit() the parts are removed.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Adds a file, which the caller writes at its part(). The name may contain folders, which are
  /// created. Throws InputError if the name was added before.
  files::AtomicFile& add(const std::string& name);
  void add(const std::string& name, const std::string& text) { add(name).write(text); }
  /// Renames all files. Throws InputError, without changing any file, if one of them exists with
  /// other content and `replace` is false. Throws InputError if a file cannot be renamed; the new
  /// files are then removed again, but replaced ones are not restored.
  void commit(bool replace);
  /// Throws InputError if a folder in the folder contains a file of this ending that was not added:
  /// readers that take all of them would read it, too.
  void expect_no_others(const std::string& inner, const std::string& ending) const;
  const std::vector<std::string>& names() const { return names_; }  ///< in the order of add()

 private:
  std::filesystem::path folder_;
  CreatedFolders created_;  // is destroyed after the part files in them
  std::list<files::AtomicFile> files_;
  std::vector<std::string> names_;
  std::set<std::string> used_names_;
};

}  // namespace morphe::exports
