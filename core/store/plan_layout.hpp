#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/store/assumption_layout.hpp"
#include "core/store/flag_layout.hpp"
#include "core/store/layout.hpp"
#include "core/store/scene_layout.hpp"

namespace morphe::store {

/// Lays out the goals.
template <class Io, class T>
void lay_out_goals(Io& io, T& goals) {
  io.attribute("common_base_offset", goals.common_base_offset);
  io.optional_attribute("base_offset", goals.base_offset);
  io.dataset("time", goals.time, {"s", "", ""});
  io.dataset("tip_position", goals.tip_position, {"m", "base", ""});
  io.dataset_if(goals.tip_to_pad_share.rows > 0, "tip_to_pad_share", goals.tip_to_pad_share,
                {"1", "", ""});
  io.dataset_if(!goals.auto_closed.empty(), "auto_closed", goals.auto_closed,
                {"1", "", "0=no,1=yes"});
  io.dataset("tip_orientation", goals.tip_orientation, {"1", "base", ""});
  io.dataset("reachable", goals.reachable, {"1", "", "0=no,1=yes"});
  io.dataset("shoulder_position", goals.shoulder_position, {"m", "base", ""});
  io.dataset("elbow_position", goals.elbow_position, {"m", "base", ""});
  io.dataset("wrist_position", goals.wrist_position, {"m", "base", ""});
  io.dataset("wrist_orientation", goals.wrist_orientation, {"1", "base", ""});
  io.dataset("finger_joint_position", goals.finger_joint_position, {"m", "base", ""});
  io.names("estimated", goals.estimated);
}

/// Lays out the reference frames.
template <class Io, class T>
void lay_out_reference_frames(Io& io, T& frames) {
  io.dataset("recording", frames.base_from_world, {"m", "base", ""});
  io.dataset("table", frames.base_from_table, {"m", "base", ""});
  io.dataset("target", frames.base_from_target, {"m", "base", ""});
  io.dataset("shoulder", frames.shoulder, {"m", "base", ""});
}

/// Lays out the mapped path.
template <class Io, class T>
void lay_out_mapped(Io& io, T& mapped) {
  io.dataset("position", mapped.position, joint_attributes());
  io.dataset("tip_error", mapped.tip_error, {"m", "", ""});
  io.dataset("tip_orientation_error", mapped.tip_orientation_error, {"rad", "", ""});
  io.dataset("objective", mapped.objective, {"1", "", ""});
  io.dataset("humanlikeness", mapped.humanlikeness, {"m^2,m^2,m^3", "", ""});
  io.dataset("status", mapped.status, {"1", "", meaning<FrameStatus>()});
}

/// Lays out the branch of the arm, which files of earlier versions do not contain.
template <class Io, class T>
void lay_out_branch(Io& io, T& branch) {
  io.optional_attribute("branch", branch.number);
  io.optional_names("branch_words", branch.words);
  io.optional_names("branch_changes", branch.changes);
}

/// Lays out findings.
template <class Io, class T>
void lay_out_findings(Io& io, T& findings) {
  io.column("begin_s", findings, &Finding::begin_s, {"s", "", ""});
  io.column("end_s", findings, &Finding::end_s, {"s", "", ""});
  io.column("cause", findings, &Finding::cause, {});
  io.column("subject", findings, &Finding::subject, {});
  io.column("other_body", findings, &Finding::other_body, {});
  io.column("excess", findings, &Finding::excess, {"m or rad", "", ""});
  io.column("unit", findings, &Finding::unit, {});
  io.column("limit", findings, &Finding::limit, {"m or rad", "", ""});
}

/// Lays out the repair steps.
template <class Io, class T>
void lay_out_repair(Io& io, T& steps) {
  io.column("level", steps, &RepairStep::level, {"1", "", "0=strategy,1=attempt"});
  io.column("name", steps, &RepairStep::name, {});
  io.column("begin_s", steps, &RepairStep::begin_s, {"s", "", ""});
  io.column("end_s", steps, &RepairStep::end_s, {"s", "", ""});
  io.column("max_joint_change", steps, &RepairStep::max_joint_change, joint_attributes());
  io.column("finding_count", steps, &RepairStep::finding_count, {"1", "", ""});
  io.column("collision_depth_sum", steps, &RepairStep::collision_depth_sum, {"m", "", ""});
  io.column("other_depth_sum", steps, &RepairStep::other_depth_sum, {"m", "", ""});
  io.column("worst_finding", steps, &RepairStep::worst_finding, {});
  io.column("accepted", steps, &RepairStep::accepted, {"1", "", "0=no,1=yes"});
  io.column("stop_reason", steps, &RepairStep::stop_reason, {});
}

/// Lays out the contacts of a grasp.
template <class Io, class T>
void lay_out_contacts(Io& io, T& contacts) {
  io.column("tip", contacts, &PadContact::tip, {});
  io.column("link", contacts, &PadContact::link, {});
  io.column("origin", contacts, &PadContact::origin, {});
  io.column("state", contacts, &PadContact::state, {});
  io.column("demonstrated_point", contacts, &PadContact::demonstrated_point, {"m", "object", ""});
  io.column("desired_point", contacts, &PadContact::desired_point, {"m", "object", ""});
  io.column("point", contacts, &PadContact::point, {"m", "object", ""});
  io.column("normal", contacts, &PadContact::normal, {"1", "object", ""});
  io.column("signed_distance", contacts, &PadContact::signed_distance, {"m", "", ""});
  io.column("pad_angle", contacts, &PadContact::pad_angle, {"rad", "", ""});
  io.column("confidence", contacts, &PadContact::confidence, {"1", "", ""});
  io.column("normal_force", contacts, &PadContact::normal_force, {"N", "", ""});
  io.column("friction_force", contacts, &PadContact::friction_force, {"N", "object", ""});
}

/// Lays out the grasp quality.
template <class Io, class T>
void lay_out_quality(Io& io, T& quality) {
  io.attribute("friction_coefficient", quality.friction_coefficient);
  io.attribute("torsional_friction", quality.torsional_friction);
  io.attribute("mass", quality.mass);
  io.attribute("centre_of_mass", quality.centre_of_mass);
  io.attribute("characteristic_length", quality.characteristic_length);
  io.attribute("epsilon_lower", quality.epsilon_lower);
  io.attribute("epsilon_upper", quality.epsilon_upper);
  io.attribute("required_force_worst", quality.required_force_worst);
  io.attribute("required_force_gravity", quality.required_force_gravity);
  io.attribute("available_force", quality.available_force);
}

/// Lays out the grasp.
template <class Io, class T>
void lay_out_grasp(Io& io, T& grasp) {
  io.attribute("sample", grasp.sample);
  io.attribute("approach_direction", grasp.approach_direction);
  io.dataset("object_pose", grasp.base_from_object, {"m", "base", ""});
  io.dataset("palm_pose_in_object", grasp.object_from_palm, {"m", "object", ""});
  io.dataset("tips_in_object", grasp.tips_in_object, {"m", "object", ""});
  io.dataset("grasp_posture", grasp.grasp_posture, joint_attributes());
  io.dataset("pregrasp_posture", grasp.pregrasp_posture, joint_attributes());
  io.group_if(!grasp.contacts.empty(), "contacts",
              [&](Io& in) { lay_out_contacts(in, grasp.contacts); });
  io.group_if(!grasp.contacts.empty(), "quality",
              [&](Io& in) { lay_out_quality(in, grasp.quality); });
  io.group_if(grasp.grasp_torque.size() > 0, "grasp_force", [&](Io& in) {
    in.dataset("torque", grasp.grasp_torque, {"N m", "", ""});
    in.dataset("servo_target", grasp.servo_target, joint_attributes());
  });
}

/// Lays out a trajectory.
template <class Io, class T>
void lay_out_trajectory(Io& io, T& trajectory) {
  io.dataset("time", trajectory.time, {"s", "", ""});
  io.dataset("position", trajectory.position, joint_attributes());
  io.dataset("velocity", trajectory.velocity, joint_attributes("/s"));
  io.dataset("acceleration", trajectory.acceleration, joint_attributes("/s^2"));
  io.dataset("demonstration_time", trajectory.demonstration_time, {"s", "", ""});
  io.dataset("phase", trajectory.phase, {"1", "", meaning<PhaseKind>()});
  io.dataset("origin", trajectory.origin, {"1", "", meaning<SampleOrigin>()});
  io.dataset("clearance", trajectory.clearance, {"m", "", ""});
}

/// Lays out the figures of posture that certificates of earlier versions lack; they stay unknown.
template <class Io, class T>
void lay_out_posture_errors(Io& io, T& certificate) {
  io.optional_attribute("forearm_error_mean", certificate.forearm_error_mean);
  io.optional_attribute("forearm_error_max", certificate.forearm_error_max);
  io.optional_attribute("swivel_error_mean", certificate.swivel_error_mean);
  io.optional_attribute("swivel_error_max", certificate.swivel_error_max);
  io.optional_attribute("palm_error_mean", certificate.palm_error_mean);
  io.optional_attribute("palm_error_max", certificate.palm_error_max);
  io.optional_attribute("wrist_speed_correlation", certificate.wrist_speed_correlation);
  io.optional_attribute("held_drift", certificate.held_drift);
  io.optional_attribute("held_turn", certificate.held_turn);
}

/// Lays out the clearances of a certificate by kind.
template <class Io, class T>
void lay_out_clearance_by_kind(Io& io, T& clearances) {
  io.column("kind", clearances, &KindClearance::kind, {});
  io.column("clearance", clearances, &KindClearance::clearance, {"m", "", ""});
  io.column("first", clearances, &KindClearance::first, {});
  io.column("second", clearances, &KindClearance::second, {});
  io.column("time", clearances, &KindClearance::time_s, {"s", "", ""});
}

/// Lays out the certificate, with `repaired` and natural_posture_error, which a plan holds
/// elsewhere.
template <class Io, class T>
void lay_out_certificate(Io& io, T& plan) {
  auto& certificate = plan.certificate;
  io.attribute("joint_limit_margin", certificate.joint_limit_margin);
  io.attribute("velocity_ratio", certificate.velocity_ratio);
  io.attribute("acceleration_ratio", certificate.acceleration_ratio);
  io.attribute("jerk_ratio", certificate.jerk_ratio);
  io.attribute("clearance", certificate.clearance);
  io.attribute("tip_error_max", certificate.tip_error_max);
  io.attribute("tip_error_mean", certificate.tip_error_mean);
  io.attribute("tip_error_grasp", certificate.tip_error_grasp);
  io.attribute("tip_orientation_error_max", certificate.tip_orientation_error_max);
  io.attribute("upper_arm_error_mean", certificate.upper_arm_error_mean);
  io.attribute("upper_arm_error_max", certificate.upper_arm_error_max);
  lay_out_posture_errors(io, certificate);
  io.attribute("natural_posture_error", plan.mapped.natural_posture_error);
  io.attribute("duration_ratio", certificate.duration_ratio);
  io.attribute("humanlikeness_mapped", certificate.humanlikeness_mapped);
  io.attribute("humanlikeness_final", certificate.humanlikeness_final);
  io.attribute("sparc_robot", certificate.sparc_robot);
  io.attribute("sparc_human", certificate.sparc_human);
  io.attribute("log_dimensionless_jerk_robot", certificate.log_dimensionless_jerk_robot);
  io.attribute("log_dimensionless_jerk_human", certificate.log_dimensionless_jerk_human);
  io.attribute("repaired", plan.repaired);
  io.optional_names("unchecked_links", certificate.unchecked_links);
  io.group_if(!certificate.clearance_by_kind.empty(), "clearance_by_kind",
              [&](Io& in) { lay_out_clearance_by_kind(in, certificate.clearance_by_kind); });
}

/// Lays out the reason, the status and the part that a partial plan delivers. The status is
/// "executable" or "approximate" exactly if there is no reason; reading rejects files in which the
/// two contradict each other.
template <class Io, class T>
void lay_out_status(Io& io, T& plan) {
  io.attribute("reason", plan.reason);
  io.attribute("detail", plan.detail);
  Status status = plan.status();
  io.attribute("status", status);
  if constexpr (Io::reading) {
    plan.approximate = status == Status::approximate;
    if (status == Status::partial) plan.delivered.emplace();
  }
  if (plan.delivered) {
    io.attribute("delivered_until", plan.delivered->until);
    io.attribute("requested_end_s", plan.delivered->requested_end_s);
  }
  if (status != plan.status() || (plan.delivered && plan.reason == Reason::none))
    io.current_group().fail(fmt::format("@status is '{}' with the @reason '{}'", name_of(status),
                                        name_of(plan.reason)));
}

/// Lays out /plans/<demonstration>/<movement> of docs/formats.md.
template <class Io, class T>
void lay_out_plan(Io& io, T& plan) {
  lay_out_status(io, plan);
  io.attribute("subject", plan.subject);
  io.attribute("task", plan.task);
  io.optional_attribute("source", plan.source);
  io.optional_attribute("licence", plan.licence);
  io.attribute("hand", plan.hand);
  io.attribute("begin_s", plan.movement.begin_s);
  io.attribute("end_s", plan.movement.end_s);
  io.attribute("target", plan.movement.target);
  io.attribute("required_clearance", plan.tolerances.required_clearance);
  io.attribute("max_penetration", plan.tolerances.max_penetration);
  io.attribute("tracking_tolerance_grasp", plan.tolerances.tracking_tolerance_grasp);
  io.attribute("tracking_tolerance", plan.tolerances.tracking_tolerance);
  if constexpr (Io::reading) {  // files of earlier versions do not contain these
    plan.tolerances.max_unreachable_share = plan.tolerances.max_tip_error = kUnknown;
    plan.tolerances.max_missing_goal_share = plan.tolerances.max_goal_gap_s = kUnknown;
  }
  io.optional_attribute("max_link_penetration", plan.tolerances.max_link_penetration);
  io.optional_attribute("max_unreachable_share", plan.tolerances.max_unreachable_share);
  io.optional_attribute("max_tip_error", plan.tolerances.max_tip_error);
  io.optional_attribute("max_missing_goal_share", plan.tolerances.max_missing_goal_share);
  io.optional_attribute("max_goal_gap_s", plan.tolerances.max_goal_gap_s);
  lay_out_flags(io, plan.flags);
  lay_out_assumptions(io, plan.recording_assumptions);
  io.group("goals", [&](Io& in) { lay_out_goals(in, plan.goals); });
  io.group("phases", [&](Io& in) {
    in.column("name", plan.movement.phases, &Phase::kind, {});
    in.column("begin_s", plan.movement.phases, &Phase::begin_s, {"s", "", ""});
    in.column("end_s", plan.movement.phases, &Phase::end_s, {"s", "", ""});
    in.column("confidence", plan.movement.phases, &Phase::confidence, {"1", "", ""});
  });
  io.group("scene", [&](Io& in) {
    in.each(plan.scene.objects,
            [](Io& inner, auto& object) { lay_out_object(inner, object, "base"); });
  });
  io.group_if(is_known(plan.reference_frames.base_from_world), "reference_frames",
              [&](Io& in) { lay_out_reference_frames(in, plan.reference_frames); });
  io.group("mapped", [&](Io& in) { lay_out_mapped(in, plan.mapped); });
  lay_out_branch(io, plan.branch);
  io.group("findings", [&](Io& in) { lay_out_findings(in, plan.findings); });
  io.group_if(!plan.repair.empty(), "repair", [&](Io& in) { lay_out_repair(in, plan.repair); });
  io.group_if(!plan.remaining_findings.empty(), "remaining_findings",
              [&](Io& in) { lay_out_findings(in, plan.remaining_findings); });
  io.group("path", [&](Io& in) {
    in.dataset("position", plan.path.position, joint_attributes());
    in.dataset("origin", plan.path.origin, {"1", "", meaning<SampleOrigin>()});
    in.dataset("demonstration_time", plan.path.demonstration_time, {"s", "", ""});
  });
  io.group_if(plan.grasp.sample >= 0, "grasp", [&](Io& in) { lay_out_grasp(in, plan.grasp); });
  io.group_if(plan.has_trajectory(), "trajectory",
              [&](Io& in) { lay_out_trajectory(in, plan.trajectory); });
  io.group_if(plan.approach.samples() > 0, "approach",
              [&](Io& in) { lay_out_trajectory(in, plan.approach); });
  io.group_if(plan.retreat.samples() > 0, "retreat",
              [&](Io& in) { lay_out_trajectory(in, plan.retreat); });
  io.group("certificate", [&](Io& in) { lay_out_certificate(in, plan); });
}

}  // namespace morphe::store
