#include "stages/export/table/plan_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/motion/arm_estimate.hpp"
#include "core/motion/assumption_text.hpp"

namespace morphe::exports {
namespace {

using parquet::ValueType;
constexpr ValueType kText = ValueType::text, kNumber = ValueType::float64,
                    kInteger = ValueType::int64, kFlag = ValueType::boolean;

Cell number(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell text(std::string value) { return value.empty() ? Cell() : Cell(std::move(value)); }
template <class Range>
Cell count(const Range& range) {
  return static_cast<std::int64_t>(std::ranges::distance(range));
}

template <double Certificate::*figure>
Cell certified(const PlanEntry& entry) {
  return number(entry.plan.certificate.*figure);
}

template <ClearanceKind kind>
Cell clearance_of(const PlanEntry& entry) {
  for (const KindClearance& each : entry.plan.certificate.clearance_by_kind)
    if (each.kind == kind) return number(each.clearance);
  return {};
}

template <ContactState state>
Cell contacts_in(const PlanEntry& entry) {
  const std::vector<PadContact>& contacts = entry.plan.grasp.contacts;
  if (contacts.empty()) return {};
  return static_cast<std::int64_t>(std::ranges::count(contacts, state, &PadContact::state));
}

template <double GraspQuality::*figure>
Cell grasp_figure(const PlanEntry& entry) {
  const Grasp& grasp = entry.plan.grasp;
  return grasp.contacts.empty() ? Cell() : number(grasp.quality.*figure);
}

/// Returns the accepted steps of the repair, in order.
Cell repair_names(const PlanEntry& entry) {
  std::vector<std::string> names;
  for (const RepairStep& step : entry.plan.repair)
    if (step.level == 0 && step.accepted) names.push_back(step.name);
  return text(fmt::format("{}", fmt::join(names, "; ")));
}

Cell flag_names(const PlanEntry& entry) {
  std::vector<std::string_view> names;
  for (const RecordingFlag& flag : entry.plan.flags) names.push_back(name_of(flag.code));
  return text(fmt::format("{}", fmt::join(names, "; ")));
}

Cell assumption_phrases(const PlanEntry& entry) {
  std::vector<std::string> phrases;
  for (const Assumption& each : plan_assumptions(entry.plan)) phrases.push_back(phrase(each));
  return text(fmt::format("{}", fmt::join(phrases, "; ")));
}

Cell joined(const std::vector<std::string>& words) {
  return text(fmt::format("{}", fmt::join(words, ", ")));
}

template <NamedEnum E>
std::vector<std::string> words_of() {
  constexpr auto names = names_of(E{});
  return {names.begin(), names.end()};
}

// clang-format off
constexpr PlanColumn kColumns[] = {
    {"plan", kText, "", "demonstration and movement, <demonstration>/<000>",
     [](const PlanEntry& e) -> Cell { return fmt::format("{}/{:03}", e.plan.demonstration, e.plan.movement.index); }},
    {"demonstration", kText, "", "the recording", [](const PlanEntry& e) { return text(e.plan.demonstration); }},
    {"movement", kInteger, "1", "index of the movement in the demonstration",
     [](const PlanEntry& e) -> Cell { return std::int64_t{e.plan.movement.index}; }},
    {"subject", kText, "", "the person", [](const PlanEntry& e) { return text(e.plan.subject); }},
    {"task", kText, "", "as the recording states it", [](const PlanEntry& e) { return text(e.plan.task); }},
    {"hand", kText, "", "side of the recorded hand",
     [](const PlanEntry& e) { return text(std::string(name_of(e.plan.hand))); }, words_of<Side>},
    {"target", kText, "", "object that is grasped", [](const PlanEntry& e) { return text(e.plan.movement.target); }},
    {"robot", kText, "", "name of the robot", [](const PlanEntry& e) { return text(e.robot.name); }},
    {"source", kText, "", "of the recording", [](const PlanEntry& e) { return text(e.plan.source); }},
    {"licence", kText, "", "of the recording", [](const PlanEntry& e) { return text(e.plan.licence); }},
    {"split", kText, "", "train or valid, with --split",
     [](const PlanEntry& e) { return text(std::string(e.split)); }, []() -> std::vector<std::string> { return {"train", "valid"}; }},
    {"status", kText, "", "executable, approximate, partial or infeasible",
     [](const PlanEntry& e) { return text(std::string(name_of(e.plan.status()))); }, words_of<Status>},
    {"reason", kText, "", "code, \"\" unless infeasible or partial",
     [](const PlanEntry& e) -> Cell { return std::string(name_of(e.plan.reason)); },
     words_of<Reason>},
    {"detail", kText, "", "explanation of the reason, or restrictions", [](const PlanEntry& e) { return text(e.plan.detail); }},
    {"duration", kNumber, "s", "of the trajectory",
     [](const PlanEntry& e) { return e.plan.trajectory.time.empty() ? Cell() : number(e.plan.trajectory.time.back()); }},
    {"tempo", kNumber, "1", "duration divided by that of the person's movement (@duration_ratio)", certified<&Certificate::duration_ratio>},
    {"clearance", kNumber, "m", "least distance of bodies that may not touch, along the whole curve", certified<&Certificate::clearance>},
    {"clearance_self", kNumber, "m", "the same, between parts of the robot", clearance_of<ClearanceKind::self>},
    {"clearance_table", kNumber, "m", "the same, from the table", clearance_of<ClearanceKind::table>},
    {"clearance_objects", kNumber, "m", "the same, from objects that are not grasped", clearance_of<ClearanceKind::objects>},
    {"clearance_target", kNumber, "m", "the same, of the robot from the target", clearance_of<ClearanceKind::target>},
    {"required_clearance", kNumber, "m", "that the plan must keep", [](const PlanEntry& e) { return number(e.plan.tolerances.required_clearance); }},
    {"joint_limit_margin", kNumber, "rad", "smallest distance to a joint's limit (m for a sliding joint)", certified<&Certificate::joint_limit_margin>},
    {"velocity_ratio", kNumber, "1", "largest share of a joint's limit that is used", certified<&Certificate::velocity_ratio>},
    {"acceleration_ratio", kNumber, "1", "the same, of the acceleration", certified<&Certificate::acceleration_ratio>},
    {"jerk_ratio", kNumber, "1", "the same, of the jerk", certified<&Certificate::jerk_ratio>},
    {"tip_error_grasp", kNumber, "m", "largest distance of a tip from its goal in grasp and hold", certified<&Certificate::tip_error_grasp>},
    {"tip_error_mean", kNumber, "m", "mean over all goals", certified<&Certificate::tip_error_mean>},
    {"tip_error_max", kNumber, "m", "largest over all goals", certified<&Certificate::tip_error_max>},
    {"tip_orientation_error_max", kNumber, "rad", "largest angle between a tip and its goal", certified<&Certificate::tip_orientation_error_max>},
    {"humanlikeness", kNumber, "m^2", "mean of metric A over the trajectory; smaller is more alike", certified<&Certificate::humanlikeness_final>},
    {"upper_arm_error", kNumber, "rad", "mean angle between robot's and person's upper arm", certified<&Certificate::upper_arm_error_mean>},
    {"forearm_error", kNumber, "rad", "the same, of the forearm", certified<&Certificate::forearm_error_mean>},
    {"swivel_error", kNumber, "rad", "the same, of the swivel angle", certified<&Certificate::swivel_error_mean>},
    {"palm_error", kNumber, "rad", "the same, of the palm", certified<&Certificate::palm_error_mean>},
    {"arm_estimated", kFlag, "", "shoulder or elbow were not recorded", [](const PlanEntry& e) -> Cell { return is_arm_estimated(e.plan.goals); }},
    {"wrist_speed_correlation", kNumber, "1", "of robot and person", certified<&Certificate::wrist_speed_correlation>},
    {"held_drift", kNumber, "m", "largest displacement of a pad in the palm while the target is carried", certified<&Certificate::held_drift>},
    {"contacts", kInteger, "1", "pads that touch the target, if contacts were planned", contacts_in<ContactState::touching>},
    {"contacts_near", kInteger, "1", "pads that miss it", contacts_in<ContactState::near>},
    {"epsilon", kNumber, "1", "certified lower bound of the Ferrari-Canny quality; < 0: no force closure", grasp_figure<&GraspQuality::epsilon_lower>},
    {"epsilon_upper", kNumber, "1", "certified upper bound", grasp_figure<&GraspQuality::epsilon_upper>},
    {"required_force", kNumber, "N", "sufficient normal force per contact, for the worst direction of gravity", grasp_figure<&GraspQuality::required_force_worst>},
    {"available_force", kNumber, "N", "smallest force with which a finger can press", grasp_figure<&GraspQuality::available_force>},
    {"branch", kInteger, "1", "branch of the arm's inverse kinematics",
     [](const PlanEntry& e) { return e.plan.branch.number ? Cell(std::int64_t{*e.plan.branch.number}) : Cell(); }},
    {"branch_words", kText, "", "the same in words", [](const PlanEntry& e) { return joined(e.plan.branch.words); }},
    {"branch_changes", kInteger, "1", "changes of branch along the path",
     [](const PlanEntry& e) { return e.plan.branch.number ? count(e.plan.branch.changes) : Cell(); }},
    {"findings", kInteger, "1", "intervals of the mapped path that could not be executed", [](const PlanEntry& e) { return count(e.plan.findings); }},
    {"repaired", kFlag, "", "the path is not the mapped one", [](const PlanEntry& e) -> Cell { return e.plan.repaired; }},
    {"repair", kText, "", "accepted steps of the repair", repair_names},
    {"approach", kFlag, "", "there is an approach from home", [](const PlanEntry& e) -> Cell { return e.plan.approach.samples() > 0; }},
    {"retreat", kFlag, "", "there is a retreat", [](const PlanEntry& e) -> Cell { return e.plan.retreat.samples() > 0; }},
    {"flags", kText, "", "doubts about the recording", flag_names},
    {"assumptions", kText, "", "about recording and objects", assumption_phrases},
    {"unchecked_links", kText, "", "links that are not checked for contact", [](const PlanEntry& e) { return joined(e.plan.certificate.unchecked_links); }},
};
// clang-format on

}  // namespace

std::span<const PlanColumn> plan_columns() { return kColumns; }

}  // namespace morphe::exports
