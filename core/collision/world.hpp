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

/// The target as an attached object: it moves with a frame from begin_s to end_s, with its pose
/// relative to the frame at begin_s, and remains at its last pose afterwards. Before begin_s it has
/// its recorded pose.
struct AttachedTarget {
  int frame = -1;                               ///< robot frame, -1 if the target is not attached
  double begin_s = kUnknown, end_s = kUnknown;  ///< demonstration time, end NaN: never released
  Pose frame_from_object = Pose::Identity();
  Pose base_from_released = Pose::Identity();
  JointVector motion_bounds;  ///< [joints] like a row of Robot::capsule_motion_bounds
};

/// The collision world of one movement, in the robot's base frame. Robot and scene must outlive it.
/// It checks all pairs of capsules except the allowed ones, and every capsule against every object.
/// A capsule that may touch the target may penetrate it by `max_penetration` (a capsule without a
/// pad by `max_link_penetration`, if given) while contact is allowed (preshape to release,
/// boundaries included). Objects have their recorded poses, and so has the target in the hand
/// unless attach_target() has set the time at which the hand grasps it.
struct CollisionWorld {
  const robot::Robot* robot = nullptr;
  const Scene* scene = nullptr;
  /// [objects] null if not a mesh, or invalid.
  std::vector<std::shared_ptr<const MeshSolid>> meshes;
  /// Index into scene->objects, -1 if there is no target.
  int target = -1;
  double touch_begin_s = kUnknown, touch_end_s = kUnknown;  ///< demonstration time, NaN = never
  Tolerances tolerances;
  std::vector<std::array<int, 2>> pairs;  ///< capsule pairs to check, from make_world()
  AttachedTarget attached;
};

/// Builds the world of a movement. Contact is allowed from the first preshape (or grasp, if there
/// is no preshape) to the end of the last grasp, hold or transport phase; never without a target or
/// without one of these three phases. Capsules that no joint moves relative to each other do not
/// form a pair. Meshes are preprocessed unless they are in `ready`.
CollisionWorld make_world(const robot::Robot& robot, const Scene& scene, const Movement& movement,
                          const Tolerances& tolerances, const MeshCache& ready = {});

/// Returns the geometry of an object for distance queries.
inline Solid solid_at(const CollisionWorld& world, std::size_t object) {
  return {world.scene->objects[object], world.meshes[object].get()};
}

/// Attaches the target to its `attached_frame` from the first sample at or after its attach_s to
/// the first sample at or after its release_s, with the relative pose that this path [samples,
/// joints] gives. It is not attached if there is no frame of that name, or if the path ends before
/// or at that time. An attached target is checked against the robot, but not against other objects.
void attach_target(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world);

/// The attachment of the target at a time.
enum class TargetState { as_recorded, attached, released };
/// Returns the attachment of the target at a demonstration time.
TargetState target_state_at(const CollisionWorld& world, double time_s);

/// The separation of a pair that is checked. slack = separation.distance - required_distance_m.
struct PairSeparation {
  int capsule = 0;
  int other = 0;  ///< capsule, or object if `other_is_object`
  bool other_is_object = false;
  Separation separation;
  double required_distance_m = 0;  ///< as returned by required_distance_m() [m]
  /// Returns the distance beyond the required one [m], < 0 if the pair is in collision.
  double slack() const { return separation.distance - required_distance_m; }
};

/// Number of consecutive capsules, which mostly lie side by side, for which objects near them are
/// found at once.
inline constexpr std::size_t kCapsuleGroup = 6;

/// Buffers of the queries, one for each thread.
struct CollisionScratch {
  /// A sphere that contains a body or a group of bodies.
  struct BoundingSphere {
    Vec3 centre;
    double radius = 0;
  };
  std::vector<Pose> base_from_frame;
  std::vector<CapsuleBody> bodies;
  std::vector<BoundingSphere> bounding_spheres;  ///< [capsules] each contains its capsule
  std::vector<BoundingSphere> groups;            ///< each contains kCapsuleGroup spheres
  std::vector<Pose> object_poses;
  std::vector<std::size_t> near_group;  ///< objects near the current group of capsules
  JointVector position, travel;         ///< of continuous checks
  std::vector<double> body_travel;      ///< [capsules] [m]
  std::vector<double> object_travel;    ///< [objects] [m]
  /// Pairs that are not yet proved free, by depth of bisection.
  std::vector<std::vector<std::size_t>> undecided_pairs;
};

/// Returns true if a capsule may touch an object at a demonstration time.
bool may_touch(const CollisionWorld& world, int capsule, int object, double time_s);
/// Returns the depth by which a capsule that may touch the target may penetrate it [m].
double allowed_contact_depth_m(const CollisionWorld& world, int capsule);
/// Returns the required distance of a capsule and an object at a time: the margin, or
/// -allowed_contact_depth_m if contact is allowed.
double required_distance_m(const CollisionWorld& world, int capsule, int object, double time_s);

/// Computes all bodies at joint position q and demonstration time t.
void update_bodies(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                   double time_s, CollisionScratch& scratch);

/// Computes all bodies from the frame poses that are already in the scratch's base_from_frame.
void update_bodies_from_frames(const CollisionWorld& world, double time_s,
                               CollisionScratch& scratch);

/// Returns true if every pair has slack >= 0 at joint position q and demonstration time t.
bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch);

/// Returns the pair with the smallest slack at joint position q and demonstration time t, the first
/// one of equals. If there are no pairs, slack is +infinity and the capsule is -1.
PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch);

/// Finds all pairs with slack below `below_m`: capsule pairs in the order of world.pairs, then
/// every capsule with its objects.
void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// Finds these pairs for bodies that are already computed.
void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// Returns the minimum distance over the pairs that may not touch at this time [m], as stored in a
/// trajectory's `clearance`. It is +infinity if there is no such pair.
double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// Returns the name of the pair's capsule, such as "hand_palm".
std::string first_body_name(const CollisionWorld& world, const PairSeparation& pair);
/// Returns the name of the pair's second capsule or object, such as "table".
std::string second_body_name(const CollisionWorld& world, const PairSeparation& pair);

}  // namespace morphe::collision
