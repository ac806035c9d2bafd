#pragma once

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/collision/capsule_pairs.hpp"
#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::collision {

/// The target as an attached object. Before begin_s it has its recorded pose. From begin_s to end_s
/// it keeps its pose relative to a frame of the robot. Afterwards it remains where it was released.
struct AttachedTarget {
  int frame = -1;                               ///< robot frame, -1 if the target is not attached
  double begin_s = kUnknown, end_s = kUnknown;  ///< demonstration time; end NaN if never released
  Pose frame_from_object = Pose::Identity();
  Pose base_from_released = Pose::Identity();
  JointVector motion_bounds;  ///< [joints] like a row of Robot::capsule_motion_bounds
};

/// The collision world of one movement, in the robot's base frame. Robot and scene must outlive it.
/// Checked are the capsules of `pairs`, and every capsule against every object. From touch_begin_s
/// to touch_end_s, both included, a capsule with may_touch_target may penetrate the target by
/// allowed_contact_depth_m(). Objects have their recorded poses, and so has the target unless
/// attach_target() has attached it.
struct CollisionWorld {
  const robot::Robot* robot = nullptr;
  const Scene* scene = nullptr;
  std::vector<std::shared_ptr<const MeshSolid>> meshes;  ///< [objects] null if not a valid mesh
  int target = -1;  ///< index into scene->objects, -1 if there is no target
  double touch_begin_s = kUnknown, touch_end_s = kUnknown;  ///< demonstration time, NaN = never
  Tolerances tolerances;
  CapsulePairs pairs;  ///< checked capsules, see make_world()
  AttachedTarget attached;
};

/// Builds the world of a movement. Contact is allowed from the first preshape (or grasp, if there
/// is no preshape) to the end of the last grasp, hold or transport phase, with 1 ns on either side
/// for samples on the borders. It is never allowed without a target in the scene, without preshape
/// and grasp, or without grasp, hold and transport.
/// Two capsules form a pair if a joint moves one relative to the other and the robot's
/// allowed_collision_pairs lack them. Meshes are preprocessed unless they are in `ready`. Throws
/// std::logic_error if capsule_motion_bounds does not have one row for each capsule.
CollisionWorld make_world(const robot::Robot& robot, const Scene& scene, const Movement& movement,
                          const Tolerances& tolerances, const MeshCache& ready = {});

/// Returns the geometry of an object for distance queries.
inline Solid solid_at(const CollisionWorld& world, std::ptrdiff_t object) {
  return {world.scene->objects[object], world.meshes[object].get()};
}

/// Attaches the target to its `attached_frame` from the first sample at or after its attach_s to
/// the first one at or after its release_s, if any. `position` [samples, joints] is the path; the
/// target keeps the pose in the frame that it has at the sample of attachment. It is not attached
/// if the robot has no such frame, if attach_s is unknown, or if no sample follows that of
/// attachment. An attached target is checked against the robot, but not against other objects.
void attach_target(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world);

/// The state of the target at a time.
enum class TargetState { as_recorded, attached, released };
/// Returns the state of the target at a demonstration time.
TargetState target_state_at(const CollisionWorld& world, double time_s);

/// A pair that is checked: a capsule, and another capsule or an object.
struct BodyPair {
  int capsule = 0;
  int other = 0;  ///< capsule, or object if `other_is_object`
  bool other_is_object = false;
  /// Returns the sort key that puts pairs into the order of near_pairs().
  std::tuple<bool, int, int> key() const { return {other_is_object, capsule, other}; }
};
/// The separation of a pair.
struct PairSeparation : BodyPair {
  Separation separation;
  double required_distance_m = 0;  ///< required_clearance for two capsules
  /// Returns the distance beyond the required one [m], < 0 if the pair is in collision.
  double slack() const { return separation.distance - required_distance_m; }
};
/// Returns the placeholder for no pair: its slack is +infinity and its capsule -1.
inline PairSeparation no_pair() { return {{-1, 0, false}, {kInfinity, {}, {}, {}}, 0}; }

/// Buffers of the queries; each thread needs its own.
struct CollisionScratch {
  /// A sphere that contains a body or a cluster of bodies.
  struct BoundingSphere {
    Vec3 centre;
    double radius = 0;
  };
  /// A cluster of capsules, and what the current query cannot exclude for all of them.
  struct Cluster {
    BoundingSphere sphere;
    std::vector<int> near_partners, near_objects;
  };
  std::vector<Pose> base_from_frame;
  std::vector<CapsuleBody> bodies;
  std::vector<BoundingSphere> bounding_spheres;  ///< [capsules] each contains its capsule
  std::vector<Cluster> clusters;                 ///< as in CapsulePairs
  std::vector<Pose> object_poses;
  std::vector<int> near_capsules;                      ///< of the current capsule, ascending
  JointVector position, travel;                        ///< of continuous checks
  std::vector<double> body_travel;                     ///< [capsules] [m]
  std::vector<double> object_travel;                   ///< [objects] [m]
  std::vector<std::vector<BodyPair>> undecided_pairs;  ///< not yet proved free, by bisection depth
};

/// Returns true if a capsule's contact with an object is allowed at a demonstration time.
bool may_touch(const CollisionWorld& world, int capsule, int object, double time_s);
/// Returns the depth by which a capsule with may_touch_target may penetrate the target [m]:
/// max_penetration for a pad; for others max_link_penetration or, if absent, max_penetration.
double allowed_contact_depth_m(const CollisionWorld& world, int capsule);
/// Returns the required distance of a capsule and an object at a demonstration time [m]: the
/// required clearance, or -allowed_contact_depth_m() if contact is allowed.
double required_distance_m(const CollisionWorld& world, int capsule, int object, double time_s);

/// Computes all bodies at a joint position and demonstration time.
void update_bodies(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                   double time_s, CollisionScratch& scratch);
/// Computes all bodies from the frame poses that are already in the scratch's base_from_frame.
void update_bodies_from_frames(const CollisionWorld& world, double time_s,
                               CollisionScratch& scratch);

/// Computes the separation of a pair whose bodies are already computed.
void measure(const CollisionWorld& world, const CollisionScratch& scratch, PairSeparation& pair);

/// Returns true if every pair has slack >= 0.
bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch);

/// Returns the pair with the smallest slack, the first one of equals, or no_pair().
PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch);

/// Finds all pairs with slack below `below_m`: those of capsules in the order of world.pairs, then
/// those with objects, ordered by capsule and then by object.
void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out);
/// Finds the same pairs for bodies that are already computed at time_s.
void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// Returns the minimum distance over the pairs whose contact is not allowed at this time [m], as
/// stored in a trajectory's `clearance`. It is +infinity if there is no such pair.
double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// Returns the name of the pair's capsule, such as "hand_palm".
std::string first_body_name(const CollisionWorld& world, const BodyPair& pair);
/// Returns the name of the pair's second capsule or object, such as "table".
std::string second_body_name(const CollisionWorld& world, const BodyPair& pair);

}  // namespace morphe::collision
