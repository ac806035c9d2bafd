#include "core/store/consistency.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "core/files/item_name.hpp"
#include "core/files/printable.hpp"
#include "core/store/input_bounds.hpp"

namespace morphe::store {
namespace {

/// Checks the condition of each call and keeps the first error, as "path/name: message".
class ConsistencyChecker {
 public:
  explicit ConsistencyChecker(std::string path = "") : path_(std::move(path)) {}

  void require(bool holds, const char* name, const std::string& message) {
    if (!holds && first_error.empty()) first_error = fmt::format("{}{}: {}", path_, name, message);
  }
  void length(const char* name, std::size_t rows, std::size_t expected) {
    require(rows == expected, name, fmt::format("has {} rows, not {}", rows, expected));
  }
  /// Checks the size of a table; the number of columns is checked only if there are rows.
  template <class T>
  void table(const char* name, const Array2D<T>& table, std::size_t rows, std::size_t cols) {
    length(name, table.rows, rows);
    columns(name, table.rows, table.cols, cols);
    require(table.values.size() == table.rows * table.cols, name, "has not rows x columns values");
  }
  void table(const char* name, const JointRows& table, std::size_t rows, std::size_t cols) {
    length(name, table.rows(), rows);
    columns(name, rows, table.cols(), cols);
  }
  void index(const char* name, int value, int min, std::size_t count) {
    require(value >= min && std::cmp_less(value, count), name,
            fmt::format("{} is outside [{}, {})", value, min, count));
  }
  template <NamedEnum E>
  void enumeration(const char* name, const std::vector<E>& values) {
    for (const E value : values) index(name, static_cast<int>(value), 0, enum_count<E>());
  }
  /// Checks a text that is printed: it must not contain control characters or line ends.
  void text(const char* name, const std::string& text) {
    require(files::is_printable(text), name,
            "contains control characters: '" + files::make_printable(text) + "'");
  }
  void texts(const char* name, const std::vector<std::string>& texts) {
    for (const std::string& line : texts) text(name, line);
  }
  void add(const ConsistencyChecker& inner) {
    if (first_error.empty()) first_error = inner.first_error;
  }

  std::string first_error;

 private:
  void columns(const char* name, std::size_t rows, std::size_t cols, std::size_t count) {
    require(rows == 0 || cols == count, name, fmt::format("has {} columns, not {}", cols, count));
  }

