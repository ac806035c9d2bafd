#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/motion/export.hpp"

namespace morphe::files {

/// Files in memory from which readers read instead of the disk, such as the inputs stored in a
/// plans.h5. In paths and messages they are below a folder, as in "/inputs/robots/pa10.yaml".
/// Readers that take a `const GivenFiles*` read the disk if it is nullptr, and otherwise only these
/// files.
class MORPHE_EXPORT GivenFiles {
 public:
  /// Makes an empty collection, whose folder must be an absolute path.
  explicit GivenFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Adds a file by its path in the folder. Throws InputError if the path leaves the folder or is
  /// that of another file.
  void add(const std::string& relative_path, std::string bytes);

  /// Returns the path of the file that a reader means by `named`: the file of that path; otherwise,
  /// as files without a common folder lose their relative paths, the one of the same file name that
  /// agrees in most folders before it, the first added of several. Empty if there is none.
  std::filesystem::path find(const std::filesystem::path& named) const;
  /// Returns find(); throws InputError that names the file if it is not among these.
  std::filesystem::path locate(const std::filesystem::path& named) const;
  /// Returns the content of locate(named).
  const std::string& bytes(const std::filesystem::path& named) const;

 private:
  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::string> files_;
  std::vector<std::filesystem::path> order_;  ///< the keys of `files_` as they were added
};

/// Returns the path under which a file is read: the path itself on the disk, GivenFiles::locate()
/// otherwise.
MORPHE_EXPORT std::filesystem::path located(const std::filesystem::path& file,
                                            const GivenFiles* given);
/// Returns true if there is such a file.
MORPHE_EXPORT bool is_readable_file(const std::filesystem::path& file, const GivenFiles* given);
/// Returns the content of a file; throws InputError if it cannot be read.
MORPHE_EXPORT std::string read_bytes(const std::filesystem::path& file,
                                     const GivenFiles* given = nullptr);

}  // namespace morphe::files
