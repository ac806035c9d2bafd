#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/robot/robot.hpp"

namespace morphe::collision {

/// Capsules of one frame that lie near each other, in a common box and a sphere about its centre.
struct CapsuleCluster {
  int frame = -1;
  Vec3 centre;                ///< of box and sphere, in the frame
  Vec3 half_size;             ///< of the box, along the axes of the frame [m]
  double radius = 0;          ///< of the sphere [m]
  std::vector<int> capsules;  ///< ascending
  /// Clusters with a capsule that is checked against one of these and comes after it, ascending.
  std::vector<int> partners;
};

/// The pairs of capsules i < j that are checked, in ascending order, and clusters of capsules, by
/// which queries exclude most of the pairs at once.
class CapsulePairs {
 public:
  CapsulePairs() = default;
  /// Takes pairs i < j in ascending order.
  CapsulePairs(const RobotModel& robot, std::vector<std::array<int, 2>> pairs);

  auto begin() const { return pairs_.begin(); }
  auto end() const { return pairs_.end(); }
  std::size_t size() const { return pairs_.size(); }
  bool empty() const { return pairs_.empty(); }
  /// Returns true if the pair is one of these; false if i >= j.
  bool contains(int i, int j) const { return checked_[i * cluster_of_.size() + j] != 0; }

  /// Removes the pairs for which `unwanted` returns true.
  void erase_if(const std::function<bool(const std::array<int, 2>&)>& unwanted);

  const std::vector<CapsuleCluster>& clusters() const { return clusters_; }
  int cluster_of(int capsule) const { return cluster_of_[capsule]; }

 private:
  void index_pairs();

  std::vector<std::array<int, 2>> pairs_;
  std::vector<CapsuleCluster> clusters_;
  std::vector<int> cluster_of_;  ///< [capsules]
  std::vector<char> checked_;    ///< [capsules * capsules] 1 for the pairs
};

}  // namespace morphe::collision
