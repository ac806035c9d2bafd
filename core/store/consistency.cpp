#include "core/store/consistency.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <string_view>

#include "core/files/printable.hpp"
#include "core/store/input_bounds.hpp"

namespace morphe::store {
namespace {

/// Checks conditions and keeps the first violation.
class ConsistencyChecker {
 public:
  explicit ConsistencyChecker(std::string path = "") : path_(std::move(path)) {}

  void require(bool holds, const char* name, const std::string& message) {
    if (!holds && first_error.empty()) first_error = fmt::format("{}{}: {}", path_, name, message);
  }
  void length(const char* name, std::size_t is, std::size_t wanted) {
    require(is == wanted, name, fmt::format("has {} rows, not {}", is, wanted));
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
  void index(const char* name, int is, int least, std::size_t count) {
    require(is >= least && (is < 0 || static_cast<std::size_t>(is) < count), name,
            fmt::format("{} is outside [{}, {})", is, least, count));
  }
  /// Checks a text that is printed: it must not contain control characters or line ends.
  void text(const char* name, const std::string& text) {
    require(files::is_printable(text), name,
            "contains control characters: '" + files::make_printable(text) + "'");
  }
  void texts(const char* name, const std::vector<std::string>& texts) {
    for (const std::string& one : texts) text(name, one);
  }
  void take(const ConsistencyChecker& inner) {
    if (first_error.empty()) first_error = inner.first_error;
  }

  std::string first_error;

 private:
  void columns(const char* name, std::size_t rows, std::size_t is, std::size_t wanted) {
    require(rows == 0 || is == wanted, name, fmt::format("has {} columns, not {}", is, wanted));
  }

  std::string path_;
};

/// Checks that the names, which are used for groups and printed, are unique.
ConsistencyChecker check_names(const std::vector<SceneObject>& objects, const std::string& path) {
  ConsistencyChecker faults(path);
  std::set<std::string_view> names;
  for (const SceneObject& object : objects) {
    const std::string& name = object.name;
    const std::string shown = files::make_printable(name);
    faults.require(names.insert(name).second, shown.c_str(), "the name appears twice");
    faults.require(
        !name.empty() && name != "." && name.find('/') == std::string::npos && shown == name,
        shown.c_str(),
        "is not a valid name: must not be empty or contain '/' or control characters");
  }
  return faults;
}

ConsistencyChecker check_arrays(const SceneObject& object, const std::string& path) {
  ConsistencyChecker faults(path + object.name + "/");
  static constexpr std::size_t kSizes[] = {1, 3, 2, 2, 0};  // in the order of Shape
  const std::size_t sizes = kSizes[static_cast<std::size_t>(object.shape)];
  faults.require(object.size.size() == sizes, "@size",
                 fmt::format("has {} numbers, not {}", object.size.size(), sizes));
  faults.require(!object.time.empty(), "time", "has no samples");
  faults.length("position", object.position.size(), object.time.size());
  faults.length("orientation", object.orientation.size(), object.time.size());
  for (const Eigen::Vector3i& triangle : object.triangles)
    for (const int corner : triangle) faults.index("triangles", corner, 0, object.vertices.size());
  return faults;
}

ConsistencyChecker check_arrays(const BodyStream& bodies, const std::string& path, bool parents) {
  ConsistencyChecker faults(path);
  faults.texts("@names", bodies.names);
  if (parents) faults.length("@parents", bodies.parents.size(), bodies.names.size());
  faults.table("position", bodies.position, bodies.time.size(), bodies.names.size());
  faults.table("orientation", bodies.orientation, bodies.time.size(), bodies.names.size());
  if (bodies.confidence.rows > 0) {
    faults.table("confidence", bodies.confidence, bodies.time.size(), bodies.names.size());
  }
  return faults;
}

ConsistencyChecker check_arrays(const HandStream& hand, const std::string& path) {
  ConsistencyChecker faults(path);
  faults.texts("@names", hand.names);
  switch (hand.kind) {
    case HandKind::glove:
      faults.length("@sensors", hand.names.size(), 22);
      [[fallthrough]];
    case HandKind::joint_angles:
      faults.table("angles", hand.angles, hand.time.size(), hand.names.size());
      break;
    case HandKind::keypoints:
      faults.table("position", hand.position, hand.time.size(), 21);
      break;
    case HandKind::fingertips:
      faults.table("position", hand.position, hand.time.size(), kFingerCount);
      break;
  }
  return faults;
}

ConsistencyChecker check_arrays(const Streams& streams, const std::string& path) {
  ConsistencyChecker faults(path);
  if (streams.markers) {
    const MarkerStream& markers = *streams.markers;
    faults.texts("markers/@names", markers.names);
    faults.table("markers/position", markers.position, markers.time.size(), markers.names.size());
  }
  if (streams.sensors) faults.take(check_arrays(*streams.sensors, path + "sensors/", false));
  if (streams.skeleton) faults.take(check_arrays(*streams.skeleton, path + "skeleton/", true));
  if (streams.arm_angles) {
    const AngleStream& arm = *streams.arm_angles;
    faults.texts("arm_angles/@joints", arm.joints);
    faults.table("arm_angles/angles", arm.angles, arm.time.size(), arm.joints.size());
  }
  if (streams.hand) faults.take(check_arrays(*streams.hand, path + "hand/"));
  return faults;
}

ConsistencyChecker check_arrays(const Goals& goals, std::size_t tips) {
  ConsistencyChecker faults("goals/");
  const std::size_t frames = goals.frames();
  faults.table("tip_position", goals.tip_position, frames, tips);
  if (goals.tip_to_pad_share.rows > 0)
    faults.table("tip_to_pad_share", goals.tip_to_pad_share, frames, tips);
  if (!goals.auto_closed.empty()) faults.length("auto_closed", goals.auto_closed.size(), tips);
  faults.table("tip_orientation", goals.tip_orientation, frames, tips);
  faults.table("reachable", goals.reachable, frames, tips);
  faults.length("shoulder_position", goals.shoulder_position.size(), frames);
  faults.length("elbow_position", goals.elbow_position.size(), frames);
  faults.length("wrist_position", goals.wrist_position.size(), frames);
  faults.length("wrist_orientation", goals.wrist_orientation.size(), frames);
  faults.table("finger_joint_position", goals.finger_joint_position, frames, kFingerCount);
  return faults;
}

/// Checks that either no frame or every frame of the goals is mapped.
ConsistencyChecker check_arrays(const MappingResult& mapped, std::size_t frames,
                                const RobotModel& robot) {
  ConsistencyChecker faults("mapped/");
  if (mapped.position.rows() == 0) frames = 0;
  faults.table("position", mapped.position, frames, robot.joints());
  faults.table("tip_error", mapped.tip_error, frames, robot.tips.size());
  faults.table("tip_orientation_error", mapped.tip_orientation_error, frames, robot.tips.size());
  faults.length("objective", mapped.objective.size(), frames);
  faults.table("humanlikeness", mapped.humanlikeness, frames, 3);
  faults.length("status", mapped.status.size(), frames);
  for (const FrameStatus status : mapped.status)
    faults.index("status", static_cast<int>(status), 0, enum_count<FrameStatus>());
  return faults;
}

void check_origin(ConsistencyChecker& faults, const std::vector<SampleOrigin>& origins) {
  for (const SampleOrigin origin : origins)
    faults.index("origin", static_cast<int>(origin), 0, enum_count<SampleOrigin>());
}

ConsistencyChecker check_arrays(const Trajectory& trajectory, const std::string& path,
                                std::size_t joints) {
  ConsistencyChecker faults(path);
  const std::size_t samples = trajectory.samples();
  faults.table("position", trajectory.position, samples, joints);
  faults.table("velocity", trajectory.velocity, samples, joints);
  faults.table("acceleration", trajectory.acceleration, samples, joints);
  faults.length("demonstration_time", trajectory.demonstration_time.size(), samples);
  faults.length("phase", trajectory.phase.size(), samples);
  faults.length("origin", trajectory.origin.size(), samples);
  faults.length("clearance", trajectory.clearance.size(), samples);
  for (const PhaseKind phase : trajectory.phase)
    faults.index("phase", static_cast<int>(phase), 0, enum_count<PhaseKind>());
  check_origin(faults, trajectory.origin);
  return faults;
}

ConsistencyChecker check_arrays(const JointPath& path, std::size_t joints) {
  ConsistencyChecker faults("path/");
  const std::size_t samples = path.demonstration_time.size();
  faults.table("position", path.position, samples, joints);
  faults.length("origin", path.origin.size(), samples);
  check_origin(faults, path.origin);
  return faults;
}

ConsistencyChecker check_arrays(const Grasp& grasp, std::size_t samples, const RobotModel& robot) {
  ConsistencyChecker faults("grasp/");
  faults.index("@sample", grasp.sample, 0, samples);
  faults.length("tips_in_object", grasp.tips_in_object.size(), robot.tips.size());
  faults.length("grasp_posture", grasp.grasp_posture.size(), robot.joints());
  if (grasp.grasp_torque.size() > 0) {
    faults.length("grasp_force/torque", grasp.grasp_torque.size(), robot.joints());
    faults.length("grasp_force/servo_target", grasp.servo_target.size(), robot.joints());
  }
  faults.length("pregrasp_posture", grasp.pregrasp_posture.size(), robot.joints());
  return faults;
}

}  // namespace

std::string inconsistency(const Demonstration& demonstration) {
  ConsistencyChecker faults;
  faults.text("@subject", demonstration.subject);
  faults.text("@task", demonstration.task);
  faults.take(check_arrays(demonstration.streams, ""));
  faults.take(check_arrays(demonstration.calibration, "calibration/"));
  if (const auto& offsets = demonstration.sensor_offsets) {
    const std::size_t sensors = offsets->sensors.size();
    faults.length("calibration/offsets/position", offsets->joint_in_sensor.size(), sensors);
    faults.length("calibration/offsets/orientation", offsets->sensor_from_segment.size(), sensors);
  }
  faults.take(check_names(demonstration.objects, "objects/"));
  for (const SceneObject& object : demonstration.objects)
    faults.take(check_arrays(object, "objects/"));
  return faults.first_error.empty() ? bounds_violation(demonstration) : faults.first_error;
}

std::string inconsistency(const RobotModel& robot) {
  ConsistencyChecker faults;
  const std::size_t frames = robot.frames.size();
  const auto vector = [&](const char* name, const JointVector& values) {
    faults.length(name, values.size(), robot.joints());
  };
  faults.text("@name", robot.name);
  faults.texts("@joints", robot.joint_names);
  faults.texts("unchecked_links", robot.unchecked_links);
  for (const RobotModel::Frame& frame : robot.frames) faults.text("frames/name", frame.name);
  for (const RobotModel::Tip& tip : robot.tips) faults.text("tips/name", tip.name);
  for (const RobotModel::Capsule& capsule : robot.capsules)
    faults.text("capsules/name", capsule.name);
  vector("lower", robot.lower);
  vector("upper", robot.upper);
  vector("velocity", robot.velocity);
  vector("acceleration", robot.acceleration);
  vector("jerk", robot.jerk);
  for (std::size_t i = 0; i < frames; ++i) {
    faults.index("frames/parent", robot.frames[i].parent, -1, i);
    faults.index("frames/joint", robot.frames[i].joint, -1, robot.joints());
  }
  for (const RobotModel::CoupledLimit& limit : robot.coupled_limits) {
    faults.index("coupled_limits/frame", limit.frame, 0, frames);
    if (!faults.first_error.empty()) break;
    faults.require(robot.frames[limit.frame].joint >= 0, "coupled_limits/frame", "is fixed");
  }
  for (const RobotModel::BrakingCurve& curve : robot.braking_curves)
    faults.index("braking_curves/joint", curve.joint, 0, robot.joints());
  for (const RobotModel::Tip& tip : robot.tips) {
    faults.index("tips/frame", tip.frame, 0, frames);
    faults.index("tips/finger", tip.finger, -1, kFingerCount);
    faults.require(!(tip.finger_curve_share < 0 || tip.finger_curve_share > 1),
                   "tips/finger_curve_share", "must be from 0 to 1");
  }
  for (const RobotModel::JointCentre& centre : robot.joint_centres)
    faults.index("joint_centres/frame", centre.frame, 0, frames);
  for (const RobotModel::Capsule& capsule : robot.capsules)
    faults.index("capsules/frame", capsule.frame, -1, frames);
  for (const std::array<int, 2>& pair : robot.allowed_collision_pairs)
    for (const int capsule : pair)
      faults.index("allowed_collision_pairs", capsule, 0, robot.capsules.size());
  faults.index("@shoulder_frame", robot.shoulder_frame, 0, frames);
  faults.index("@palm_frame", robot.palm_frame, 0, frames);
  return faults.first_error;
}

std::string inconsistency(const Plan& plan, const RobotModel& robot) {
  ConsistencyChecker faults;
  faults.text("@subject", plan.subject);
  faults.text("@task", plan.task);
  faults.text("@target", plan.movement.target);
  faults.require(plan.has_trajectory() == (plan.trajectory.samples() > 0), "trajectory",
                 plan.has_trajectory() ? "has no samples, but the plan is executable"
                                       : "exists, but the plan is infeasible");
  faults.take(check_arrays(plan.goals, robot.tips.size()));
  faults.take(check_names(plan.scene.objects, "scene/"));
  for (const SceneObject& object : plan.scene.objects) faults.take(check_arrays(object, "scene/"));
  faults.take(check_arrays(plan.mapped, plan.goals.frames(), robot));
  faults.take(check_arrays(plan.path, robot.joints()));
  faults.take(check_arrays(plan.trajectory, "trajectory/", robot.joints()));
  faults.take(check_arrays(plan.approach, "approach/", robot.joints()));
  faults.take(check_arrays(plan.retreat, "retreat/", robot.joints()));
  const std::size_t samples =
      plan.has_trajectory() ? plan.trajectory.samples() : plan.path.demonstration_time.size();
  if (plan.grasp.sample >= 0) faults.take(check_arrays(plan.grasp, samples, robot));
  return faults.first_error;
}

}  // namespace morphe::store
