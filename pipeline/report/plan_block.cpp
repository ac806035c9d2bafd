#include "pipeline/report/plan_block.hpp"

#include "core/motion/finding_text.hpp"
#include "core/store/json_layout.hpp"
#include "core/store/plan_layout.hpp"
#include "pipeline/report/numbers_json.hpp"
#include "stages/repair/repair_strategy.hpp"

namespace morphe::report {
namespace {

using Json = nlohmann::ordered_json;

JointRows rows_of(const std::vector<Vec3>& points) {
  JointRows rows(points.size(), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) rows.row(i) = points[i].transpose();
  return rows;
}

JointRows rows_of(const Array2D<Vec3>& points) {
  JointRows rows(points.rows, 3 * points.cols);
  for (std::size_t row = 0; row < points.rows; ++row) {
    for (std::size_t col = 0; col < points.cols; ++col)
      rows.row(row).segment<3>(3 * col) = points(row, col).transpose();
  }
  return rows;
}

Eigen::RowVector4d numbers_of(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

JointRows rows_of(const std::vector<Quat>& rotations) {
  JointRows rows(rotations.size(), 4);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) rows.row(i) = numbers_of(rotations[i]);
  return rows;
}

JointRows rows_of(const Array2D<std::uint8_t>& values) {
  JointRows rows(values.rows, values.cols);
  for (Eigen::Index i = 0; i < rows.size(); ++i) rows.data()[i] = values.values[i];
  return rows;
}

/// Returns seven columns: position, then the quaternion w x y z.
JointRows pose_rows(const std::vector<Vec3>& position, const std::vector<Quat>& orientation) {
  JointRows rows(position.size(), 7);
  rows << rows_of(position), rows_of(orientation);
  return rows;
}

std::vector<Vec3> all_without_common_offset(const Goals& goals, std::vector<Vec3> points) {
  for (Vec3& point : points) point = without_common_offset(goals, point);
  return points;
}

Array2D<Vec3> all_without_common_offset(const Goals& goals, Array2D<Vec3> points) {
  for (Vec3& point : points.values) point = without_common_offset(goals, point);
  return points;
}

Json human_json(Block& block, const Goals& goals, const std::vector<double>& speed) {
  Json json;
  json["time"] = block.column(goals.time, Resolution::kTime_s);
  json["tips"] = block.table(rows_of(goals.tip_position), Resolution::kLength_m);
  json["reachable"] = block.table(rows_of(goals.reachable), 1);
  const auto add_points = [&](const char* name, const auto& points) {
    json[name] =
        block.table(rows_of(all_without_common_offset(goals, points)), Resolution::kLength_m);
  };
  add_points("shoulder", goals.shoulder_position);
  add_points("elbow", goals.elbow_position);
  add_points("wrist", goals.wrist_position);
  json["wrist_orientation"] =
      block.table(rows_of(goals.wrist_orientation), Resolution::kQuaternion);
  add_points("fingers", goals.finger_joint_position);
  json["speed"] = block.column(speed, Resolution::kError);
  return json;
}

Json mapped_json(Block& block, const MappingResult& mapped) {
  if (mapped.position.rows() == 0) return nullptr;
  return {
      {"position", block.table(mapped.position, Resolution::kAngle_rad)},
      {"tip_error", block.table(mapped.tip_error, Resolution::kError)},
      {"tip_orientation_error", block.table(mapped.tip_orientation_error, Resolution::kAngle_rad)},
      {"humanlikeness", block.table(mapped.humanlikeness, Resolution::kError)},
      {"status", block.integer_column(mapped.status)}};
}

Json nearest_json(Block& block, const RobotModel& robot, const DisplayMotion& motion) {
  std::vector<int> first, second;
  std::vector<double> distance, required;
  JointRows points(motion.nearest.size(), 6);
  for (int k = 0; k < std::ssize(motion.nearest); ++k) {
    const collision::PairSeparation& pair = motion.nearest[k];
    const bool none = pair.first < 0;
    first.push_back(none ? -1 : body_index(robot, pair.first_is_object, pair.first));
    second.push_back(none ? -1 : body_index(robot, pair.other_is_object, pair.other));
    distance.push_back(none ? kUnknown : pair.separation.distance);
    required.push_back(none ? kUnknown : pair.required_distance_m);
    auto row = points.row(k);
    if (none)
      row.setConstant(kUnknown);
    else
      row << pair.separation.on_first.transpose(), pair.separation.on_second.transpose();
  }
  return {{"first", block.integer_column(first)},
          {"second", block.integer_column(second)},
          {"distance", block.column(distance, Resolution::kError)},
          {"required", block.column(required, Resolution::kError)},
          {"points", block.table(points, Resolution::kLength_m)}};
}

JointRows target_rows(const DisplayMotion& motion) {
  JointRows rows(motion.target_pose.size(), 7);
  for (int k = 0; k < std::ssize(motion.target_pose); ++k) {
    auto row = rows.row(k);
    const Pose& pose = motion.target_pose[k];
    if (motion.target_moved[k] == 0)
      row.setConstant(kUnknown);
    else
      row << pose.translation().transpose(), numbers_of(Quat(pose.linear()));
  }
  return rows;
}

JointRows touching_rows(const DisplayMotion& motion) {
  JointRows rows(motion.touching_pairs.size(), 3);
  for (int k = 0; k < std::ssize(motion.touching_pairs); ++k) {
    const auto& [row, first, second] = motion.touching_pairs[k];
    rows.row(k) << row, first, second;
  }
  return rows;
}

Json motion_json(Block& block, const RobotModel& robot, const DisplayMotion& motion) {
  Json json;
  json["name"] = motion.name;
  json["time"] = block.column(motion.time, Resolution::kTime_s);
  json["demonstration_time"] = block.column(motion.demonstration_time, Resolution::kTime_s);
  json["position"] = block.table(motion.position, Resolution::kAngle_rad);
  if (motion.velocity.rows() > 0) {
    json["velocity"] = block.table(motion.velocity, Resolution::kLimitRatio);
    json["acceleration"] = block.table(motion.acceleration, Resolution::kLimitRatio);
    json["jerk"] = block.table(motion.jerk, Resolution::kLimitRatio);
  }
  json["phase"] = block.integer_column(motion.phase);
  json["origin"] = block.integer_column(motion.origin);
  json["sample"] = block.integer_column(motion.sample);
  if (!motion.clearance.empty())
    json["clearance"] = block.column(motion.clearance, Resolution::kError);
  json["nearest"] = nearest_json(block, robot, motion);
  json["touching"] = block.table(touching_rows(motion), 1);
  json["object_pose"] = block.table(target_rows(motion), Resolution::kLength_m);
  if (motion.tip_error.rows() > 0) {
    json["tip_error"] = block.table(motion.tip_error, Resolution::kError);
    json["tip_orientation_error"] =
        block.table(motion.tip_orientation_error, Resolution::kAngle_rad);
    json["arm_error"] = block.table(motion.arm_error, Resolution::kAngle_rad);
    json["humanlikeness"] = block.column(motion.humanlikeness, Resolution::kError);
  }
  if (!motion.mean_tip_speed.empty())
    json["speed"] = block.column(motion.mean_tip_speed, Resolution::kError);
  return json;
}

Json objects_json(Block& block, const Scene& scene, const std::vector<std::string>& blocks) {
  Json objects = Json::array();
  for (int i = 0; i < std::ssize(scene.objects); ++i) {
    const SceneObject& object = scene.objects[i];
    Json json;
    json["name"] = object.name;
    json["shape"] = name_of(object.shape);
    json["size"] = object.size;
    json["block"] = blocks[i].empty() ? Json() : Json(blocks[i]);
    json["attached_frame"] = object.attached_frame;
    json["attach_s"] = number_json(object.attach_s);
    json["release_s"] = number_json(object.release_s);
    json["time"] = block.column(object.time, Resolution::kTime_s);
    json["pose"] =
        block.table(pose_rows(object.position, object.orientation), Resolution::kLength_m);
    objects.push_back(json);
  }
  return objects;
}

Json grasp_time_json(const Plan& plan) {
  const int i = plan.grasp.sample;
  if (i < std::ssize(plan.trajectory.time))
    return {{"time_s", plan.trajectory.time[i]},
            {"demonstration_s", plan.trajectory.demonstration_time[i]}};
  if (i >= std::ssize(plan.path.demonstration_time)) return nullptr;
  const double time_s = plan.path.demonstration_time[i];
  return {{"time_s", time_s - plan.path.demonstration_time.front()}, {"demonstration_s", time_s}};
}

Json grasp_json(const Plan& plan) {
  if (plan.grasp.sample < 0) return nullptr;
  Json json = grasp_time_json(plan);
  if (json.is_null() || plan.grasp.contacts.empty()) return json;
  store::JsonWriter stored;
  store::lay_out_grasp(stored, plan.grasp);
  for (const char* part : {"approach_direction", "contacts", "quality", "grasp_force"}) {
    if (stored.json.contains(part)) json[part] = stored.json[part];
  }
  return json;
}

Json phases_json(const std::vector<Phase>& phases) {
  Json out = Json::array();
  for (const Phase& phase : phases) {
    out.push_back({{"name", name_of(phase.kind)},
                   {"begin_s", phase.begin_s},
                   {"end_s", phase.end_s},
                   {"confidence", phase.confidence}});
  }
  return out;
}

Json findings_json(const std::vector<Finding>& findings) {
  Json out = Json::array();
  for (const Finding& finding : findings) {
    out.push_back({{"begin_s", finding.begin_s},
                   {"end_s", finding.end_s},
                   {"cause", name_of(finding.cause)},
                   {"subject", finding.subject},
                   {"other", finding.other_body},
                   {"sentence", sentence(finding)}});
  }
  return out;
}

}  // namespace

Block plan_block(const robot::Robot& robot, const Plan& plan, const PlanView& view,
                 const std::vector<std::string>& object_blocks) {
  Block block;
  Json& json = block.json;
  json["world_from_base"] = pose_json(view.world_from_base);
  json["upright"] = view.upright;
  json["common_base_offset"] = point_json(plan.goals.common_base_offset);
  json["base_offset"] = plan.goals.base_offset ? point_json(*plan.goals.base_offset) : Json();
  json["phases"] = phases_json(plan.movement.phases);
  json["findings"] = findings_json(plan.findings);
  json["grasp"] = grasp_json(plan);
  json["worst"] = view.worst ? Json{{"demonstration_s", view.worst->demonstration_s},
                                    {"sentence", view.worst->sentence}}
                             : Json();
  json["advice"] = view.advice;
  json["objects"] = objects_json(block, plan.scene, object_blocks);
  json["human"] = human_json(block, plan.goals, view.human_speed);
  json["mapped"] = mapped_json(block, plan.mapped);
  json["motions"] = Json::array();
  for (const DisplayMotion& motion : view.motions)
    json["motions"].push_back(motion_json(block, robot, motion));
  return block;
}

Block mesh_block(const std::vector<Vec3>& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  Block block;
  JointRows corners(triangles.size(), 3);
  for (int i = 0; i < std::ssize(triangles); ++i)
    corners.row(i) = triangles[i].cast<double>().transpose();
  block.json["vertices"] = block.table(rows_of(vertices), Resolution::kLength_m);
  block.json["triangles"] = block.table(corners, 1);
  return block;
}

}  // namespace morphe::report
