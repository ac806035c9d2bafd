#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "pipeline/run/output_folder.hpp"

namespace morphe::commands {

/// Returns the demonstration itself if it can be written as a clip: it has a skeleton or the
/// keypoints of a hand. Otherwise returns it with the joints of its reconstructed motion as a
/// skeleton instead of its streams; without a skeleton if no joint can be reconstructed.
Demonstration reconstructed_joints(const Demonstration& demonstration);

/// A folder of clips, one for each demonstration.
class ClipOutput {
 public:
  /// The folder is created and locked with the first clip.
  explicit ClipOutput(std::filesystem::path folder) : path_(std::move(folder)) {}
  /// Writes NAME.npz. A demonstration that cannot be reconstructed has no clip and is listed in
  /// text(). Throws InputError if the clip cannot be written or the name is not a valid file name.
  void add(const Demonstration& demonstration);
  /// Returns "DIR: 3 clips" and a line for each demonstration without a clip.
  std::string text() const;

 private:
  std::filesystem::path path_;
  std::optional<run::OutputFolder> folder_;
  std::size_t written_ = 0;
  std::vector<std::string> without_clip_;
};

}  // namespace morphe::commands
