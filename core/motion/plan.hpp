#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/arm_branch.hpp"
#include "core/motion/assumption.hpp"
#include "core/motion/clearance_kind.hpp"
#include "core/motion/enum_names.hpp"
#include "core/motion/finding.hpp"
#include "core/motion/geometry.hpp"
#include "core/motion/human_motion.hpp"
#include "core/motion/movement.hpp"
#include "core/motion/reason.hpp"
#include "core/motion/recording_flag.hpp"
#include "core/motion/repair_step.hpp"
#include "core/motion/scene.hpp"
#include "core/motion/side.hpp"
#include "core/motion/world_frames.hpp"

namespace morphe {

/// The goals of the robot for each frame, in the robot's base frame; NaN if there is no goal.
/// Shoulder, elbow and wrist positions are those of the human arm in the paper's common base frame:
/// they are translated by `common_base_offset`, which moves the human shoulder at the movement's
/// start to the robot's shoulder. Tip goals keep their position in the world.
struct Goals {
  std::vector<double> time;    ///< [F] demonstration time [s]
  Array2D<Vec3> tip_position;  ///< [F, m]
  /// [F, m] point of the fingertip link to which the position goal applies: from 0, the tip, to 1,
  /// the centre of its pad (robot/pads.hpp), linearly. Without rows, all goals apply to the tips.
  Array2D<double> tip_to_pad_share;
  std::vector<std::uint8_t> auto_closed;  ///< [m] 1: the goals close an unrecorded finger; or empty
  Array2D<Quat> tip_orientation;          ///< [F, m]
  Array2D<std::uint8_t> reachable;        ///< [F, m] 1 or 0; meaningless without a goal
  std::vector<Vec3> shoulder_position, elbow_position, wrist_position;  ///< [F]
  std::vector<Quat> wrist_orientation;                                  ///< [F] base_from_hand
  Array2D<Vec3> finger_joint_position;                                  ///< [F, 5]
  std::vector<std::string> estimated;  ///< names of arm points that were estimated, not recorded
  Vec3 common_base_offset = Vec3::Zero();  ///< translation of the human arm into that frame [m]
  /// Displacement of the robot's base from its configured position, in the world's axes [m]; absent
  /// if the base is not optimised. All goals are given in the frame of the displaced base.
  std::optional<Vec3> base_offset;
  double hand_scale = 1;  ///< HumanMotion::hand_scale, which the goals include; not stored

  /// Returns the number of frames.
  std::size_t frames() const { return time.size(); }
};

/// The result of the mapping for the goals of one frame.
enum class FrameStatus : std::uint8_t { met = 0, compromise = 1, out_of_reach = 2, no_goal = 3 };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 4> names_of(FrameStatus) {
  return {"met", "compromise", "out_of_reach", "no_goal"};
}

/// The joint path that the mapping computes, with its errors and humanlikeness for each frame.
struct MappingResult {
  JointRows position;   ///< [F, n] [rad]
  JointRows tip_error;  ///< [F, m] [m], NaN = no goal
  /// [F, m] [m] least errors attainable together for goals out of reach, else NaN; not stored.
  JointRows least_attainable_error;
  JointRows tip_orientation_error;  ///< [F, m] full angle [rad], NaN = no goal
  std::vector<double> objective;    ///< [F] value of the frame's objective
  JointRows humanlikeness;          ///< [F, 3] A (sum) [m^2], B [m^2], C [m^3]
  std::vector<FrameStatus> status;  ///< [F]
  /// RMS distance from the natural posture [rad]; stored with the certificate.
  double natural_posture_error = kUnknown;
};

/// The step that computed a sample: mapping, re-solving by inverse kinematics, or path planning.
enum class SampleOrigin : std::uint8_t { mapped = 0, re_solved = 1, planned = 2 };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 3> names_of(SampleOrigin) {
  return {"mapped", "re_solved", "planned"};
}

/// A joint path along a movement; time is only a label of its samples.
struct JointPath {
  JointRows position;                      ///< [W, n]
  std::vector<SampleOrigin> origin;        ///< [W]
  std::vector<double> demonstration_time;  ///< [W] [s], non-decreasing
};

/// A trajectory: between two samples the quintic that meets position, velocity and acceleration.
struct Trajectory {
  std::vector<double> time;                    ///< [T] from 0, strictly increasing [s]
  JointRows position, velocity, acceleration;  ///< [T, n]
  std::vector<double> demonstration_time;      ///< [T]
  std::vector<PhaseKind> phase;                ///< [T]
  std::vector<SampleOrigin> origin;            ///< [T]
  std::vector<double> clearance;  ///< [T] [m] least of pairs that may not touch, NaN without a pair

