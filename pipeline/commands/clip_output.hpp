#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::commands {

/// Returns a demonstration with the joints of the motion reconstructed from a recording as a
/// skeleton, or the recording itself if it has a skeleton or the keypoints of a hand. Objects,
/// names and metadata are kept. Skeleton and hand are absent if the motion cannot be reconstructed.
Demonstration reconstructed_joints(const Demonstration& demonstration);

/// A folder of clips, one for each demonstration.
class ClipOutput {
 public:
  /// Uses the given folder, which is created with the first clip.
  explicit ClipOutput(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Writes NAME.npz. A demonstration that cannot be reconstructed has no clip and is listed in
  /// text(). Throws InputError if the clip cannot be written or the name is not a valid file name.
  void add(const Demonstration& demonstration);
  /// Returns "DIR: 3 clips" and a line for each demonstration without a clip.
  std::string text() const;

 private:
  std::filesystem::path folder_;
  std::size_t written_ = 0;
  std::vector<std::string> without_clip_;
};

}  // namespace morphe::commands
