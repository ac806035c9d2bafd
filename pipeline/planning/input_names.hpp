#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::planning {

/// How the files of a run are called in its plans.h5, so that names say neither where the files are
/// nor whose they are. A file named by an absolute path, and all that are named relative to it, are
/// a group. The files of a group are named relative to their deepest common folder; if that is / or
/// directly below it, they are first divided by the two outermost folders. A group of which
/// a name is already in use gets a numbered folder.
class InputNames {
 public:
  /// `files` are paths as they were opened, the config's first and each after the one that names
  /// it; some may appear several times.
  explicit InputNames(const std::vector<std::filesystem::path>& files);

  /// Also replaces this absolute path of a file that is not an input, by its file name.
  void hide(const std::filesystem::path& file);

  /// Returns the files, read from the disk, with short names in place of their absolute paths.
  std::vector<PlanFileHeader::Input> read() const;
  /// Returns a text of the file `from` with the absolute paths of files replaced by their names,
  /// relative to the name of `from`.
  std::string without_paths(std::string text, const std::filesystem::path& from) const;

 private:
  struct File {
    std::filesystem::path opened;  ///< as written, if it was named by an absolute path
    std::filesystem::path path;    ///< normal and absolute
    std::string name;
  };
  const File* find(const std::filesystem::path& opened) const;
  void add_group(const std::vector<std::filesystem::path>& group, std::set<std::string>& used);

  std::vector<File> files_;
  std::map<std::string, std::string> hidden_;  ///< names by absolute paths
};

}  // namespace morphe::planning