  /// Returns the number of samples.
  std::size_t samples() const { return time.size(); }
};

/// The origin of a contact: demonstrated by the person, or made by closing a finger without goals.
enum class ContactOrigin : std::uint8_t { demonstrated, auto_closed };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 2> names_of(ContactOrigin) {
  return {"demonstrated", "auto_closed"};
}

/// The result of planning a contact. `touching`: the pad touches the target with its inner side.
/// `near`: the gap or the angle of the pad is too large, and the contact bears no force.
enum class ContactState : std::uint8_t { touching, near };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 2> names_of(ContactState) { return {"touching", "near"}; }

/// A contact of a fingertip pad with the target, in the target's frame.
struct PadContact {
  std::string tip;   ///< name of the robot's tip
  std::string link;  ///< name of the capsule in contact
  ContactOrigin origin = ContactOrigin::demonstrated;
  ContactState state = ContactState::near;
  /// Surface point that the person touched [m]; NaN for a finger that closes by itself.
  Vec3 demonstrated_point = unknown_point();
  Vec3 desired_point = unknown_point();   ///< surface point that the pad should touch [m]
  Vec3 point = unknown_point();           ///< surface point nearest to the pad [m]
  Vec3 normal = unknown_point();          ///< unit normal of the surface at `point`, inwards
  double signed_distance = kUnknown;      ///< between pad and surface, < 0: penetration [m]
  double pad_angle = kUnknown;            ///< between the pad's normal and the surface's [rad]
  double confidence = 1;                  ///< that the person touched the target there, 0 to 1
  double normal_force = kUnknown;         ///< of the squeeze [N]
  Vec3 friction_force = unknown_point();  ///< of the squeeze, tangential, in the target's frame [N]
};

/// The parameters and results of the grasp quality computation (docs/grasp_quality.md).
struct GraspQuality {
  double friction_coefficient = kUnknown;
  double torsional_friction = kUnknown;     ///< [m]
  double mass = kUnknown;                   ///< [kg]
  Vec3 centre_of_mass = unknown_point();    ///< in the target's frame [m]
  double characteristic_length = kUnknown;  ///< [m]
  /// Certified bounds of the signed Ferrari-Canny L1 quality; < 0: minus the closure residual.
  double epsilon_lower = kUnknown, epsilon_upper = kUnknown;
  /// Sufficient normal force per contact, for the worst and the actual direction of gravity [N].
  double required_force_worst = kUnknown, required_force_gravity = kUnknown;
  double available_force = kUnknown;  ///< smallest force with which a finger can press [N]
};

/// Length of the palm's path before the grasp that defines the approach direction [m].
constexpr double kApproachLength_m = 0.05;

/// The grasp relative to the object, such that it can be executed on an object at another pose.
struct Grasp {
  int sample = -1;  ///< in the trajectory, or in the path if it is empty; -1: no grasp
  Pose base_from_object = Pose::Identity(), object_from_palm = Pose::Identity();
  std::vector<Vec3> tips_in_object;  ///< [m] all tips of the robot
  /// Unit direction of the palm's approach over the last kApproachLength_m, in the target's frame;
  /// NaN if the palm was never that far away.
  Vec3 approach_direction = unknown_point();
  JointVector grasp_posture;     ///< all joints at the grasp [n]
  JointVector pregrasp_posture;  ///< all joints at the sample at which the hand is widest open [n]
  std::vector<PadContact> contacts;  ///< at `sample`; empty unless contacts are requested
  GraspQuality quality;
  /// [n] or empty: joint torques of the squeeze, and the posture that makes a servo produce them.
  JointVector grasp_torque, servo_target;
};

/// Properties that hold for the stored trajectory when a controller executes it.
struct Certificate {
  double joint_limit_margin = kUnknown;  ///< smallest distance to a joint limit [rad]
  double velocity_ratio = kUnknown, acceleration_ratio = kUnknown, jerk_ratio = kUnknown;
  double clearance = kUnknown;  ///< lower bound, to 0.01 mm [m]; NaN if there is no pair to check
  double tip_error_max = kUnknown, tip_error_mean = kUnknown;  ///< over all goals [m]
  double tip_error_grasp = kUnknown;            ///< largest in grasp and hold [m], NaN without them
  double tip_orientation_error_max = kUnknown;  ///< full angle [rad], NaN without such goals
  double upper_arm_error_mean = kUnknown, upper_arm_error_max = kUnknown;  ///< direction [rad]
  /// Likewise of the forearm, of the elbow about the line from shoulder to wrist, and of the palm's
  /// rotation [rad] (core/humanlike/arm_posture.hpp); NaN if unknown.
  double forearm_error_mean = kUnknown, forearm_error_max = kUnknown;
  double swivel_error_mean = kUnknown, swivel_error_max = kUnknown;
  double palm_error_mean = kUnknown, palm_error_max = kUnknown;
  /// Correlation of the wrist's speeds, the robot's and the person's
  /// (stages/certify/wrist_speed.hpp).
  double wrist_speed_correlation = kUnknown;
  /// Largest displacement [m] and rotation [rad] of a finger's pad in the palm's frame while the
  /// hand carries the target with contacts, since the grasp (stages/grasp/held_drift.hpp); NaN if
  /// it carries nothing or the contacts are unknown.
  double held_drift = kUnknown, held_turn = kUnknown;
  double duration_ratio = kUnknown;  ///< duration / human duration
  double humanlikeness_mapped = kUnknown, humanlikeness_final = kUnknown;  ///< mean A [m^2]
  /// Smoothness of the mean speed of the tips with goals (stages/certify/smoothness.hpp).
  double sparc_robot = kUnknown, sparc_human = kUnknown;
  double log_dimensionless_jerk_robot = kUnknown, log_dimensionless_jerk_human = kUnknown;
  std::vector<std::string> unchecked_links;  ///< links not checked for collisions
  /// One for each kind that has a pair to check, in the order of the kinds; the least of them is
  /// `clearance`. Empty in files of earlier versions.
  std::vector<KindClearance> clearance_by_kind;
};

/// The tolerances that the plan must meet; `verify` reads them from the file.
struct Tolerances {
  double required_clearance = 0.001;           ///< [m]
  double max_penetration = 0.005;              ///< into the target [m]
  std::optional<double> max_link_penetration;  ///< of links without pads; absent: as above
  double tracking_tolerance_grasp = 0.005;     ///< of tips to their goals in grasp and hold [m]
  double tracking_tolerance = 0.020;           ///< likewise in other phases [m]
  /// A plan is approximate if a larger share of its fingertip goals is out of reach, or if a tip is
  /// farther from its goal [m]. The share must be below 1.
  double max_unreachable_share = 0.5, max_tip_error = 0.05;
  /// A plan is approximate, too, if a larger share of the goals of a phase is missing, or if there
  /// is no goal of any tip for longer [s] (MissingGoals).
  double max_missing_goal_share = 0.5, max_goal_gap_s = 0.1;
};

/// `executable`: the trajectory can be executed and reaches its goals. `approximate`: it only comes
/// as close to them as possible. `infeasible`: there is no trajectory; the plan has a reason.
/// `partial`: the trajectory is that of an executable plan of the movement's first part; the plan
/// has the reason why the rest is missing.
enum class Status : std::uint8_t { executable, approximate, infeasible, partial };
/// Returns the names of the values, in their order.
constexpr std::array<std::string_view, 4> names_of(Status) {
  return {"executable", "approximate", "infeasible", "partial"};
}

/// The part of a movement that a partial plan delivers: up to the end of a phase, instead of the
/// requested end [demonstration time, s].
struct DeliveredPart {
  PhaseKind until = PhaseKind::grasp;
  double requested_end_s = kUnknown;
};

/// A movement of a demonstration and all results of planning it.
struct Plan {
  std::string demonstration, subject, task;
  std::string source, licence;  ///< of the recording, "" if it does not state them
  Side hand = Side::right;
  Movement movement;
  /// Why there is no trajectory, or none of the later part; Reason::none if nothing is missing.
  Reason reason = Reason::unplanned;
  std::optional<DeliveredPart> delivered;  ///< present if the plan is partial
  /// True if the trajectory follows the person's movement, but too many goals are out of reach, or
  /// tips too far from their goals, to count as the same task (Tolerances).
  bool approximate = false;
  std::string detail;                ///< explanation of the reason, a sentence
  std::vector<RecordingFlag> flags;  ///< of the recording, as far as they concern the movement
  std::vector<Assumption> recording_assumptions;  ///< those of the Demonstration
  Tolerances tolerances;
  Goals goals;
  Scene scene;  ///< in the robot's base frame
  WorldFrames reference_frames;
  MappingResult mapped;
  ArmBranch branch;                ///< of the trajectory, or of the mapped path without one
  std::vector<Finding> findings;   ///< of the mapped path, including those that repair removed
  std::vector<RepairStep> repair;  ///< in the order of execution; empty without a finding
  bool repaired = false;  ///< true if `path` is not the mapped one; stored with the certificate
  std::vector<Finding> remaining_findings;  ///< of `path`, which repair could not remove
  JointPath path;
  Grasp grasp;
  Trajectory trajectory;  ///< empty if infeasible
  Trajectory approach;    ///< from home to the first sample, empty unless requested
  Trajectory retreat;     ///< from the last sample back home, empty unless requested
  Certificate certificate;

