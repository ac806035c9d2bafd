#include <algorithm>
#include <cmath>
#include <string>

#include "core/motion/movement.hpp"
#include "stages/verify/carried_object.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/object_travel.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

constexpr double kCarriedTolerance_m = 1e-6;
/// Intervals that are still undecided when no body travels farther count as violations, as in
/// verify_contacts().
constexpr double kMinCarriedTravel_m = 1e-5;
constexpr double kCarriedResolution_m = 1e-5;  ///< of the least distance along the curve
/// Distances are evaluated exactly up to the required one plus this multiple of the travel.
constexpr double kCarriedLookahead = 8;
constexpr int kMaxCarriedBisections = 1000000;

/// A part of a piece of the curve, s in [s0, s1].
struct CurvePart {
  int piece = 0;
  double s0 = 0, s1 = 1;
  double middle() const { return 0.5 * (s0 + s1); }
};

class CarriedVerifier {
 public:
  CarriedVerifier(const RobotModel& robot, const Plan& plan, const Curve& curve,
                  const std::vector<Mesh>& meshes, const AttachedObject& attached,
                  ViolationLog& violations)
      : robot_(robot),
        plan_(plan),
        curve_(curve),
        meshes_(meshes),
        attached_(attached),
        violations_(violations) {
    carried_ = find_carried_object(robot, plan, plan.trajectory, attached, meshes);
    for (const SceneObject& object : plan.scene.objects) travels_.push_back(object_travel(object));
    if (attached.object >= 0)
      lever_ = point_motion_bound(robot, attached.frame,
                                  attached.frame_from_object.translation().norm() +
                                      bounding_radius(plan.scene.objects[attached.object]));
  }

  CarriedClearance run() {
    const std::vector<double>& time = curve_.trajectory->demonstration_time;
    clearance_.at_samples.assign(time.size(), kInfinity);
    if (carried_.object < 0) return clearance_;
    verify_release();
    for (int other = 0; other < std::ssize(plan_.scene.objects); ++other) {
      if (other == carried_.object || !has_valid_shape(plan_.scene.objects[other])) continue;
      verify_sample(other, 0);
      for (int piece = 0; piece < curve_.pieces; ++piece) {
        if (time[piece] >= carried_.begin_s) verify_part(other, {piece, 0, 1});
        verify_sample(other, piece + 1);
      }
    }
    return clearance_;
  }

 private:
  void verify_release() {
    const Phase* transport = last_phase(plan_.movement, PhaseKind::transport);
    if (curve_.trajectory != &plan_.trajectory || !carried_.stood || !transport ||
        carried_.release_s == kInfinity)
      return;
    if (carried_.release_height <= kMaxReleaseHeight_m) return;
    violations_.note_plan("release", plan_.movement.target, carried_.release_height,
                          kMaxReleaseHeight_m);
  }

  void verify_sample(int other, int sample) {
    const double time_s = curve_.trajectory->demonstration_time[sample];
    if (time_s < carried_.begin_s) return;
    double& least = clearance_.at_samples[sample];
    const bool touching = carried_.may_touch(other, time_s, time_s);
    const double required = required_distance(other, time_s, time_s);
    const double stored = curve_.trajectory->clearance[sample];
    const double enough = touching ? required
                                   : std::max({required, along_curve(other),
                                               std::isfinite(stored) ? stored + 1e-3 : kInfinity});
    const JointVector q = curve_.trajectory->position.row(sample).transpose();
    const double value = distance(other, q, time_s, enough);
    if (!touching) least = std::min(least, value);
    if (!(value >= required - kCarriedTolerance_m))
      note(other, point_at_sample(*curve_.trajectory, sample), value, required);
    if (!touching) along_curve(other) = std::min(along_curve(other), value);
  }

