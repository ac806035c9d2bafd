#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::planning {

/// The inputs of a plans.h5 as files of a temporary folder, which exists during the object's
/// lifetime. Throws InputError for an input that would be outside of the folder.
class UnpackedInputs {
 public:
  explicit UnpackedInputs(const std::vector<PlanFileHeader::Input>& inputs);
  ~UnpackedInputs();
  UnpackedInputs(const UnpackedInputs&) = delete;
  UnpackedInputs& operator=(const UnpackedInputs&) = delete;

  /// Returns a file named in the config: relative to the config, which is the first input, or to
  /// one that it extends; otherwise a file with the same name in any folder. Empty if there is no
  /// such file.
  std::filesystem::path find(const std::filesystem::path& named) const;
  /// Returns every file of that name, starting with the one that find() returns. The other inputs
  /// are copied beside each unless a file of their name exists, because inputs without a common
  /// folder have lost their own.
  std::vector<std::filesystem::path> find_all(const std::filesystem::path& named) const;
  /// Returns true if a file is inside the folder.
  bool contains(const std::filesystem::path& file) const;
  /// Replaces the folder in a message by the name of the inputs in plans.h5.
  std::string with_stored_paths(std::string message) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> folders_;  ///< one per input, in the same order
  std::vector<std::filesystem::path> files_;    ///< [inputs]
};

}  // namespace morphe::planning
