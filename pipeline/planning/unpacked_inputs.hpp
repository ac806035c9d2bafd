#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/plan.hpp"

namespace morphe::planning {

/// The inputs of a plans.h5 as files of a temporary folder, for as long as it lives. InputError for
/// an input that would lie outside of it.
class UnpackedInputs {
 public:
  explicit UnpackedInputs(const std::vector<PlanFileHeader::Input>& inputs);
  ~UnpackedInputs();
  UnpackedInputs(const UnpackedInputs&) = delete;
  UnpackedInputs& operator=(const UnpackedInputs&) = delete;

  /// A file that the config names: relative to the config, which comes first, or to one that it
  /// extends; a name from elsewhere is looked for by itself. Empty if there is none.
  std::filesystem::path find(const std::filesystem::path& named) const;
  /// Every file of that name, the one that find() gives first. Each has the others beside it, as
  /// far as there is none of their name: inputs that had no folder in common lost their own.
  std::vector<std::filesystem::path> all_of(const std::filesystem::path& named) const;
  /// Whether a file is one of the folder's.
  bool holds(const std::filesystem::path& file) const;
  /// A message that calls the files by what they are called in plans.h5.
  std::string as_stored(std::string message) const;

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> folders_;  ///< one for each input, in their order
  std::vector<std::filesystem::path> files_;    ///< [inputs]
};

}  // namespace morphe::planning
