#pragma once

#include <memory>

#include "core/collision/world.hpp"

namespace morphe::collision {

/// An independent collision check by FCL, to about 1e-6 m. It calls collide() for capsules grown or
/// shrunk by the required distance, with FCL's dynamic trees as broad phase. FCL's depths and
/// distances are not used: they are sometimes wrong, and some of its queries abort. FCL's meshes
/// are hollow, so a capsule that touches no triangle is tested for being inside. A capsule that may
/// penetrate a mesh deeper than its radius is judged by capsule_solid(), and a carried target by
/// solid_solid(). Each thread needs its own engine; the world must outlive it.
class FclEngine {
 public:
  /// Builds the trees of capsules and objects.
  explicit FclEngine(const CollisionWorld& world);
  ~FclEngine();
  FclEngine(const FclEngine&) = delete;
  FclEngine& operator=(const FclEngine&) = delete;

  /// Returns true if every pair has slack >= 0.
  bool is_free(const Eigen::Ref<const JointVector>& q, double time_s, CollisionScratch& scratch);
  /// Finds all pairs in collision, in the order of near_pairs(), with the separations of measure().
  void colliding_pairs(const Eigen::Ref<const JointVector>& q, double time_s,
                       CollisionScratch& scratch, std::vector<PairSeparation>& out);

 private:
  struct Trees;
  std::unique_ptr<Trees> trees_;
};

}  // namespace morphe::collision