  /// Proves that the object is clear in a part, and lowers the clearance along the curve.
  void verify_part(int other, const CurvePart& part) {
    const double begin_s = time_at(part, part.s0), middle_s = time_at(part, part.middle()),
                 end_s = time_at(part, part.s1);
    const double travel = max_travel(other, part, begin_s, middle_s, end_s);
    const double required = required_distance(other, begin_s, end_s);
    const double required_here = required_distance(other, middle_s, middle_s);
    const bool counts = !carried_.may_touch(other, begin_s, end_s);
    double& least = along_curve(other);
    const double wanted = counts ? std::max(required, least) : required;
    curve_.position_at(part.piece, part.middle(), q_);
    const double value = distance(other, q_, middle_s, wanted + kCarriedLookahead * travel);
    const bool violated = !(value >= required_here - kCarriedTolerance_m);
    const bool proved = value >= required + travel - kCarriedTolerance_m;
    if (!carried_.may_touch(other, middle_s, middle_s)) least = std::min(least, value);
    const bool may_be_less = counts && value - travel < least - kCarriedResolution_m;
    if (violated) note(other, curve_.point_at(part.piece, part.middle()), value, required_here);
    if ((proved || violated) && !may_be_less) return;
    if (travel > kMinCarriedTravel_m && bisections_left_ > 0) {
      --bisections_left_;
      verify_part(other, {part.piece, part.s0, part.middle()});
      verify_part(other, {part.piece, part.middle(), part.s1});
      return;
    }
    if (may_be_less) least = value - travel;
    if (!proved && !violated)
      note(other, curve_.point_at(part.piece, part.middle()), value, required);
  }

  /// Returns the least distance so far from objects of the same kind as `other`.
  double& along_curve(int other) {
    const ClearanceKind kind =
        kind_of_object(plan_.scene.objects[other].name, plan_.movement.target);
    return clearance_.along_curve[static_cast<std::size_t>(kind)];
  }

  double time_at(const CurvePart& part, double s) const {
    return curve_.demonstration_time_at(part.piece, s);
  }

  double required_distance(int other, double begin_s, double end_s) const {
    return carried_.required_distance(other, begin_s, end_s, plan_.tolerances.required_clearance);
  }

  /// Returns by how much the distance may be less anywhere in a part than at its middle.
  double max_travel(int other, const CurvePart& part, double begin_s, double middle_s,
                    double end_s) const {
    const auto recorded = [&](int object) {
      const double middle = travels_[object].until(middle_s);
      return std::max(middle - travels_[object].until(begin_s),
                      travels_[object].until(end_s) - middle);
    };
    const std::vector<double>& time = curve_.trajectory->time;
    double own = recorded(carried_.object);
    if (attached_.is_released(middle_s)) own = 0;
    if (attached_.is_attached(middle_s))
      own = 0.5 * (part.s1 - part.s0) * (time[part.piece + 1] - time[part.piece]) *
            curve_.speed.row(part.piece).dot(lever_);
    return own + recorded(other);
  }

  double distance(int other, const JointVector& q, double time_s, double enough) const {
    const std::vector<SceneObject>& objects = plan_.scene.objects;
    const Pose own = carried_pose(robot_, objects[carried_.object], attached_, q, time_s);
    const Pose base_from_other = recorded_pose(objects[other], time_s);
    return body_distance({objects[carried_.object], meshes_[carried_.object], own},
                         {objects[other], meshes_[other], base_from_other}, enough);
  }

  void note(int other, const CurvePoint& point, double value, double required) {
    violations_.note("object_collision",
                     plan_.movement.target + "/" + plan_.scene.objects[other].name, point, value,
                     required, required - value);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const Curve& curve_;
  const std::vector<Mesh>& meshes_;
  const AttachedObject& attached_;
  ViolationLog& violations_;
  CarriedObject carried_;
  std::vector<ObjectTravel> travels_;
  JointVector lever_;  ///< [n] of the attached object [m/rad]
  CarriedClearance clearance_;
  JointVector q_;
  int bisections_left_ = kMaxCarriedBisections;
};

}  // namespace

double carried_distance(const RobotModel& robot, const Plan& plan, const std::vector<Mesh>& meshes,
                        const AttachedObject& attached, const std::string& other,
                        const JointVector& q, double time_s) {
  const std::vector<SceneObject>& objects = plan.scene.objects;
  const auto index_of = [&](const std::string& name) {
    return std::ranges::find(objects, name, &SceneObject::name) - objects.begin();
  };
  const auto own = index_of(plan.movement.target), second = index_of(other);
  if (own == second || std::max(own, second) >= std::ssize(objects)) return kUnknown;
  const Pose own_pose = carried_pose(robot, objects[own], attached, q, time_s),
             other_pose = recorded_pose(objects[second], time_s);
  return body_distance({objects[own], meshes[own], own_pose},
                       {objects[second], meshes[second], other_pose}, kInfinity);
}

CarriedClearance verify_carried_object(const RobotModel& robot, const Plan& plan,
                                       const Curve& curve, const std::vector<Mesh>& meshes,
                                       const AttachedObject& attached, ViolationLog& violations) {
  return CarriedVerifier(robot, plan, curve, meshes, attached, violations).run();
}

}  // namespace morphe::verify
