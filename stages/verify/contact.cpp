#include "stages/verify/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "stages/verify/attached_object.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/mesh.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

constexpr double kDistanceTolerance_m = 1e-6;
/// Intervals that are still undecided when no body moves more than this count as violations. It is
/// finer than the 0.1 mm of planning, so that clearance that planning proved with other intervals
/// is not left undecided.
constexpr double kMinContactTravel_m = 1e-5;
/// Resolution of the clearance of the whole motion.
constexpr double kClearanceResolution_m = 1e-5;
/// Tolerance of the stored clearance of a sample.
constexpr double kStoredClearanceTolerance_m = 1e-4;
/// Intervals with more travel than this between two samples are not bisected and count as
/// violations.
constexpr double kMaxContactTravel_m = 10;
/// The maximum number of bisections for a proof: ten metres at every 0.01 mm. Intervals that are
/// undecided by then count as violations. The same limit holds for the search for the least
/// clearance, which returns its lower bound if the limit is exceeded.
constexpr int kMaxContactBisections = 1000000;
/// Distances are evaluated up to this multiple of the travel in a piece if this is cheap, so that
/// the next pieces can skip the pair.
constexpr double kLookaheadRatio = 8;

/// The distance that any point of an object has travelled at most since its first sample, for each
/// of its samples.
struct ObjectTravel {
  const SceneObject* is_object = nullptr;
  std::vector<double> travelled;  ///< [K] [m]

  double at(double time_s) const {
    const auto& time = is_object->time;
    const auto after =
        static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), time_s) - time.begin());
    if (after == 0) return travelled.front();
    if (after == time.size()) return travelled.back();
    const double share = (time_s - time[after - 1]) / (time[after] - time[after - 1]);
    return travelled[after - 1] + share * (travelled[after] - travelled[after - 1]);
  }
};

ObjectTravel object_travel(const SceneObject& object) {
  ObjectTravel travel{&object, {0.0}};
  if (!has_valid_shape(object)) return travel;
  const double radius = object.shape == Shape::sphere ? 0.0 : bounding_radius(object);
  for (std::size_t k = 1; k < object.time.size(); ++k) {
    travel.travelled.push_back(
        travel.travelled.back() + (object.position[k] - object.position[k - 1]).norm() +
        radius * angle_between(object.orientation[k - 1], object.orientation[k]));
  }
  return travel;
}

/// The poses of all bodies at one instant.
struct Snapshot {
  std::vector<Pose> base_from_frame, object_from_base;
  std::vector<Segment> axes;  ///< of the capsules, in the base frame
  double demonstration_time = 0;
};

class ContactVerifier {
 public:
  ContactVerifier(const RobotModel& robot, const Plan& plan, const Curve& curve,
                  ViolationCollector& runs)
      : robot_(robot), plan_(plan), curve_(curve), runs_(runs) {
    pairs_ = contact_pairs(robot, plan);
    window_ = touch_window(plan.movement.phases);
    for (const SceneObject& object : plan.scene.objects) {
      travels_.push_back(object_travel(object));
      meshes_.push_back(object.shape == Shape::mesh ? make_mesh(object) : Mesh());
    }
    motion_bounds_.resize(pairs_.size(), robot.lower.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i) motion_bounds_.row(i) = pairs_[i].motion_bound;
    carried_ = find_attached_object(robot, plan, *curve.trajectory);
    if (carried_.object < 0) return;
    const SceneObject& target = plan.scene.objects[carried_.object];
    for (std::size_t i = 0; i < robot.capsules.size(); ++i) {
      attached_motion_bound_.push_back(
          relative_motion_bound(robot, static_cast<int>(i), carried_.frame,
                                carried_.frame_from_object.translation(), bounding_radius(target)));
    }
  }

