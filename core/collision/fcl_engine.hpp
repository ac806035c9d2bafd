#pragma once

#include <memory>

#include "core/collision/world.hpp"

namespace morphe::collision {

/// FCL's verdict alone: collide() of capsules grown or shrunk by what is required, found by its
/// dynamic trees. Its depths and distances are not used: they are wrong at times, and some of its
/// queries abort. FCL's meshes are hollow: a capsule that touches no triangle is asked whether it
/// is inside; and where a capsule may sink deeper into a mesh than its radius, the exact distance
/// decides. FCL decides within about 1e-6 m. One engine a thread; the world must outlive it.
class FclEngine {
 public:
  explicit FclEngine(const CollisionWorld& world);
  ~FclEngine();
  FclEngine(const FclEngine&) = delete;
  FclEngine& operator=(const FclEngine&) = delete;

  /// True if every pair has slack >= 0.
  bool free(const Eigen::Ref<const JointVector>& q, double time_s, CollisionScratch& scratch);
  /// All pairs in collision, in the order of near_pairs(), with the separations of the closed
  /// forms.
  void pairs(const Eigen::Ref<const JointVector>& q, double time_s, CollisionScratch& scratch,
             std::vector<PairSeparation>& out);

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace morphe::collision
