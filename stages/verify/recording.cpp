#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/motion/scene.hpp"
#include "stages/verify/requirements.hpp"
#include "stages/verify/verify.hpp"
#include "stages/verify/violation_log.hpp"

namespace morphe::verify {
namespace {

constexpr double kRecordedTolerance = 1e-6;  ///< [m, s, or entry of a rotation]
/// Contacts change the goals of tips from this time before the grasp on, if no preshape begins
/// earlier [s].
constexpr double kClosingLead_s = 0.5;

double deviation(double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) == std::isnan(b) ? 0 : kInfinity;
  return a == b ? 0 : std::abs(a - b);
}
double deviation(const Vec3& a, const Vec3& b) {
  double most = 0;
  for (int k = 0; k < 3; ++k) most = std::max(most, deviation(a[k], b[k]));
  return most;
}
/// Returns the deviation of two rotations, for which q and -q are the same.
double deviation(const Quat& a, const Quat& b) {
  if (is_known(a) != is_known(b)) return kInfinity;
  if (!is_known(a)) return 0;
  const double sign = a.dot(b) < 0 ? -1 : 1;
  return (a.coeffs() - sign * b.coeffs()).cwiseAbs().maxCoeff();
}
double deviation(const Pose& a, const Pose& b) {
  double most = 0;
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 4; ++col)
      most = std::max(most, deviation(a.matrix()(row, col), b.matrix()(row, col)));
  return most;
}
/// Returns the largest deviation of two lists; infinite if they differ in length.
template <class T>
double deviation(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return kInfinity;
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, deviation(a[k], b[k]));
  return most;
}

bool same_flag(const RecordingFlag& a, const RecordingFlag& b) {
  const double numbers = std::max({deviation(a.begin_s, b.begin_s), deviation(a.end_s, b.end_s),
                                   deviation(a.value, b.value) / std::max(1.0, std::abs(b.value)),
                                   deviation(a.limit, b.limit)});
  return a.code == b.code && a.response == b.response && a.subject == b.subject &&
         a.unit == b.unit && numbers <= kRecordedTolerance;
}

bool same_phase(const Phase& a, const Phase& b) {
  return a.kind == b.kind &&
         std::max({deviation(a.begin_s, b.begin_s), deviation(a.end_s, b.end_s),
                   deviation(a.confidence, b.confidence)}) <= kRecordedTolerance;
}

class RecordingVerifier {
 public:
  RecordingVerifier(const std::string& path, const Plan& stored, const Plan& expected)
      : own_(stored), expected_(expected), violations_(path) {}

  std::vector<Violation> run() {
    compare_names();
    compare_movement();
    compare_scene();
    compare_goals();
    return violations_.finish();
  }

 private:
  void require(bool holds, const std::string& subject) {
    if (!holds) violations_.note_plan("recording", subject, kUnknown, kUnknown);
  }
  void require_near(double deviation, const std::string& subject) {
    if (!(deviation <= kRecordedTolerance))
      violations_.note_plan("recording", subject, deviation, kRecordedTolerance);
  }

  void compare_names() {
    require(own_.subject == expected_.subject, "subject");
    require(own_.task == expected_.task, "task");
    require(own_.source == expected_.source, "source");
    require(own_.licence == expected_.licence, "licence");
    require(own_.hand == expected_.hand, "hand");
    require(own_.recording_assumptions == expected_.recording_assumptions, "assumptions");
    require(std::ranges::equal(own_.flags, expected_.flags, same_flag), "flags");
    // A movement that cannot be placed fails for a reason that the recording alone determines.
    if (expected_.reason != Reason::unplanned) require(own_.reason == expected_.reason, "reason");
  }

  void compare_movement() {
    const Movement &own = own_.movement, &expected = expected_.movement;
    require(own.target == expected.target, "target");
    require(std::ranges::equal(own.phases, expected.phases, same_phase), "phases");
    require_near(deviation(own.begin_s, expected.begin_s), "begin_s");
    require_near(deviation(own.end_s, expected.end_s), "end_s");
  }

