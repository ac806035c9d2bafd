#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/geometry.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/named.hpp"
#include "core/motion/reason.hpp"
#include "core/motion/repair_step.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/side.hpp"
#include "core/motion/world_frames.hpp"

namespace morphe {

/// What the robot must reach, frame by frame, in the robot's base frame. NaN = no goal.
/// Shoulder, elbow and wrist positions are those of the human arm moved into the paper's common
/// base frame: shifted by `common_base_offset`, which puts the human shoulder at the movement's
/// start on the robot's. Tip goals stay where they are in the world.
struct Goals {
  std::vector<double> time;  ///< [F] demonstration time [s]
  Table<Vec3> tip_position;  ///< [F, m]
  /// [F, m] what of the link is to be there: 0 the tip, 1 the centre of its pad (robot/pads.hpp),
  /// between them the point at this share of the way. No rows: the tips, throughout.
  Table<double> pad_share;
  /// [m] 1: the goals of this tip close a finger that the person's recording does not show; or
  /// empty.
  std::vector<std::uint8_t> closed;
  Table<Quat> tip_orientation;    ///< [F, m]
  Table<std::uint8_t> reachable;  ///< [F, m] 1, 0; meaningless where there is no goal
  std::vector<Vec3> shoulder_position, elbow_position, wrist_position;  ///< [F]
  std::vector<Quat> wrist_orientation;                                  ///< [F] base_from_hand
  Table<Vec3> finger_joint_position;                                    ///< [F, 5]
  std::vector<std::string> estimated;  ///< names of what was not recorded but estimated
  Vec3 common_base_offset = Vec3::Zero();
  /// How far the robot's base was moved from where the config places it, in the world's axes [m];
  /// none: not asked for. All goals are in the frame of the base where it stands.
  std::optional<Vec3> free_offset;

  /// The human's hand is made this many times larger (section `hand`); not stored, what is asked
  /// for is in the goals.
  double hand_scale = 1;

  std::size_t frames() const { return time.size(); }
};

enum class FrameStatus : std::uint8_t { met = 0, compromise = 1, out_of_reach = 2, no_goal = 3 };
constexpr std::array<std::string_view, 4> names_of(FrameStatus) {
  return {"met", "compromise", "out_of_reach", "no_goal"};
}

struct Mapped {
  JointRows position;        ///< [F, n] [rad]
  JointRows position_error;  ///< [F, m] [m], NaN = no goal
  /// [F, m] [m] how near the tips can come together to goals that are out of reach, NaN elsewhere;
  /// not stored.
  JointRows nearest_error;
  JointRows orientation_error;      ///< [F, m] full angle [rad], NaN = no goal
  std::vector<double> objective;    ///< [F] value of the frame's objective
  JointRows humanlikeness;          ///< [F, 3] A (sum) [m^2], B [m^2], C [m^3]
  std::vector<FrameStatus> status;  ///< [F]
};

/// What is wrong with a stretch of a path: the robot meets itself, an object or the table; a joint
/// is beyond a limit or jumps; a tip is too far from its goal.
enum class Cause : std::uint8_t { jump, limit, object, self, table, tracking };
constexpr std::array<std::string_view, 6> names_of(Cause) {
  return {"jump", "limit", "object", "self", "table", "tracking"};
}
constexpr bool is_collision(Cause cause) {
  return cause == Cause::self || cause == Cause::object || cause == Cause::table;
}

/// An interval of a path that cannot be executed.
struct Finding {
  double begin_s = 0, end_s = 0;  ///< demonstration time
  Cause cause = Cause::jump;
  std::string first, second;  ///< capsule and capsule or object; joint; tip
  double depth = 0;           ///< how far beyond what is allowed [m or rad], > 0
};

enum class Origin : std::uint8_t { mapped = 0, resolved = 1, planned = 2 };
constexpr std::array<std::string_view, 3> names_of(Origin) {
  return {"mapped", "re-solved", "planned"};
}

/// Joint positions along a movement; time here is only a label.
struct JointPath {
  JointRows position;                      ///< [W, n]
  std::vector<Origin> origin;              ///< [W]
  std::vector<double> demonstration_time;  ///< [W] [s], not decreasing
};

/// Between two samples: the quintic that meets position, velocity and acceleration at both.
struct Trajectory {
  std::vector<double> time;                    ///< [T] from 0, strictly increasing [s]
  JointRows position, velocity, acceleration;  ///< [T, n]
  std::vector<double> demonstration_time;      ///< [T]
  std::vector<PhaseKind> phase;                ///< [T]
  std::vector<Origin> origin;                  ///< [T]
  std::vector<double> clearance;  ///< [T] [m], least over pairs that may not touch; NaN: none

