#pragma once

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/collision/capsule_pairs.hpp"
#include "core/collision/carried_target.hpp"
#include "core/collision/distance.hpp"
#include "core/collision/mesh_solid.hpp"
#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"

namespace morphe::collision {

/// The collision world of one movement, in the robot's base frame. Robot and scene must outlive it.
/// Checked are the capsules of `pairs`, every capsule against every object, and a carried target
/// against every other object. From touch_begin_s
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
  CarriedTarget carried;
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
/// attachment. Attached or not, it is carried from that sample on (CarriedTarget).
void attach_target(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world);

/// Sets world.carried for a path on which the target is attached already, if it is attached at all.
void find_supports(const std::vector<double>& demonstration_time, const JointRows& position,
                   CollisionWorld& world);
/// Returns true if the target is carried, or has been, at a demonstration time.
bool is_carried(const CollisionWorld& world, double time_s);
/// Returns true if a carried target may touch another object at a demonstration time.
bool carried_may_touch(const CollisionWorld& world, int object, double time_s);
/// Returns the distance of a carried target that is required from another object [m].
double carried_required_distance_m(const CollisionWorld& world, int object, double time_s);

/// The state of the target at a time.
enum class TargetState { as_recorded, attached, released };
/// Returns the state of the target at a demonstration time.
TargetState target_state_at(const CollisionWorld& world, double time_s);

/// A pair that is checked: a capsule or the carried target, and another capsule or an object.
struct BodyPair {
  int first = 0;  ///< capsule, or object if `first_is_object`
  int other = 0;  ///< capsule, or object if `other_is_object`
  bool other_is_object = false;
  bool first_is_object = false;  ///< true of the carried target
  /// Returns the sort key that puts pairs into the order of near_pairs().
  std::tuple<bool, bool, int, int> key() const {
    return {first_is_object, other_is_object, first, other};
  }
};
/// The separation of a pair.
struct PairSeparation : BodyPair {
  Separation separation;
  double required_distance_m = 0;  ///< required_clearance for two capsules
  /// Returns the distance beyond the required one [m], < 0 if the pair is in collision.
  double slack() const { return separation.distance - required_distance_m; }
};
/// Returns the placeholder for no pair: its slack is +infinity and its first body -1.
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
/// Returns a pair with the distance that it requires at a demonstration time, not measured.
PairSeparation unmeasured(const CollisionWorld& world, const BodyPair& bodies, double time_s);
/// Returns true if the bodies of a pair may touch at a demonstration time.
bool may_touch(const CollisionWorld& world, const BodyPair& pair, double time_s);

/// Computes all bodies at a joint position and demonstration time.
void update_bodies(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                   double time_s, CollisionScratch& scratch);
/// Computes all bodies from the frame poses that are already in the scratch's base_from_frame.
void update_bodies_from_frames(const CollisionWorld& world, double time_s,
                               CollisionScratch& scratch);

/// Returns a lower bound of the distance of the carried target from an object [m], for bodies that
/// are already computed.
double carried_distance_bound(const CollisionWorld& world, const CollisionScratch& scratch,
                              int object);

/// Computes the separation of a pair whose bodies are already computed.
void measure(const CollisionWorld& world, const CollisionScratch& scratch, PairSeparation& pair);

/// Returns true if every pair has slack >= 0.
bool is_free(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
             CollisionScratch& scratch);

/// Returns the pair with the smallest slack, the first one of equals, or no_pair().
PairSeparation least_slack(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q,
                           double time_s, CollisionScratch& scratch);

/// Finds all pairs with slack below `below_m`: those of capsules in the order of world.pairs, then
/// those with objects, ordered by capsule and then by object, then those of the carried target.
void near_pairs(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                double below_m, CollisionScratch& scratch, std::vector<PairSeparation>& out);
/// Finds the same pairs for bodies that are already computed at time_s.
void near_pairs(const CollisionWorld& world, double time_s, double below_m,
                CollisionScratch& scratch, std::vector<PairSeparation>& out);

/// Returns the minimum distance over the pairs whose contact is not allowed at this time [m], as
/// stored in a trajectory's `clearance`. It is +infinity if there is no such pair.
double clearance(const CollisionWorld& world, const Eigen::Ref<const JointVector>& q, double time_s,
                 CollisionScratch& scratch);

/// Returns the name of the pair's first body, such as "hand_palm", or "cup" of a carried target.
std::string first_body_name(const CollisionWorld& world, const BodyPair& pair);
/// Returns the name of the pair's second capsule or object, such as "table".
std::string second_body_name(const CollisionWorld& world, const BodyPair& pair);

}  // namespace morphe::collision