  double run() {
    double clearance = kInfinity;
    reset_distance_bounds();
    for (std::size_t sample = 0; sample <= curve_.pieces; ++sample) {
      verify_sample(sample, clearance);
      if (sample == curve_.pieces) break;
      const SegmentInterval piece = make_interval(sample, 0, 1);
      verify_interval(piece, candidate_pairs(piece, [&](const ContactPair& pair) {
                        return required_clearance_in(pair, piece);
                      }));
    }
    reset_distance_bounds();
    for (std::size_t sample = 0; sample < curve_.pieces; ++sample) {
      const SegmentInterval piece = make_interval(sample, 0, 1);
      refine_clearance(piece, candidate_pairs(piece, [&](const ContactPair&) { return clearance; }),
                       clearance);
    }
    return clearance;
  }

 private:
  void verify_sample(std::size_t sample, double& clearance) {
    const auto row = static_cast<Eigen::Index>(sample);
    const double time_s = curve_.trajectory->demonstration_time[sample];
    const CurvePoint place{static_cast<int>(2 * sample), static_cast<int>(sample),
                           curve_.trajectory->time[sample]};
    const double stored = curve_.trajectory->clearance[sample];
    // Without a stored clearance, the least distance itself is computed.
    const double told = std::isfinite(stored) ? stored + kStoredClearanceTolerance_m : kInfinity;
    double here = kInfinity;
    bool placed = false;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const ContactPair& pair = pairs_[i];
      const bool touching = pair.may_touch && window_.contains(time_s, time_s);
      const double required = required_distance(pair, touching);
      const double enough =
          touching ? required : std::max({required, clearance, std::min(told, here)});
      if (is_known_clear(i, enough)) {
        if (!touching) here = std::min(here, bound_[i]);
        continue;
      }
      if (!std::exchange(placed, true))
        update_body_poses(curve_.trajectory->position.row(row).transpose(), time_s);
      const double value = distance(pair, enough);
      bound_[i] = value;
      if (!touching) here = std::min(here, value);
      if (!(value >= required - kDistanceTolerance_m))
        note(pair, place, value, required, required - value);
    }
    clearance = std::min(clearance, here);
    const bool none = here == kInfinity;
    if (none ? std::isnan(stored) : std::abs(stored - here) <= kStoredClearanceTolerance_m) return;
    runs_.note("clearance", "trajectory", place, stored, none ? kUnknown : here,
               std::abs(stored - here));
  }

  /// A part of a piece, s in [s0, s1], with its demonstration times and half its duration.
  struct SegmentInterval {
    std::size_t piece = 0;
    double s0 = 0, s1 = 1;
    double begin_s = 0, middle_s = 0, end_s = 0, half_s = 0;

    double middle() const { return 0.5 * (s0 + s1); }
  };

  SegmentInterval make_interval(std::size_t piece, double s0, double s1) const {
    const auto& time = curve_.trajectory->time;
    return {piece,
            s0,
            s1,
            curve_.demonstration_time_at(piece, s0),
            curve_.demonstration_time_at(piece, 0.5 * (s0 + s1)),
            curve_.demonstration_time_at(piece, s1),
            0.5 * (s1 - s0) * (time[piece + 1] - time[piece])};
  }

  /// Discards the distance bounds of all pairs.
  void reset_distance_bounds() { bound_.assign(pairs_.size(), -kInfinity); }

  /// Returns true if a pair is at least `enough` apart according to its previous distance bound. An
  /// object that the hand attaches or releases may change its pose at once, so that its bound is
  /// unknown.
  bool is_known_clear(std::size_t index, double enough) const {
    const ContactPair& pair = pairs_[index];
    return !(pair.is_object && pair.other == carried_.object) && bound_[index] >= enough;
  }

  /// Returns the pairs that may come closer than `enough(pair)` in a piece, according to their last
  /// evaluated distances and the greatest travel since then.
  template <class Enough>
  std::vector<std::size_t> candidate_pairs(const SegmentInterval& piece, const Enough& enough) {
    by_joints_.noalias() = motion_bounds_ * curve_.speed.row(piece.piece).transpose();
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const ContactPair& pair = pairs_[i];
      double travel = piece.half_s * by_joints_[i];
      if (pair.is_object) travel += max_object_travel(piece, pair);
      bound_[i] -= 2 * travel;
      if (!is_known_clear(i, enough(pair))) near.push_back(i);
    }
    return near;
  }

  /// Proves that the pairs are clear in an interval, bisecting it for those that are undecided.
  void verify_interval(const SegmentInterval& part, const std::vector<std::size_t>& pairs) {
    if (pairs.empty()) return;
    update_poses_at_middle(part);
    std::vector<std::size_t> open;
    for (const std::size_t index : pairs) {
      const ContactPair& pair = pairs_[index];
      const double travel = max_travel(part, pair);
      const double everywhere = required_clearance_in(pair, part);
      const double here =
          required_distance(pair, pair.may_touch && window_.contains(part.middle_s, part.middle_s));
      const double value = distance(pair, everywhere + kLookaheadRatio * travel);
      bound_[index] = value - travel;
      if (value >= everywhere + travel - kDistanceTolerance_m) continue;
      const bool violated = !(value >= here - kDistanceTolerance_m);
      if (!violated && travel > kMinContactTravel_m && travel < kMaxContactTravel_m &&
          bisections_left_ > 0) {
        open.push_back(index);
      } else {
        const double required = violated ? here : everywhere;
        note(pair, place(part.piece, part.middle()), value, required, required - value);
      }
    }
    if (open.empty()) return;
    --bisections_left_;
    verify_interval(make_interval(part.piece, part.s0, part.middle()), open);
    verify_interval(make_interval(part.piece, part.middle(), part.s1), open);
  }

  /// Lowers the clearance to the least distance, in an interval, of pairs that may not touch,
  /// unless it is below the clearance by less than the resolution.
  void refine_clearance(const SegmentInterval& part, const std::vector<std::size_t>& pairs,
                        double& clearance) {
    if (pairs.empty()) return;
    update_poses_at_middle(part);
    std::vector<std::size_t> open;
    for (const std::size_t index : pairs) {
      const ContactPair& pair = pairs_[index];
      bound_[index] = -kInfinity;
      if (pair.may_touch && window_.contains(part.begin_s, part.end_s)) continue;
      const double travel = max_travel(part, pair);
      const double value = distance(pair, clearance + kLookaheadRatio * travel);
      bound_[index] = value - travel;
      const bool touching = pair.may_touch && window_.contains(part.middle_s, part.middle_s);
      if (!touching) clearance = std::min(clearance, value);
      const bool settled = value - travel >= clearance - kClearanceResolution_m;
      if (settled || !(travel > 0.1 * kClearanceResolution_m && travel < kMaxContactTravel_m))
        continue;
      if (sweeps_left_ > 0) {
        open.push_back(index);
      } else {
        clearance = std::min(clearance, value - travel);
      }
    }
    if (open.empty()) return;
    --sweeps_left_;
    refine_clearance(make_interval(part.piece, part.s0, part.middle()), open, clearance);
    refine_clearance(make_interval(part.piece, part.middle(), part.s1), open, clearance);
  }

  /// Computes the poses of all bodies at the middle of an interval.
  void update_poses_at_middle(const SegmentInterval& part) {
    curve_.position_at(part.piece, part.middle(), q_);
    update_body_poses(q_, part.middle_s);
  }

  /// Returns the distance by which a pair can come closer than at the middle of an interval.
  double max_travel(const SegmentInterval& part, const ContactPair& pair) const {
    const bool target = pair.is_object && pair.other == carried_.object;
    const JointVector& lever = target && carried_.is_attached(part.middle_s)
                                   ? attached_motion_bound_[pair.capsule]
                                   : pair.motion_bound;
    const double by_joints = part.half_s * curve_.speed.row(part.piece).dot(lever);
    const bool still = target && part.middle_s >= carried_.attach_s;
    return !pair.is_object || still ? by_joints : by_joints + max_object_travel(part, pair);
  }

  /// Returns the greatest travel of the object alone, along its recorded poses.
  double max_object_travel(const SegmentInterval& part, const ContactPair& pair) const {
    const ObjectTravel& moved = travels_[pair.other];
    if (moved.travelled.size() == 1) return 0;
    const double here = moved.at(part.middle_s);
    return std::max(here - moved.at(part.begin_s), moved.at(part.end_s) - here);
  }

  /// Returns the clearance required along a whole interval.
  double required_clearance_in(const ContactPair& pair, const SegmentInterval& part) const {
    return required_distance(pair, pair.may_touch && window_.contains(part.begin_s, part.end_s));
  }

  double required_distance(const ContactPair& pair, bool touching) const {
    const Tolerances& allowed = plan_.tolerances;
    if (!touching) return allowed.required_clearance;
    return -(pair.is_pad ? allowed.max_penetration
                         : allowed.max_link_penetration.value_or(allowed.max_penetration));
  }

  void update_body_poses(const JointVector& q, double time_s) {
    frame_poses(robot_, q, now_.base_from_frame);
    now_.axes.resize(robot_.capsules.size());
    for (std::size_t i = 0; i < now_.axes.size(); ++i) {
      const RobotModel::Capsule& capsule = robot_.capsules[i];
      now_.axes[i] = {to_base_frame(now_.base_from_frame, capsule.frame, capsule.from),
                      to_base_frame(now_.base_from_frame, capsule.frame, capsule.to)};
    }
    now_.object_from_base.resize(plan_.scene.objects.size());
    for (std::size_t k = 0; k < now_.object_from_base.size(); ++k)
      now_.object_from_base[k] = recorded_pose(plan_.scene.objects[k], time_s).inverse();
    if (carried_.is_attached(time_s)) {
      now_.object_from_base[carried_.object] =
          (now_.base_from_frame[carried_.frame] * carried_.frame_from_object).inverse();
    } else if (carried_.is_released(time_s)) {
      now_.object_from_base[carried_.object] = carried_.base_from_released_object.inverse();
    }
  }

  /// Returns the exact distance if it is below `enough`, otherwise any lower bound that is at least
  /// `enough`.
  double distance(const ContactPair& pair, double enough) const {
    const Segment& axis = now_.axes[pair.capsule];
    const auto other = static_cast<std::size_t>(pair.other);
    if (pair.is_object) {
      const Pose& object_from_base = now_.object_from_base[other];
      const Segment in_object{object_from_base * axis.from, object_from_base * axis.to};
      const SceneObject& object = plan_.scene.objects[other];
      const double reach = enough + pair.radius_sum;
      return (object.shape == Shape::mesh ? segment_mesh_distance(meshes_[other], in_object, reach)
                                          : segment_solid_distance(object, in_object, reach)) -
             pair.radius_sum;
    }
    const Segment& second = now_.axes[other];
    const double spheres = 0.5 * ((axis.from + axis.to - second.from - second.to).norm() -
                                  (axis.to - axis.from).norm() - (second.to - second.from).norm()) -
                           pair.radius_sum;
    return spheres >= enough ? spheres : segment_distance(axis, second) - pair.radius_sum;
  }

  CurvePoint place(std::size_t piece, double s) const {
    return {static_cast<int>(2 * piece + 1), static_cast<int>(s < 0.5 ? piece : piece + 1),
            curve_.time_at(piece, s)};
  }

  void note(const ContactPair& pair, const CurvePoint& place, double value, double required,
            double excess) {
    runs_.note(pair.is_object ? "object_collision" : "self_collision", pair.subject, place, value,
               required, excess);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const Curve& curve_;
  ViolationCollector& runs_;
  int bisections_left_ = kMaxContactBisections, sweeps_left_ = kMaxContactBisections;
  std::vector<ContactPair> pairs_;
  TouchWindow window_;
  std::vector<ObjectTravel> travels_;
  std::vector<Mesh> meshes_;  ///< [objects] empty if the object is not a mesh
  AttachedObject carried_;
  std::vector<JointVector> attached_motion_bound_;  ///< [capsules] relative to the attached target
  JointRows motion_bounds_;                         ///< [pairs, n] motion bounds of the pairs
  JointVector by_joints_;  ///< [pairs] greatest approach speed in the current piece [m/s]
  /// [pairs] lower bound of the distance at the end of the last evaluated interval [m]
  std::vector<double> bound_;
  Snapshot now_;
  JointVector q_;
};

}  // namespace

double verify_contacts(const RobotModel& robot, const Plan& plan, const Curve& curve,
                       ViolationCollector& runs) {
  return ContactVerifier(robot, plan, curve, runs).run();
}

}  // namespace morphe::verify
