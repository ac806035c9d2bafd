#pragma once

#include <filesystem>
#include <list>
#include <set>
#include <string>
#include <vector>

#include "core/files/part_file.hpp"

namespace morphe::exports {

/// Files of one folder that appear together: each is written as "<name>.part" and renamed by
/// commit(); without that nothing is left of them.
class StagedFiles {
 public:
  explicit StagedFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// A file that the caller writes at part(). InputError if there is one of that name.
  files::PartFile& add(const std::string& name);
  void add(const std::string& name, const std::string& text);
  /// InputError, and no file is changed, if one with other content is in the way of one of them and
  /// may not be replaced.
  void commit(bool replace);
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::filesystem::path folder_;
  std::list<files::PartFile> files_;
  std::vector<std::string> names_;
  std::set<std::string> taken_;
};

}  // namespace morphe::exports