  void compare_scene() {
    const WorldFrames &own = own_.reference_frames, &expected = expected_.reference_frames;
    require_near(deviation(own.base_from_world, expected.base_from_world),
                 "reference_frames/recording");
    require_near(deviation(own.base_from_table, expected.base_from_table),
                 "reference_frames/table");
    require_near(deviation(own.base_from_target, expected.base_from_target),
                 "reference_frames/target");
    require_near(deviation(own.shoulder, expected.shoulder), "reference_frames/shoulder");
    for (const SceneObject& object : expected_.scene.objects) {
      const SceneObject* stored = find_object(own_.scene.objects, object.name);
      require(stored, "scene/" + object.name);
      if (stored) compare(*stored, object);
    }
    for (const SceneObject& object : own_.scene.objects)
      require(find_object(expected_.scene.objects, object.name), "scene/" + object.name);
  }

  void compare(const SceneObject& own, const SceneObject& expected) {
    const std::string name = "scene/" + own.name;
    const bool shape = own.shape == expected.shape && own.triangles == expected.triangles &&
                       deviation(own.size, expected.size) <= kRecordedTolerance &&
                       deviation(own.vertices, expected.vertices) <= kRecordedTolerance;
    require(shape, name + "/shape");
    require(own.pose_origin == expected.pose_origin, name + "/pose_origin");
    require(own.shape_origin == expected.shape_origin, name + "/shape_origin");
    require(own.attached_frame == expected.attached_frame, name + "/attached_frame");
    require_near(deviation(own.attach_s, expected.attach_s), name + "/attach_s");
    require_near(deviation(own.release_s, expected.release_s), name + "/release_s");
    require_near(deviation(own.time, expected.time), name + "/time");
    require_near(deviation(own.position, expected.position), name + "/position");
    require_near(deviation(own.orientation, expected.orientation), name + "/orientation");
  }

  void compare_goals() {
    const Goals &own = own_.goals, &expected = expected_.goals;
    require(own.estimated == expected.estimated, "goals/estimated");
    require(own.base_offset.has_value() == expected.base_offset.has_value(), "goals/base_offset");
    require_near(deviation(own.common_base_offset, expected.common_base_offset),
                 "goals/common_base_offset");
    require_near(deviation(own.time, expected.time), "goals/time");
    require_near(deviation(own.shoulder_position, expected.shoulder_position),
                 "goals/shoulder_position");
    require_near(deviation(own.elbow_position, expected.elbow_position), "goals/elbow_position");
    require_near(deviation(own.wrist_position, expected.wrist_position), "goals/wrist_position");
    require_near(deviation(own.wrist_orientation, expected.wrist_orientation),
                 "goals/wrist_orientation");
    require_near(deviation(own.finger_joint_position.values, expected.finger_joint_position.values),
                 "goals/finger_joint_position");
    require_near(deviation(own.tip_orientation.values, expected.tip_orientation.values),
                 "goals/tip_orientation");
    require_near(tip_deviation(), "goals/tip_position");
  }

  /// Returns the largest deviation of tip goals that no contact can have changed.
  double tip_deviation() const {
    const Array2D<Vec3>&own = own_.goals.tip_position, &expected = expected_.goals.tip_position;
    if (own.rows != expected.rows || own.cols != expected.cols) return kInfinity;
    const double until_s = own_.tolerances.max_link_penetration ? closing_begin_s() : kInfinity;
    double most = 0;
    for (std::size_t f = 0; f < own.rows; ++f) {
      if (own_.goals.time[f] >= until_s) break;
      for (std::size_t tip = 0; tip < own.cols; ++tip)
        most = std::max(most, deviation(own(f, tip), expected(f, tip)));
    }
    return most;
  }

  double closing_begin_s() const {
    double begin_s = kInfinity;
    for (const Phase& phase : own_.movement.phases) {
      if (phase.kind == PhaseKind::preshape) begin_s = std::min(begin_s, phase.begin_s);
      if (phase.kind == PhaseKind::grasp)
        begin_s = std::min(begin_s, phase.begin_s - kClosingLead_s);
    }
    return begin_s;
  }

  const Plan &own_, &expected_;
  ViolationLog violations_;
};

}  // namespace

std::vector<Violation> verify_recorded(const std::string& plan_path, const Plan& stored,
                                       const Plan& expected) {
  return RecordingVerifier(plan_path, stored, expected).run();
}

}  // namespace morphe::verify
