#include "stages/map/reference_posture.hpp"

#include <algorithm>
#include <cmath>

#include "core/collision/world.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "stages/map/choose_branch.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/constants.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/map_movement.hpp"
#include "stages/map/posture_symmetries.hpp"
#include "stages/map/rest_branch.hpp"

namespace morphe::map {
namespace {

/// A posture of the human arm in the plane of the shoulder, the hand pointing forward.
struct ArmPosture {
  double upper_arm_rad;  ///< of the upper arm forward from hanging
  double forearm_rad;    ///< of the forearm upward from pointing forward
};

/// Returns two frames of a person, at rest and reaching, in the world frame; a left hand is
/// mirrored at x = 0.
HumanMotion rest_and_reach(Side side) {
  const double outwards = side == Side::right ? 1 : -1;
  Eigen::Matrix3d world_from_hand;  // z forward, x out of the palm: inwards
  world_from_hand.col(2) = Vec3::UnitY();
  world_from_hand.col(0) = Vec3(-outwards, 0, 0);
  world_from_hand.col(1) = world_from_hand.col(2).cross(world_from_hand.col(0));
  HumanMotion motion;
  motion.time = {0, 1};
  motion.tip = {2, kFingerCount, unknown_point()};
  motion.tip_orientation = {2, kFingerCount, unknown_rotation()};
  motion.finger_joint = {2, kFingerCount, unknown_point()};
  for (const auto& [upper_arm, forearm] : {ArmPosture{0, kRestForearmRise_rad},
                                           ArmPosture{kReachUpperArm_rad, kReachForearmRise_rad}}) {
    motion.shoulder.push_back(Vec3::Zero());
    motion.elbow.push_back(kRestUpperArm_m * Vec3(0, std::sin(upper_arm), -std::cos(upper_arm)));
    motion.wrist.push_back(motion.elbow.back() +
                           kRestForearm_m * Vec3(0, std::cos(forearm), std::sin(forearm)));
    motion.wrist_orientation.emplace_back(world_from_hand);
    const auto in_hand = [&](const Vec3& of_right_hand) -> Vec3 {
      const Vec3 point(of_right_hand.x(), outwards * of_right_hand.y(), of_right_hand.z());
      return motion.wrist.back() + world_from_hand * point;
    };
    const std::size_t row = motion.wrist.size() - 1;
    motion.tip(row, kThumb) = in_hand(kRestThumbTip_m);
    motion.tip(row, kIndex) = in_hand(kRestIndexTip_m);
  }
  return motion;
}

/// Returns a posture at rest and the one in the reach to which it leads.
CandidatePath with_reach(const MappingProblem& problem, const solve::Minimum& at_rest,
                         const MapOptions& options, MappingScratch& scratch) {
  CandidatePath path{JointRows(2, at_rest.x.size()), at_rest.value};
  path.q.row(0) = at_rest.x.transpose();
  path.q.row(1) =
      posture_from_rest(problem_at_frames(problem, {1}), at_rest.x, options, scratch).transpose();
  return path;
}

/// Returns a posture at rest and in the reach on the sides and with the turns that are nearest to
/// the reference. A flip that is only about a symmetry is a start to descend from; it must cost no
/// more than the share.
CandidatePath nearest_to_home(const MappingProblem& problem, const solve::Minimum& at_rest,
                              const MapOptions& options, MappingScratch& scratch) {
  CandidatePath path = with_reach(problem, at_rest, options, scratch);
  path.q = preferred_equivalent(find_posture_symmetries(problem), path.q);
  const PostureSymmetries of_palm = find_palm_symmetries(problem);
  const JointRows flipped = preferred_equivalent(of_palm, path.q);
  if (flipped == path.q) return path;
  const solve::Minimum found =
      solve_frame(problem, 0, flipped.row(0).transpose(), options.frame_solver, scratch);
  if (found.value > (1 + options.branch_share) * at_rest.value) return path;
  CandidatePath other = with_reach(problem, found, options, scratch);
  other.q = turned_towards_reference(of_palm, std::move(other.q));
  return other;
}

/// Returns true if elbow, wrist and palm are at the same places in two postures [1, n].
bool places_links_alike(const robot::Robot& robot, const JointRows& one, const JointRows& other) {
  std::vector<Pose> of_one, of_other;
  robot::forward_kinematics(robot, one.row(0).transpose(), of_one);
  robot::forward_kinematics(robot, other.row(0).transpose(), of_other);
  const auto near = [&](int frame) {
    return (of_one[frame].translation() - of_other[frame].translation()).norm() < kSamePlace_m;
  };
  const Quat one_palm(of_one[robot.palm_frame].linear()),
      other_palm(of_other[robot.palm_frame].linear());
  return near(robot.palm_frame) && std::ranges::all_of(robot.arm_centres, near) &&
         angle_between(one_palm, other_palm) < kSameMinimum_rad;
}

}  // namespace

Reference find_reference(const robot::Robot& robot, const MapOptions& options,
                         const PlacementOptions& placement, const Tolerances& tolerances,
                         const JointVector& home) {
  if (options.branch == BranchRule::best || options.mode == MapMode::joint_to_joint) return {};
  if (is_hand_only(robot)) return {home, {home}, {}};
  const HumanMotion motion = rest_and_reach(robot.side);
  const Pose base_from_world = place_robot(robot, motion.shoulder.front(), placement).inverse();
  Movement movement;
  movement.end_s = motion.time.back();
  const Goals goals = make_goals(robot, motion, movement, base_from_world);
  const Scene empty_scene;
  const collision::CollisionWorld world =
      collision::make_world(robot, empty_scene, movement, tolerances);
  MappingProblem problem = make_mapping_problem(robot, goals, world, options);
  Reference& reference = problem.reference;
  reference.posture =
      options.branch == BranchRule::nearest_posture ? branch_posture(options, robot) : home;
  reference.rest = problem.goals.front();
  reference.common_base_offset = goals.common_base_offset;
  MappingScratch scratch;
  const std::vector<solve::Minimum> minima =
      search_frame(problem, 0, kReferenceStarts, kReferenceMinima,
                   thorough_stages(options.frame_solver), kReferenceSeed, scratch);
  std::vector<CandidatePath> postures;
  for (const solve::Minimum& minimum : minima) {
    CandidatePath posture = nearest_to_home(problem, minimum, options, scratch);
    const bool known = std::ranges::any_of(postures, [&](const CandidatePath& other) {
      return places_links_alike(robot, other.q, posture.q);
    });
    if (!known) postures.push_back(std::move(posture));
  }
  const std::size_t first = choose_branch(robot, postures, reference.posture, options.branch_share);
  std::swap(postures.front(), postures[first]);
  for (const CandidatePath& posture : postures)
    reference.starts.push_back(posture.q.row(0).transpose());
  if (options.branch != BranchRule::nearest_posture) reference.posture = reference.starts.front();
  return reference;
}

}  // namespace morphe::map
