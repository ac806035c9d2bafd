#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::commands {

/// The joints of the motion that is rebuilt from a recording, as a skeleton; the recording itself
/// where it is one, or the keypoints of a hand. Objects, names and facts stay. No skeleton and no
/// hand where nothing can be rebuilt.
Demonstration joints_of(const Demonstration& demonstration);

/// A folder of clips, one a demonstration.
class ClipOutput {
 public:
  explicit ClipOutput(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Writes NAME.npz. What cannot be rebuilt gets no clip: a line in text(). InputError if it
  /// cannot be written, or the name is none of a file.
  void add(const Demonstration& demonstration);
  std::string text() const;  ///< "DIR: 3 clips", and a line for each that there is none of

 private:
  std::filesystem::path folder_;
  std::size_t written_ = 0;
  std::vector<std::string> without_;
};

}  // namespace morphe::commands
