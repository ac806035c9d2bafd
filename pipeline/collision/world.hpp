#pragma once

#include <array>
#include <string>
#include <vector>

#include "pipeline/collision/distance.hpp"
#include "pipeline/motion/plan.hpp"
#include "pipeline/motion/robot_table.hpp"

namespace morphe {

/// What must stay apart in one movement, everything in the robot's base frame. Robot and scene must
/// outlive it. All pairs of capsules but the allowed ones, and every capsule against every object.
/// A capsule that may touch the target may sink `contact_depth` into it while touching is allowed
/// (preshape to release) and between `attach_s` and `release_s` the target moves with the hand.
struct CollisionWorld {
  const RobotTable* robot = nullptr;
  const Scene* scene = nullptr;
  int target = -1;  ///< index into scene->objects, -1 if none
  double touch_begin_s = kNotSeen, touch_end_s = kNotSeen;  ///< demonstration time, NaN = never
  Tolerances tolerances;
  std::vector<std::array<int, 2>> pairs;  ///< capsule pairs to check, from make_world()
};

/// Touching is allowed from the first preshape (or grasp, if there is none) to the end of the last
/// of grasp, hold and transport.
CollisionWorld make_world(const RobotTable& robot, const Scene& scene, const Movement& movement,
                          const Tolerances& tolerances);

/// One pair that is checked. slack = separation.distance - required.
struct PairSeparation {
  int capsule = 0;
  int other = 0;  ///< capsule, or object if `object`
  bool object = false;
  Separation separation;
  double required = 0;  ///< the margin, or -contact_depth where touching is allowed [m]
  double slack() const { return separation.distance - required; }
};

/// Per-thread scratch of the queries.
struct CollisionScratch {
  std::vector<Pose> base_from_frame;
  std::vector<CapsuleBody> bodies;
  std::vector<Pose> object_poses;
};

/// The pair with the least slack at joint position q and demonstration time t. With no pair at all,
/// slack is +infinity.
PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch);

/// All pairs with slack below `below_m`, in a fixed order.
void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// Least distance over the pairs that may not touch at this time [m]: what a trajectory's
/// `clearance` holds.
double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// The verdict of FCL alone (collide() of capsules grown or shrunk by what is required): true if
/// every pair has slack >= 0.
bool free_by_fcl(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// "hand_palm", "table": the names of a pair's two sides.
std::string first_name(const CollisionWorld& world, const PairSeparation& pair);
std::string second_name(const CollisionWorld& world, const PairSeparation& pair);

}  // namespace morphe
