#pragma once

#include <optional>
#include <string>
#include <vector>

namespace morphe {

/// The branch of the arm's inverse kinematics in which a path is (docs/formats.md#branches).
struct ArmBranch {
  /// Sum of 1: shoulder left, 2: elbow negative, 4: wrist flipped; absent without an elbow or path.
  std::optional<int> number;
  std::vector<std::string> words;    ///< "shoulder left", "elbow up", …, joints that are wound up
  std::vector<std::string> changes;  ///< changes of branch along the path, part by part

  bool operator==(const ArmBranch&) const = default;
};

}  // namespace morphe
