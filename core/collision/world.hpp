#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::collision {

/// The target in the hand: it moves with a frame from begin_s to end_s as it lay there at begin_s,
/// and then stays where it is. Before, it is where it was recorded.
struct CarriedTarget {
  int frame = -1;                               ///< of the robot; -1: nothing is carried
  double begin_s = kNotSeen, end_s = kNotSeen;  ///< demonstration time, end NaN: never released
  Pose frame_from_object = Pose::Identity();
  Pose base_from_released = Pose::Identity();
  JointVector levers;  ///< [joints] as a row of Robot::capsule_levers
};

/// What must stay apart in one movement, everything in the robot's base frame. Robot and scene must
/// outlive it. All pairs of capsules but the allowed ones, and every capsule against every object.
/// A capsule that may touch the target may sink `contact_depth` into it (one that is no pad:
/// `link_depth`, if that is given) while touching is allowed (preshape to release, borders
/// included). Objects are where they were recorded, the target in the hand too unless
/// carry_target() told where the hand took hold of it.
struct CollisionWorld {
  const robot::Robot* robot = nullptr;
  const Scene* scene = nullptr;
  std::vector<std::shared_ptr<const MeshSolid>> meshes;  ///< [objects] null: no mesh, or broken
  int target = -1;                                       ///< index into scene->objects, -1 if none
  double touch_begin_s = kNotSeen, touch_end_s = kNotSeen;  ///< demonstration time, NaN = never
  Tolerances tolerances;
  std::vector<std::array<int, 2>> pairs;  ///< capsule pairs to check, from make_world()
  CarriedTarget carried;
};

/// Touching is allowed from the first preshape (or grasp, if there is none) to the end of the last
/// of grasp, hold and transport; never without a target or one of these three. Capsules that no
/// joint moves relative to each other are no pair. Meshes are made ready, but for those in `ready`.
CollisionWorld make_world(const robot::Robot& robot, const Scene& scene, const Movement& movement,
                          const Tolerances& tolerances, const ReadyMeshes& ready = {});

inline Solid solid_at(const CollisionWorld& world, std::size_t object) {
  return {world.scene->objects[object], world.meshes[object].get()};
}

/// Lets the target move with its `attached_frame` from the first sample at or after its attach_s to
/// the first one at or after its release_s, as this path [samples, joints] takes hold of it.
/// Without a frame of that name, or if the path ends before or at that time, nothing is carried.
/// What is carried is checked against the robot; against other objects it is not.
void carry_target(const std::vector<double>& demonstration_time, const JointRows& position,
                  CollisionWorld& world);

enum class TargetPlace { as_recorded, in_hand, released };
TargetPlace place_of_target(const CollisionWorld& world, double time_s);

/// One pair that is checked. slack = separation.distance - required.
struct PairSeparation {
  int capsule = 0;
  int other = 0;  ///< capsule, or object if `object`
  bool object = false;
  Separation separation;
  double required = 0;  ///< required_m() [m]
  double slack() const { return separation.distance - required; }
};

/// Capsules in a row, which mostly lie side by side: objects are looked at for all of them first.
inline constexpr std::size_t kCapsuleGroup = 6;

/// Per-thread scratch of the queries.
struct CollisionScratch {
  struct Ball {
    Vec3 centre;
    double radius = 0;
  };
  std::vector<Pose> base_from_frame;
  std::vector<CapsuleBody> bodies;
  std::vector<Ball> balls;   ///< [capsules] each holds its body
  std::vector<Ball> groups;  ///< each holds the balls of kCapsuleGroup capsules in a row
  std::vector<Pose> object_poses;
  std::vector<std::size_t> near_group;         ///< objects near the group of capsules at hand
  JointVector position, travel;                ///< of certified motion
  std::vector<double> body_travel;             ///< [capsules] [m]
  std::vector<double> object_travel;           ///< [objects] [m]
  std::vector<std::vector<std::size_t>> open;  ///< pairs not yet proved, by depth of bisection
};

/// Whether a capsule may touch an object at a demonstration time.
bool may_touch(const CollisionWorld& world, int capsule, int object, double time_s);
/// How deep a capsule that may touch the target may sink into it [m].
double touch_depth_m(const CollisionWorld& world, int capsule);
/// How far the two must stay apart then: the margin, or -touch_depth_m where touching is allowed.
double required_m(const CollisionWorld& world, int capsule, int object, double time_s);

/// Fills the scratch with all bodies at joint position q and demonstration time t.
void pose_bodies(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// The same where the scratch's base_from_frame is that of a joint position already.
void place_bodies(const CollisionWorld& world, double time_s, CollisionScratch& scratch);

/// Whether every pair has slack >= 0 at joint position q and demonstration time t.
bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch);

/// The pair with the least slack at joint position q and demonstration time t, the first one of
/// equals. With no pair at all, slack is +infinity and the capsule -1.
PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch);

/// All pairs with slack below `below_m`: capsule pairs in the order of world.pairs, then every
/// capsule with its objects.
void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// The same of bodies that are placed already.
void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// Least distance over the pairs that may not touch at this time [m]: what a trajectory's
/// `clearance` holds. +infinity if there is none.
double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// "hand_palm", "table": the names of a pair's two sides.
std::string first_name(const CollisionWorld& world, const PairSeparation& pair);
std::string second_name(const CollisionWorld& world, const PairSeparation& pair);

}  // namespace morphe::collision