  /// Returns the status that follows from `delivered`, `reason` and `approximate`.
  Status status() const {
    if (delivered) return Status::partial;
    if (reason != Reason::none) return Status::infeasible;
    return approximate ? Status::approximate : Status::executable;
  }
  /// Returns true if the trajectory covers the movement and reaches its goals within the
  /// tolerances.
  bool executable() const { return status() == Status::executable; }
  /// Returns true if there is a trajectory: executable, approximate or partial.
  bool has_trajectory() const { return status() != Status::infeasible; }
};

/// The metadata of a plans.h5 as a whole.
struct PlanFileHeader {
  std::string config;  ///< effective YAML
  std::string config_sha256, dataset_sha256;
  std::string software;    ///< "morphe 0.1.0"
  std::string built_with;  ///< compiler and packages; "" in files of earlier versions
  /// A file whose content is stored with the plans.
  struct Input {
    std::string path, text;  ///< path below /inputs; text: its bytes, also of a mesh
  };
  /// The config first, then those that it extends, the robot's files, the scene's file and meshes.
  std::vector<Input> inputs;
  /// The words that loaded the config: "config=PATH", its path below /inputs; "robots=NAME", the
  /// entry of its `robots`, if it has any; "a.b=value" of each --set, in order.
  std::vector<std::string> settings;
  std::string inputs_sha256;  ///< as read from a file; the writer computes it (store::inputs_hash)
  /// That hold for all plans: of the robot and the config, and what no step looks at.
  std::vector<Assumption> assumptions;
};

}  // namespace morphe
