#include "core/config/renamed_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace morphe::config {
namespace {

/// Old and new names of options, keys and values, in alphabetical order. If several keys had the
/// same old name, there is one row for each of them.
constexpr std::pair<std::string_view, std::string_view> kRenamedWords[] = {
    // clang-format off
    {"--directions", "--load-directions"}, {"--ensemble", "--rollouts"},
    {"--failed", "--infeasible"}, {"--force", "--thumb-force"}, {"--keep", "--fix"},
    {"--map", "--reach-map"}, {"--person", "--person-clearance"}, {"--physics", "--simulation"},
    {"--planned", "--plan"}, {"--refined", "--refine"}, {"--static", "--static-trial"},
    {"--step", "--time-step"}, {"--stiffness", "--hand-stiffness"},
    {"--torque", "--hand-torque-limit"}, {"--torsion", "--torsional-friction"},
    {"--trials", "--movements"}, {"absolute_step_rad", "step_tolerance_rad"},
    {"accuracy", "score_positions"}, {"allowed_pairs", "allowed_collision_pairs"},
    {"along", "finger_curve_share"}, {"angles", "reference_angles"},
    {"aperture", "preshape_clearance"}, {"at", "align"}, {"at", "position"}, {"back", "retreat"},
    {"band", "activation_distance"}, {"best", "reference_variant"},
    {"beyond_limits_m", "max_limit_violation_m"}, {"carried", "carried_by"},
    {"centres", "joint_centres"}, {"clear_of_target", "avoid_target"}, {"closed", "analytic"},
    {"contact_depth", "max_penetration"}, {"digitised", "digitisation_count"},
    {"draw_attempts", "pull_back_attempts"}, {"drop", "velocity_offset"},
    {"elbow_outward", "elbow_swivel"}, {"ends_inside_share", "truncated_end_share"},
    {"enforce", "enforce_position_limits"}, {"evaluations", "max_evaluations"},
    {"excess", "excess_threshold"}, {"farthest_tip", "max_tip_error"},
    {"fingertips_m", "max_fingertip_rms_m"}, {"foot", "bottom_centre"}, {"found", "finger_length"},
    {"free_offset", "base_offset"}, {"friction", "friction_coefficient"}, {"given", "fixed"},
    {"held_at", "grasp_point"}, {"hold", "fixed_joints"}, {"home_radius", "return_radius"},
    {"in_mapping", "avoid_in_mapping"}, {"iterations", "max_iterations"},
    {"joint_torque", "max_joint_torque"}, {"joints_m", "max_joint_rms_m"},
    {"jump_step", "jump_threshold"}, {"kept", "catch_up"}, {"least_grasp", "min_grasp_s"},
    {"least_peak", "min_peak_speed"}, {"least_reach", "min_reach_distance"},
    {"least_recall", "min_recall"}, {"least_s", "min_duration_s"},
    {"least_share", "min_contact_share"}, {"least_widening", "min_aperture_increase"},
    {"limit_share", "limit_scaling"}, {"link_depth", "max_link_penetration"},
    {"link_penetration", "max_link_penetration"}, {"low_percentile", "resting_height_percentile"},
    {"margin", "required_clearance"}, {"median_s", "max_median_error_s"},
    {"mount", "sensor_offset"}, {"moved", "pose_offset"}, {"movement", "movement_solver"},
    {"natural", "natural_posture"}, {"near", "pinch_distance"}, {"near", "touch_distance"},
    {"object_motion", "min_object_displacement"}, {"opening_excess", "peak_aperture_excess"},
    {"origin", "vector_origin"}, {"out_of_reach_share", "max_unreachable_share"},
    {"pad", "pad_depth"}, {"pads_meet", "can_pinch"}, {"palm", "palm_breadth"}, {"parts", "split"},
    {"peak_share", "peak_aperture_time"}, {"penetration", "max_penetration"},
    {"per_recording", "movements_per_recording"}, {"percentile_95_s", "max_p95_error_s"},
    {"placed", "pose"}, {"plain", "planner_only"},
    {"planned_smoothing", "planned_smoothing_factor"}, {"quick_small_paths", "quick_short_paths"},
    {"reach_share", "max_reach_share"}, {"reachable_m", "reach_tolerance_m"},
    {"reachable_starts", "reach_search_starts"}, {"recorded_share", "tracked_object_share"},
    {"relative_value", "relative_tolerance"}, {"resistance", "velocity_gain"},
    {"rim", "rim_margin"}, {"searches", "mapping_searches"}, {"slope", "twice_deceleration"},
    {"slow_s", "correlation_time_s"}, {"slow_share", "correlated_noise_share"},
    {"small_paths", "short_paths"}, {"smoothing", "velocity_smoothing_s"},
    {"solver", "frame_solver"}, {"squeeze_force", "max_finger_force"},
    {"squeeze_share", "min_finger_force_share"}, {"starts_inside_share", "truncated_start_share"},
    {"static", "static_trial"}, {"static_glove", "glove_static_trial"}, {"step_m", "check_step_m"},
    {"stored", "planned"}, {"stronger", "limit_factor"}, {"tempo", "duration_ratio"},
    {"terms", "custom_terms"}, {"thumb_far", "thumb_zero_distance"}, {"thumb_near", "thumb_full_distance"},
    {"tip_speed", "max_tip_speed"}, {"torque", "torque_limit"}, {"torsion", "torsional_friction"},
    {"touch_hold", "hold_after_touch_s"}, {"tracking", "tracking_tolerance"},
    {"tracking_grasp", "tracking_tolerance_grasp"}, {"tremor", "tremor_amplitude"},
    {"until_taken", "until_grasped"}, {"weak_bout_share", "weak_unit_share"},
    {"weak_share", "weak_unit_share"}, {"whole", "whole_recording"},
    {"widening_share", "opening_share"}, {"without", "ik_variant"},
    // clang-format on
};
static_assert(std::ranges::is_sorted(kRenamedWords));

}  // namespace

std::string current_name(std::string_view old_name, const std::vector<std::string>& candidates) {
  for (const auto& [old_key, new_key] : kRenamedWords)
    if (old_key == old_name && std::ranges::find(candidates, new_key) != candidates.end())
      return std::string(new_key);
  return "";
}

std::string former_name(std::string_view name, const std::vector<std::string>& words) {
  for (const auto& [old_key, new_key] : kRenamedWords)
    if (new_key == name && std::ranges::find(words, old_key) != words.end())
      return std::string(old_key);
  return "";
}

std::string renaming_hint(std::string_view old_name, const std::vector<std::string>& candidates) {
  const std::string current = current_name(old_name, candidates);
  return current.empty() ? "" : fmt::format("; it is now called '{}'", current);
}

}  // namespace morphe::config
