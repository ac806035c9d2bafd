#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::planning {

/// The inputs of a plans.h5 (first the config) as files of a temporary folder, which exists during
/// the object's lifetime. Throws InputError if it cannot be created or an input's path leaves it.
class UnpackedInputs {
 public:
  explicit UnpackedInputs(const std::vector<PlanFileHeader::Input>& inputs);
  ~UnpackedInputs();
  UnpackedInputs(const UnpackedInputs&) = delete;
  UnpackedInputs& operator=(const UnpackedInputs&) = delete;

  /// Returns the first file with the relative path `named` from an input's folder, in the order of
  /// the inputs; otherwise, the first with only its file name. Empty if there is no file.
  std::filesystem::path find(const std::filesystem::path& named) const;
  /// Returns find() and all other inputs with the same file name. Inputs without a common folder
  /// have lost their relative paths; so that each of these others finds the files that it names,
  /// all inputs are copied beside it, except over existing files.
  std::vector<std::filesystem::path> find_all(const std::filesystem::path& named) const;
  /// Returns true if a file is inside the folder.
  bool contains(const std::filesystem::path& file) const;
  /// Returns the message with the temporary folder replaced by "/inputs", its name in plans.h5.
  std::string with_stored_paths(std::string message) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> folders_;  ///< one per input, in the same order
  std::vector<std::filesystem::path> files_;    ///< [inputs]
};

}  // namespace morphe::planning
