#include "stages/export/export_index.hpp"

#include <nlohmann/json.hpp>

#include "core/store/flags_json.hpp"

namespace morphe::exports {
namespace {

using Json = nlohmann::ordered_json;

Json limits_of(const JointVector& limits, const JointGroup& group) {
  Json list = Json::array();
  for (const int joint : group.joints) list.push_back(limits[joint]);
  return list;
}

Json group_json(const JointGroup& group, const RobotModel& robot) {
  return {{"joints", group.names},
          {"units", group.units},
          {"lower", limits_of(robot.lower, group)},
          {"upper", limits_of(robot.upper, group)},
          {"velocity", limits_of(robot.velocity, group)},
          {"acceleration", limits_of(robot.acceleration, group)},
          {"jerk", limits_of(robot.jerk, group)}};
}

Json motion_json(const IndexedMotion& motion, const ExportIndex& index) {
  Json files = Json::object();
  for (int g = 0; g < std::ssize(motion.files); ++g) files[index.groups[g].name] = motion.files[g];
  Json json = {{"motion", motion.name},
               {"duration_s", motion.duration_s},
               {"points", motion.points},
               {"files", files}};
  json["phases"] = Json::array();
  for (const IndexedPhase& phase : motion.phases)
    json["phases"].push_back({{"phase", name_of(phase.kind)},
                              {"begin_s", phase.begin_s},
                              {"end_s", phase.end_s},
                              {"first_point", phase.first_point},
                              {"last_point", phase.last_point}});
  if (index.has_limits) {
    const auto& [quintic, cubic] = motion.limits;
    json["limit_ratio"] = {{"velocity", quintic.velocity.ratio},
                           {"acceleration", quintic.acceleration.ratio},
                           {"jerk", quintic.jerk.ratio}};
    json["cubic_limit_ratio"] = {{"velocity", cubic.velocity.ratio},
                                 {"acceleration", cubic.acceleration.ratio}};
  }
  return json;
}

Json assumptions_json(const std::vector<Assumption>& assumptions) {
  Json list = Json::array();
  for (const Assumption& each : assumptions)
    list.push_back(
        {{"kind", name_of(each.kind)}, {"subject", each.subject}, {"value", each.value}});
  return list;
}

}  // namespace

std::string index_json(const ExportIndex& index, const PlanFileHeader& header,
                       const RobotModel& robot) {
  Json json = {{"format", index.format},
               {"verified", index.not_verified.empty()},
               {"software", header.software},
               {"config_sha256", header.config_sha256},
               {"dataset_sha256", header.dataset_sha256},
               {"robot", robot.name},
               {"rate_hz", index.rate_hz},
               {"resampled", index.motion.rate_hz > 0},
               {"points_per_sample", index.motion.parts},
               {"delay_s", index.motion.delay_s},
               {"approach", name_of(index.motion.approach)}};
  if (index.motion.uniform) json["purpose"] = "for learning, not for execution";
  if (!index.where.empty()) json["where"] = index.where;
  if (!index.not_verified.empty()) json["not_verified"] = index.not_verified;
  json["assumptions"] = assumptions_json(header.assumptions);
  json["groups"] = Json::object();
  for (const JointGroup& group : index.groups)
    json["groups"][group.name] = group_json(group, robot);
  json["plans"] = Json::array();
  for (const IndexedPlan& plan : index.plans) {
    Json motions = Json::array();
    for (const IndexedMotion& motion : plan.motions) motions.push_back(motion_json(motion, index));
    Json entry = {
        {"plan", plan.plan}, {"status", name_of(plan.status)},         {"subject", plan.subject},
        {"task", plan.task}, {"flags", store::flags_json(plan.flags)}, {"motions", motions}};
    entry["assumptions"] = assumptions_json(plan.assumptions);
    if (!plan.side.empty()) entry["split"] = plan.side;
    if (!plan.grasp_files.empty()) entry["grasp"] = plan.grasp_files;
    json["plans"].push_back(entry);
  }
  json["skipped"] = Json::array();
  for (const auto& [plan, reason] : index.skipped)
    json["skipped"].push_back({{"plan", plan}, {"reason", reason}});
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace morphe::exports
