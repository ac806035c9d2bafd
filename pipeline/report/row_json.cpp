#include "pipeline/report/row_json.hpp"

#include <algorithm>

#include "core/motion/assumption_text.hpp"
#include "core/motion/flag_text.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/store/json_layout.hpp"
#include "core/store/plan_layout.hpp"
#include "pipeline/report/numbers_json.hpp"

namespace morphe::report {
namespace {

using Json = nlohmann::ordered_json;

Json joints_json(const RobotModel& robot) {
  Json out = Json::array();
  for (int j = 0; j < std::ssize(robot.joint_names); ++j) {
    const auto frame = std::ranges::find(robot.frames, j, &RobotModel::Frame::joint);
    out.push_back({{"name", robot.joint_names[j]},
                   {"lower", robot.lower[j]},
                   {"upper", robot.upper[j]},
                   {"velocity", robot.velocity[j]},
                   {"acceleration", robot.acceleration[j]},
                   {"jerk", robot.jerk[j]},
                   {"prismatic", frame != robot.frames.end() && frame->prismatic}});
  }
  return out;
}

}  // namespace

Json assumption_json(const Assumption& assumption) {
  return {{"kind", name_of(assumption.kind)},
          {"subject", assumption.subject},
          {"text", phrase(assumption)}};
}

Json row_json(const RobotModel& robot, const Plan& plan, const std::string& path) {
  const GoalCount goals = count_goals(plan.goals);
  store::JsonWriter certificate;
  if (plan.has_trajectory()) store::lay_out_certificate(certificate, plan);
  const bool timed = plan.trajectory.samples() > 0;
  Json row;
  row["plan"] = path;
  row["status"] = name_of(plan.status());
  row["reason"] = name_of(plan.reason);
  row["detail"] = plan.detail;
  row["subject"] = plan.subject;
  row["task"] = plan.task;
  row["hand"] = name_of(plan.hand);
  row["target"] = plan.movement.target;
  row["begin_s"] = number_json(plan.movement.begin_s);
  row["end_s"] = number_json(plan.movement.end_s);
  row["duration_s"] = timed ? Json(plan.trajectory.time.back()) : Json();
  row["findings"] = plan.findings.size();
  row["goals"] = goals.all;
  row["out_of_reach"] = goals.out_of_reach;
  row["certificate"] = certificate.json;
  row["tolerances"] = {{"required_clearance", plan.tolerances.required_clearance},
                       {"max_penetration", plan.tolerances.max_penetration},
                       {"tracking_tolerance_grasp", plan.tolerances.tracking_tolerance_grasp},
                       {"tracking_tolerance", plan.tolerances.tracking_tolerance}};
  if (plan.tolerances.max_link_penetration)
    row["tolerances"]["max_link_penetration"] = *plan.tolerances.max_link_penetration;
  store::JsonWriter branch;
  store::lay_out_branch(branch, plan.branch);
  row.update(branch.json);
  row["estimated"] = plan.goals.estimated;
  row["unchecked_links"] = robot.unchecked_links;
  row["flags"] = Json::array();
  for (const RecordingFlag& flag : plan.flags) row["flags"].push_back(sentence(flag));
  row["assumptions"] = Json::array();
  for (const Assumption& each : plan_assumptions(plan))
    row["assumptions"].push_back(assumption_json(each));
  row["mirrored"] = plan.hand != robot.side;
  return row;
}

Json robot_json(const RobotModel& robot) {
  Json out;
  out["name"] = robot.name;
  out["side"] = name_of(robot.side);
  out["shoulder_frame"] = robot.shoulder_frame;
  out["palm_frame"] = robot.palm_frame;
  out["unchecked_links"] = robot.unchecked_links;
  out["joints"] = joints_json(robot);
  for (const char* list : {"frames", "tips", "capsules", "joint_centres"})
    out[list] = Json::array();
  for (const RobotModel::Frame& frame : robot.frames) {
    out["frames"].push_back({{"name", frame.name},
                             {"parent", frame.parent},
                             {"transform", pose_json(frame.transform)},
                             {"axis", point_json(frame.axis)},
                             {"joint", frame.joint},
                             {"ratio", frame.ratio},
                             {"offset", frame.offset},
                             {"prismatic", frame.prismatic}});
  }
  for (const RobotModel::Tip& tip : robot.tips) {
    out["tips"].push_back({{"name", tip.name},
                           {"frame", tip.frame},
                           {"transform", pose_json(tip.transform)},
                           {"finger", tip.finger},
                           {"finger_curve_share", number_json(tip.finger_curve_share)}});
  }
  for (const RobotModel::Capsule& capsule : robot.capsules) {
    out["capsules"].push_back({{"name", capsule.name},
                               {"frame", capsule.frame},
                               {"from", point_json(capsule.from)},
                               {"to", point_json(capsule.to)},
                               {"radius", capsule.radius},
                               {"may_touch_target", capsule.may_touch_target}});
  }
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    out["joint_centres"].push_back({{"frame", centre.frame}, {"chain", centre.chain}});
  return out;
}

}  // namespace morphe::report
