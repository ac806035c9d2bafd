#include "pipeline/planning/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/assumption_text.hpp"
#include "pipeline/planning/pipeline_config.hpp"

namespace morphe::planning {
namespace {

using Kind = AssumptionKind;

/// The subjects that no step of the pipeline looks at, whatever the config is.
const std::vector<Assumption>& not_looked_at() {
  static const std::vector<Assumption> all{
      {Kind::not_looked_at, "torque", "joint torques of the arm, by gravity and by its motion"},
      {Kind::not_looked_at, "payload", "mass of hand and target, for the arm"},
      {Kind::not_looked_at, "tracking",
       "how closely the controller follows the trajectory, and what it does between its points"},
      {Kind::not_looked_at, "calibration",
       "errors of the real robot's joints, of its base and of the sensors' placement"},
      {Kind::not_looked_at, "surroundings", "objects that neither recording nor config contains"}};
  return all;
}

void add_grasp(const PipelineConfig& config, std::vector<Assumption>& all) {
  if (!config.grasp) {
    all.push_back({Kind::not_looked_at, "grasp",
                   "contacts and forces (the config has no section grasp): whether the hand holds "
                   "the target"});
    return;
  }
  const grasp::GraspOptions usual, &own = *config.grasp;
  const auto add = [&](const char* subject, bool is_usual, const std::string& value) {
    all.push_back({Kind::assumed, subject,
                   value + (is_usual ? ", the default of the section grasp" : ", as configured")});
  };
  add("friction",
      own.friction_coefficient == usual.friction_coefficient &&
          own.torsional_friction_m == usual.torsional_friction_m,
      fmt::format("coefficient {:g} between pad and target, torsional {:g} mm",
                  own.friction_coefficient, 1e3 * own.torsional_friction_m));
  add("mass", own.mass_kg == usual.mass_kg, fmt::format("target of {:g} kg", own.mass_kg));
  add("hand_stiffness",
      own.joint_stiffness == usual.joint_stiffness &&
          own.max_joint_torque == usual.max_joint_torque &&
          own.max_finger_force == usual.max_finger_force,
      fmt::format("{:g} N m/rad and at most {:g} N m of a finger's joint, {:g} N of a finger",
                  own.joint_stiffness, own.max_joint_torque, own.max_finger_force));
}

/// Adds the tolerances that allow more than their defaults.
void add_tolerances(const Tolerances& own, std::vector<Assumption>& all) {
  const Tolerances usual;
  const auto add = [&](const char* key, double value, double usual_value, bool is_looser) {
    if (!is_looser) return;
    all.push_back({Kind::set_by_hand, fmt::format("check.{}", key),
                   fmt::format("{:g} (default {:g})", value, usual_value)});
  };
  add("required_clearance", own.required_clearance, usual.required_clearance,
      own.required_clearance < usual.required_clearance);
  const auto add_larger = [&](const char* key, double Tolerances::*member) {
    add(key, own.*member, usual.*member, own.*member > usual.*member);
  };
  add_larger("max_penetration", &Tolerances::max_penetration);
  add_larger("tracking_tolerance_grasp", &Tolerances::tracking_tolerance_grasp);
  add_larger("tracking_tolerance", &Tolerances::tracking_tolerance);
  add_larger("max_unreachable_share", &Tolerances::max_unreachable_share);
  add_larger("max_tip_error", &Tolerances::max_tip_error);
  add_larger("max_missing_goal_share", &Tolerances::max_missing_goal_share);
  add_larger("max_goal_gap_s", &Tolerances::max_goal_gap_s);
}

/// Returns how to make a subject known.
std::string_view answer_of(Knowable subject) {
  switch (subject) {
    case Knowable::target:
      return "record the object, or give scene.target.pose and scene.target.body";
    case Knowable::table:
      return "give scene.table.height, or record an object with the name table";
    case Knowable::limits:
    case Knowable::mount:
    case Knowable::geometry:
      return "correct the robot's description and its key `assumed`";
    case Knowable::unit:
      return "give --unit at import, or `unit:` in the manifest";
    case Knowable::axes:
      return "give --axes at import, or `axes:` in the manifest";
    case Knowable::rate:
      return "give --rate at import, or `rate_hz:` in the manifest";
    case Knowable::side:
      return "give --hand at import, or `hand:` in the manifest";
    case Knowable::static_trial:
      return "give --static-trial at import, or `static_trial:` in the manifest";
  }
  return "";
}

}  // namespace

std::vector<Assumption> config_assumptions(const PipelineConfig& config,
                                           const std::vector<Assumption>& of_robot,
                                           const std::vector<std::string>& settings) {
  std::vector<Assumption> all = of_robot;
  add_grasp(config, all);
  add_tolerances(config.check.tolerances, all);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    all.push_back({Kind::set_by_hand, setting.substr(0, equals), setting.substr(equals + 1)});
  }
  all.insert(all.end(), not_looked_at().begin(), not_looked_at().end());
  std::ranges::stable_sort(all, {}, &Assumption::kind);
  return all;
}

std::string forbidden_assumption(const std::vector<Knowable>& must_be_known,
                                 const std::vector<Assumption>& assumptions) {
  for (const Assumption& each : assumptions) {
    if (each.kind != Kind::inferred && each.kind != Kind::assumed) continue;
    for (const Knowable subject : must_be_known) {
      if (each.subject != name_of(subject)) continue;
      return fmt::format(
          "the {} must be known, but is {} ({}): {}, or take it out of must_be_known", each.subject,
          name_of(each.kind), each.value, answer_of(subject));
    }
  }
  return "";
}

PlanningFailure refused_assumption(const std::vector<Knowable>& must_be_known, const Plan& begun,
                                   const Scene& scene) {
  Plan seen;
  seen.movement = begun.movement;
  seen.recording_assumptions = begun.recording_assumptions;
  seen.scene = scene;
  const std::string sentence = forbidden_assumption(must_be_known, plan_assumptions(seen));
  return sentence.empty() ? PlanningFailure{} : PlanningFailure{Reason::not_known, sentence};
}

}  // namespace morphe::planning
