#include "stages/export/grasp_files.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/store/json_layout.hpp"
#include "core/store/plan_layout.hpp"
#include "stages/export/joint_group.hpp"
#include "stages/export/table/csv_cell.hpp"

namespace morphe::exports {
namespace {

constexpr const char* kGraspNote =
    "kept apart from the trajectory: the certificate covers only the motion, not the grasp force";

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

std::string numbers(const Vec3& v) {
  return number(v.x()) + "," + number(v.y()) + "," + number(v.z());
}

std::string number_of_joint(const JointVector& values, int joint) {
  return joint < values.size() ? number(values[joint]) : std::string();
}

}  // namespace

bool has_contacts(const Plan& plan) {
  return plan.grasp.sample >= 0 && !plan.grasp.contacts.empty();
}

std::string grasp_json(const RobotModel& robot, const Plan& plan, const std::string& name,
                       double time_s) {
  const JointGroup all = joint_group(robot, "all");
  store::JsonWriter grasp;
  store::lay_out_grasp(grasp, plan.grasp);
  store::JsonWriter::Json json = {{"format", "morphe-grasp"}, {"version", 1},
                                  {"note", kGraspNote},       {"plan", name},
                                  {"robot", robot.name},      {"target", plan.movement.target},
                                  {"time_s", time_s},         {"joints", all.names},
                                  {"units", all.units}};
  json.update(grasp.json);
  return json.dump(1, ' ', false, store::JsonWriter::Json::error_handler_t::replace) + "\n";
}

std::string contacts_csv(const Plan& plan) {
  std::string text =
      "tip,link,origin,state,demonstrated_point_x_m,demonstrated_point_y_m,"
      "demonstrated_point_z_m,desired_point_x_m,desired_point_y_m,desired_point_z_m,"
      "point_x_m,point_y_m,point_z_m,normal_x,normal_y,normal_z,signed_distance_m,pad_angle_rad,"
      "confidence,normal_force_N,friction_force_x_N,friction_force_y_N,friction_force_z_N\n";
  for (const PadContact& contact : plan.grasp.contacts) {
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", csv_cell(contact.tip), csv_cell(contact.link),
        name_of(contact.origin), name_of(contact.state), numbers(contact.demonstrated_point),
        numbers(contact.desired_point), numbers(contact.point), numbers(contact.normal),
        number(contact.signed_distance), number(contact.pad_angle), number(contact.confidence),
        number(contact.normal_force), numbers(contact.friction_force));
  }
  return text;
}

std::string grasp_force_csv(const RobotModel& robot, const Plan& plan) {
  const JointGroup all = joint_group(robot, "all");
  const Grasp& grasp = plan.grasp;
  std::string text = "joint,unit,pregrasp,grasp,grasp_torque,servo_target\n";
  for (int j = 0; j < std::ssize(all.names); ++j) {
    text += csv_cell(all.names[j]) + "," + all.units[j];
    for (const JointVector* values :
         {&grasp.pregrasp_posture, &grasp.grasp_posture, &grasp.grasp_torque, &grasp.servo_target})
      text += "," + number_of_joint(*values, j);
    text += "\n";
  }
  return text;
}

}  // namespace morphe::exports