  std::string path_;
};

/// Checks that the names, which are used for groups and printed, are unique.
ConsistencyChecker check_names(const std::vector<SceneObject>& objects, const std::string& path) {
  ConsistencyChecker check(path);
  std::set<std::string_view> names;
  for (const SceneObject& object : objects) {
    const std::string& name = object.name;
    const std::string printable = files::make_printable(name);
    check.require(names.insert(name).second, printable.c_str(), "the name appears twice");
    check.require(files::is_item_name(name), printable.c_str(),
                  fmt::format("is not a valid name: {}", files::kItemNameError));
  }
  return check;
}

ConsistencyChecker check_arrays(const SceneObject& object, const std::string& path) {
  ConsistencyChecker check(path + object.name + "/");
  static constexpr std::size_t kSizeCounts[] = {1, 3, 2, 2, 0};  // in the order of Shape
  const std::size_t count = kSizeCounts[static_cast<std::size_t>(object.shape)];
  check.require(object.size.size() == count, "@size",
                fmt::format("has {} numbers, not {}", object.size.size(), count));
  check.require(!object.time.empty(), "time", "has no samples");
  check.length("position", object.position.size(), object.time.size());
  check.length("orientation", object.orientation.size(), object.time.size());
  for (const Eigen::Vector3i& triangle : object.triangles)
    for (const int corner : triangle) check.index("triangles", corner, 0, object.vertices.size());
  return check;
}

ConsistencyChecker check_arrays(const BodyStream& bodies, const std::string& path, bool parents) {
  ConsistencyChecker check(path);
  check.texts("@names", bodies.names);
  if (parents) check.length("@parents", bodies.parents.size(), bodies.names.size());
  check.table("position", bodies.position, bodies.time.size(), bodies.names.size());
  check.table("orientation", bodies.orientation, bodies.time.size(), bodies.names.size());
  if (bodies.confidence.rows > 0)
    check.table("confidence", bodies.confidence, bodies.time.size(), bodies.names.size());
  return check;
}

ConsistencyChecker check_arrays(const HandStream& hand, const std::string& path) {
  ConsistencyChecker check(path);
  check.texts("@names", hand.names);
  switch (hand.kind) {
    case HandKind::glove:
      check.length("@sensors", hand.names.size(), 22);
      [[fallthrough]];
    case HandKind::joint_angles:
      check.table("angles", hand.angles, hand.time.size(), hand.names.size());
      break;
    case HandKind::keypoints:
      check.table("position", hand.position, hand.time.size(), 21);
      break;
    case HandKind::fingertips:
      check.table("position", hand.position, hand.time.size(), kFingerCount);
      break;
  }
  return check;
}

ConsistencyChecker check_arrays(const Streams& streams, const std::string& path) {
  ConsistencyChecker check(path);
  if (streams.markers) {
    const MarkerStream& markers = *streams.markers;
    check.texts("markers/@names", markers.names);
    check.table("markers/position", markers.position, markers.time.size(), markers.names.size());
  }
  if (streams.sensors) check.add(check_arrays(*streams.sensors, path + "sensors/", false));
  if (streams.skeleton) check.add(check_arrays(*streams.skeleton, path + "skeleton/", true));
  if (streams.arm_angles) {
    const AngleStream& arm = *streams.arm_angles;
    check.texts("arm_angles/@joints", arm.joints);
    check.table("arm_angles/angles", arm.angles, arm.time.size(), arm.joints.size());
  }
  if (streams.hand) check.add(check_arrays(*streams.hand, path + "hand/"));
  return check;
}

ConsistencyChecker check_arrays(const Goals& goals, std::size_t tips) {
  ConsistencyChecker check("goals/");
  const std::size_t frames = goals.frames();
  check.table("tip_position", goals.tip_position, frames, tips);
  const Array2D<double>& pad_share = goals.tip_to_pad_share;
  if (pad_share.rows > 0) check.table("tip_to_pad_share", pad_share, frames, tips);
  if (!goals.auto_closed.empty()) check.length("auto_closed", goals.auto_closed.size(), tips);
  check.table("tip_orientation", goals.tip_orientation, frames, tips);
  check.table("reachable", goals.reachable, frames, tips);
  check.length("shoulder_position", goals.shoulder_position.size(), frames);
  check.length("elbow_position", goals.elbow_position.size(), frames);
  check.length("wrist_position", goals.wrist_position.size(), frames);
  check.length("wrist_orientation", goals.wrist_orientation.size(), frames);
  check.table("finger_joint_position", goals.finger_joint_position, frames, kFingerCount);
  return check;
}

/// Checks that either no frame or every frame of the goals is mapped.
ConsistencyChecker check_arrays(const MappingResult& mapped, std::size_t frames,
                                const RobotModel& robot) {
  ConsistencyChecker check("mapped/");
  if (mapped.position.rows() == 0) frames = 0;
  check.table("position", mapped.position, frames, robot.joints());
  check.table("tip_error", mapped.tip_error, frames, robot.tips.size());
  check.table("tip_orientation_error", mapped.tip_orientation_error, frames, robot.tips.size());
  check.length("objective", mapped.objective.size(), frames);
  check.table("humanlikeness", mapped.humanlikeness, frames, 3);
  check.length("status", mapped.status.size(), frames);
  check.enumeration("status", mapped.status);
  return check;
}

ConsistencyChecker check_arrays(const Trajectory& trajectory, const std::string& path,
                                std::size_t joints) {
  ConsistencyChecker check(path);
  const std::size_t samples = trajectory.samples();
  check.table("position", trajectory.position, samples, joints);
  check.table("velocity", trajectory.velocity, samples, joints);
  check.table("acceleration", trajectory.acceleration, samples, joints);
  check.length("demonstration_time", trajectory.demonstration_time.size(), samples);
  check.length("phase", trajectory.phase.size(), samples);
  check.length("origin", trajectory.origin.size(), samples);
  check.length("clearance", trajectory.clearance.size(), samples);
  check.enumeration("phase", trajectory.phase);
  check.enumeration("origin", trajectory.origin);
  return check;
}

ConsistencyChecker check_arrays(const JointPath& path, std::size_t joints) {
  ConsistencyChecker check("path/");
  const std::size_t samples = path.demonstration_time.size();
  check.table("position", path.position, samples, joints);
  check.length("origin", path.origin.size(), samples);
  check.enumeration("origin", path.origin);
  return check;
}

ConsistencyChecker check_arrays(const Grasp& grasp, std::size_t samples, const RobotModel& robot) {
  ConsistencyChecker check("grasp/");
  check.index("@sample", grasp.sample, 0, samples);
  check.length("tips_in_object", grasp.tips_in_object.size(), robot.tips.size());
  check.length("grasp_posture", grasp.grasp_posture.size(), robot.joints());
  if (grasp.grasp_torque.size() > 0) {
    check.length("grasp_force/torque", grasp.grasp_torque.size(), robot.joints());
    check.length("grasp_force/servo_target", grasp.servo_target.size(), robot.joints());
  }
  check.length("pregrasp_posture", grasp.pregrasp_posture.size(), robot.joints());
  return check;
}

}  // namespace

std::string inconsistency(const Demonstration& demonstration) {
  ConsistencyChecker check;
  check.text("@subject", demonstration.subject);
  check.text("@task", demonstration.task);
  check.add(check_arrays(demonstration.streams, ""));
  check.add(check_arrays(demonstration.calibration, "calibration/"));
  if (const auto& offsets = demonstration.sensor_offsets) {
    const std::size_t sensors = offsets->sensors.size();
    check.length("calibration/offsets/position", offsets->joint_in_sensor.size(), sensors);
    check.length("calibration/offsets/orientation", offsets->sensor_from_segment.size(), sensors);
  }
  check.add(check_names(demonstration.objects, "objects/"));
  for (const auto& object : demonstration.objects) check.add(check_arrays(object, "objects/"));
  return check.first_error.empty() ? bounds_violation(demonstration) : check.first_error;
}

std::string inconsistency(const RobotModel& robot) {
  ConsistencyChecker check;
  const std::size_t frames = robot.frames.size();
  const auto vector = [&](const char* name, const JointVector& values) {
    check.length(name, values.size(), robot.joints());
  };
  check.text("@name", robot.name);
  check.texts("@joints", robot.joint_names);
  check.texts("unchecked_links", robot.unchecked_links);
  for (const RobotModel::Frame& frame : robot.frames) check.text("frames/name", frame.name);
  for (const RobotModel::Tip& tip : robot.tips) check.text("tips/name", tip.name);
  for (const auto& capsule : robot.capsules) check.text("capsules/name", capsule.name);
  vector("lower", robot.lower);
  vector("upper", robot.upper);
  vector("velocity", robot.velocity);
  vector("acceleration", robot.acceleration);
  vector("jerk", robot.jerk);
  for (std::size_t i = 0; i < frames; ++i) {
    check.index("frames/parent", robot.frames[i].parent, -1, i);
    check.index("frames/joint", robot.frames[i].joint, -1, robot.joints());
  }
  for (const RobotModel::CoupledLimit& limit : robot.coupled_limits) {
    check.index("coupled_limits/frame", limit.frame, 0, frames);
    if (!check.first_error.empty()) break;
    check.require(robot.frames[limit.frame].joint >= 0, "coupled_limits/frame", "is fixed");
  }
  for (const RobotModel::BrakingCurve& curve : robot.braking_curves)
    check.index("braking_curves/joint", curve.joint, 0, robot.joints());
  for (const RobotModel::Tip& tip : robot.tips) {
    check.index("tips/frame", tip.frame, 0, frames);
    check.index("tips/finger", tip.finger, -1, kFingerCount);
    check.require(!(tip.finger_curve_share < 0 || tip.finger_curve_share > 1),
                  "tips/finger_curve_share", "must be from 0 to 1");
  }
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    check.index("joint_centres/frame", centre.frame, 0, frames);
  for (const RobotModel::Capsule& capsule : robot.capsules)
    check.index("capsules/frame", capsule.frame, -1, frames);
  for (const std::array<int, 2>& pair : robot.allowed_collision_pairs)
    for (const int capsule : pair)
      check.index("allowed_collision_pairs", capsule, 0, robot.capsules.size());
  check.index("@shoulder_frame", robot.shoulder_frame, 0, frames);
  check.index("@palm_frame", robot.palm_frame, 0, frames);
  return check.first_error;
}

std::string inconsistency(const Plan& plan, const RobotModel& robot) {
  ConsistencyChecker check;
  check.text("@subject", plan.subject);
  check.text("@task", plan.task);
  check.text("@target", plan.movement.target);
  check.require(plan.has_trajectory() == (plan.trajectory.samples() > 0), "trajectory",
                plan.has_trajectory() ? "has no samples, but the plan is not infeasible"
                                      : "exists, but the plan is infeasible");
  check.add(check_arrays(plan.goals, robot.tips.size()));
  check.add(check_names(plan.scene.objects, "scene/"));
  for (const SceneObject& object : plan.scene.objects) check.add(check_arrays(object, "scene/"));
  check.add(check_arrays(plan.mapped, plan.goals.frames(), robot));
  check.add(check_arrays(plan.path, robot.joints()));
  check.add(check_arrays(plan.trajectory, "trajectory/", robot.joints()));
  check.add(check_arrays(plan.approach, "approach/", robot.joints()));
  check.add(check_arrays(plan.retreat, "retreat/", robot.joints()));
  const std::size_t samples =
      plan.has_trajectory() ? plan.trajectory.samples() : plan.path.demonstration_time.size();
  if (plan.grasp.sample >= 0) check.add(check_arrays(plan.grasp, samples, robot));
  return check.first_error;
}

}  // namespace morphe::store