  std::size_t samples() const { return time.size(); }
};

/// Where a contact comes from: the person touched there, or a finger without goals was closed.
enum class ContactOrigin : std::uint8_t { demonstrated, closed };
constexpr std::array<std::string_view, 2> names_of(ContactOrigin) {
  return {"demonstrated", "closed"};
}

/// A pad on the target, in the target's frame.
struct PadContact {
  std::string tip;   ///< the robot's
  std::string link;  ///< the capsule that touches
  ContactOrigin origin = ContactOrigin::demonstrated;
  Vec3 asked = unseen_point();     ///< point of the surface that the pad was to touch [m]
  Vec3 point = unseen_point();     ///< that it does: the surface's nearest to the pad
  Vec3 normal = unseen_point();    ///< of the surface there, unit, inwards
  double gap = kNotSeen;           ///< between pad and surface, < 0: penetration [m]
  double pad_angle = kNotSeen;     ///< between the middle of the pad and the normal [rad]
  double confidence = 1;           ///< that the person touched there, 0 to 1
  double force = kNotSeen;         ///< along the normal, of the squeeze [N]
  Vec3 friction = unseen_point();  ///< beside it, of the squeeze, in the target's frame [N]
};

/// What grasp quality was computed with, and what came out (docs/grasp_quality.md).
struct GraspQuality {
  double friction = kNotSeen;      ///< coefficient
  double torsion = kNotSeen;       ///< torsional friction [m]
  double mass = kNotSeen;          ///< [kg]
  Vec3 centre = unseen_point();    ///< of mass, in the target's frame [m]
  double torque_scale = kNotSeen;  ///< [m]
  /// Ferrari and Canny's, L1, signed: below zero minus the closure residual; certified bounds.
  double epsilon_lower = kNotSeen, epsilon_upper = kNotSeen;
  double needed_worst = kNotSeen;  ///< a finger, in the worst direction of gravity [N]
  double needed_down = kNotSeen;   ///< as the target stands [N]
  double given = kNotSeen;         ///< least of what the fingers can press with [N]
};

/// Of the palm's way to a grasp, that says from where it came [m].
constexpr double kApproachLength = 0.05;

/// The grasp, relative to the object, so that it can be executed on an object elsewhere.
struct Grasp {
  int sample = -1;  ///< trajectory sample (path sample if there is none), -1: no grasp
  Pose base_from_object = Pose::Identity();
  Pose object_from_palm = Pose::Identity();
  std::vector<Vec3> tips_in_object;  ///< [m] all the robot's tips
  /// Unit, in the target's frame: how the palm came there over the last kApproachLength; unseen if
  /// it never was so far away.
  Vec3 approach_direction = unseen_point();
  JointVector hand_posture;          ///< all joints at the grasp [n]
  JointVector pregrasp_posture;      ///< all joints where the hand is widest open [n]
  std::vector<PadContact> contacts;  ///< at the sample; none unless asked for
  GraspQuality quality;
  /// Beside the trajectory, never part of it: what the joints bear in the squeeze, and where a
  /// servo of the config's stiffness must be sent for it; [n], or empty.
  JointVector squeeze_torque, squeeze_posture;
};

/// What holds for the written trajectory as a controller would run it.
struct Certificate {
  double position_margin = kNotSeen;  ///< least distance to a joint limit [rad]
  double velocity_ratio = kNotSeen, acceleration_ratio = kNotSeen, jerk_ratio = kNotSeen;
  /// Proved lower bound of the motion's least, to 0.01 mm [m]; NaN: nothing that could be checked.
  double clearance = kNotSeen;
  double position_error_max = kNotSeen, position_error_mean = kNotSeen;  ///< over all goals [m]
  double position_error_grasp = kNotSeen;   ///< largest in grasp and hold [m], NaN = no such phase
  double orientation_error_max = kNotSeen;  ///< full angle [rad], NaN = no orientation goals
  double upper_arm_error_mean = kNotSeen, upper_arm_error_max = kNotSeen;  ///< direction [rad]
  double tempo = kNotSeen;  ///< duration / human duration
  double humanlikeness_mapped = kNotSeen, humanlikeness_final = kNotSeen;  ///< mean A [m^2]
  double natural_posture_error = kNotSeen;  ///< rms of joints that no goal asked for, mapped [rad]
  /// Smoothness of the goal tips' mean speed, robot's and human's (stages/certify/smoothness.hpp).
  double sparc_robot = kNotSeen, sparc_human = kNotSeen;
  double log_dimensionless_jerk_robot = kNotSeen, log_dimensionless_jerk_human = kNotSeen;
  bool repaired = false;
  std::vector<std::string> unchecked_links;  ///< the robot's: nothing of them was checked
};

/// What the plan was judged by; `verify` reads it from the file.
struct Tolerances {
  double margin = 0.001;             ///< clearance asked for [m]
  double contact_depth = 0.005;      ///< allowed penetration of the target [m]
  std::optional<double> link_depth;  ///< by links that are no pads; none: contact_depth [m]
  double tracking_grasp = 0.005;     ///< tips from their goals in grasp and hold [m]
  double tracking = 0.020;           ///< elsewhere [m]
  /// A plan of which more goals are out of reach, or a tip farther from its goal, is approximate.
  double out_of_reach_share = 0.5;  ///< of all fingertip goals, below 1
  double farthest_tip = 0.05;       ///< [m]
};

/// `executable`: runs, and reaches its goals. `approximate`: runs, and comes only as near to them
/// as it can. `infeasible`: nothing to run, there is a reason.
enum class Status : std::uint8_t { executable, approximate, infeasible };
constexpr std::array<std::string_view, 3> names_of(Status) {
  return {"executable", "approximate", "infeasible"};
}

/// A movement and all that became of it. Every movement of every demonstration ends as one.
struct Plan {
  std::string demonstration;
  std::string subject, task;
  Side hand = Side::right;
  Movement movement;
  Reason reason = Reason::unplanned;  ///< none: there is a trajectory
  /// The trajectory moves as the person did, but too many goals are out of reach, or tips too far
  /// from theirs, to say that it does what the person did (Tolerances).
  bool approximate = false;
  std::string detail;  ///< a sentence
  Tolerances tolerances;
  Goals goals;
  Scene scene;  ///< in the robot's base frame
  WorldFrames world;
  Mapped mapped;
  std::vector<Finding> findings;   ///< of the mapped path: also those that repair removed
  std::vector<RepairStep> repair;  ///< in order; empty if the mapped path had no finding
  std::vector<Finding> remaining;  ///< of `path`: what repair has left
  JointPath path;
  Grasp grasp;
  Trajectory trajectory;  ///< empty if infeasible
  Trajectory approach;    ///< from home to the first sample, empty unless asked for
  Trajectory retreat;     ///< from the last sample back home, likewise
  Certificate certificate;

  Status status() const {
    if (reason != Reason::none) return Status::infeasible;
    return approximate ? Status::approximate : Status::executable;
  }
  bool executable() const { return status() == Status::executable; }
  bool has_trajectory() const { return status() != Status::infeasible; }
};

/// What a plans.h5 says of itself as a whole.
struct PlanFileHeader {
  std::string config;  ///< effective YAML
  std::string config_sha256, dataset_sha256;
  std::string software;    ///< "morphe 0.1.0"
  std::string built_with;  ///< compiler and packages; "" in files of earlier versions
  struct Input {
    std::string path, text;  ///< relative path as the config named it
  };
  std::vector<Input> inputs;
};

}  // namespace morphe
