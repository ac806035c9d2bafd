#include "stages/verify/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "stages/verify/carried.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/mesh.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

constexpr double kDistanceTolerance_m = 1e-6;
/// Where nothing moves more than this any longer, what is not proved counts as a violation. Finer
/// than the 0.1 mm of planning, so that what was proved there by other intervals is not left open.
constexpr double kBand_m = 1e-5;
/// To which the clearance of the whole motion is found.
constexpr double kResolution_m = 1e-5;
/// To which the stored clearance of a sample must agree.
constexpr double kStoredClearance_m = 1e-4;
/// More travel than this between two samples is not worth bisecting: it counts as a violation.
constexpr double kHopeless_m = 10;
/// So often intervals are halved to prove them, ten metres at every 0.01 mm; what is not proved by
/// then counts as a violation. As often to find the least clearance, which is as small as it may be
/// where that was not enough.
constexpr int kHalvings = 1000000;
/// Pairs are known to be apart by so many times what they can travel in a piece, if that is cheap
/// to tell: then the next pieces need not look.
constexpr double kAhead = 8;

/// How far any point of an object has travelled since its first sample, at each of its samples.
struct ObjectTravel {
  const SceneObject* object = nullptr;
  std::vector<double> travelled;  ///< [K] [m]

  double at(double time_s) const {
    const auto& time = object->time;
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
  if (!can_judge(object)) return travel;
  const double radius = object.shape == Shape::sphere ? 0.0 : bounding_radius(object);
  for (std::size_t k = 1; k < object.time.size(); ++k) {
    travel.travelled.push_back(
        travel.travelled.back() + (object.position[k] - object.position[k - 1]).norm() +
        radius * angle_between(object.orientation[k - 1], object.orientation[k]));
  }
  return travel;
}

/// All bodies at one instant.
struct Snapshot {
  std::vector<Pose> base_from_frame, object_from_base;
  std::vector<Segment> axes;  ///< of the capsules, in the base frame
  double demonstration_time = 0;
};

class ContactJudge {
 public:
  ContactJudge(const RobotTable& robot, const Plan& plan, const Curve& curve, ViolationRuns& runs)
      : robot_(robot), plan_(plan), curve_(curve), runs_(runs) {
    pairs_ = contact_pairs(robot, plan);
    window_ = touch_window(plan.movement.phases);
    for (const SceneObject& object : plan.scene.objects) {
      travels_.push_back(object_travel(object));
      meshes_.push_back(object.shape == Shape::mesh ? make_mesh(object) : Mesh());
    }
    levers_.resize(static_cast<Eigen::Index>(pairs_.size()), robot.lower.size());
    for (std::size_t i = 0; i < pairs_.size(); ++i)
      levers_.row(static_cast<Eigen::Index>(i)) = pairs_[i].lever;
    carried_ = carried_target(robot, plan, *curve.trajectory);
    if (carried_.object < 0) return;
    const SceneObject& target = plan.scene.objects[static_cast<std::size_t>(carried_.object)];
    for (std::size_t i = 0; i < robot.capsules.size(); ++i) {
      in_hand_lever_.push_back(relative_lever(robot, static_cast<int>(i), carried_.frame,
                                              carried_.frame_from_object.translation(),
                                              bounding_radius(target)));
    }
  }

  double run() {
    double clearance = kInfinity;
    forget();
    for (std::size_t sample = 0; sample <= curve_.pieces; ++sample) {
      judge_sample(sample, clearance);
      if (sample == curve_.pieces) break;
      const Stretch piece = stretch(sample, 0, 1);
      judge_interval(
          piece, near_in(piece, [&](const ContactPair& pair) { return required_in(pair, piece); }));
    }
    forget();
    for (std::size_t sample = 0; sample < curve_.pieces; ++sample) {
      const Stretch piece = stretch(sample, 0, 1);
      sweep(piece, near_in(piece, [&](const ContactPair&) { return clearance; }), clearance);
    }
    return clearance;
  }

 private:
  void judge_sample(std::size_t sample, double& clearance) {
    const auto row = static_cast<Eigen::Index>(sample);
    const double time_s = curve_.trajectory->demonstration_time[sample];
    const CurvePoint place{static_cast<int>(2 * sample), static_cast<int>(sample),
                           curve_.trajectory->time[sample]};
    const double stored = curve_.trajectory->clearance[sample];
    // Where it is not told what to look up to, the least distance is looked for.
    const double told = std::isfinite(stored) ? stored + kStoredClearance_m : kInfinity;
    double here = kInfinity;
    bool placed = false;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const ContactPair& pair = pairs_[i];
      const bool touching = pair.may_touch && window_.contains(time_s, time_s);
      const double required = required_distance(pair, touching);
      const double enough =
          touching ? required : std::max({required, clearance, std::min(told, here)});
      if (known(i, enough)) {
        if (!touching) here = std::min(here, bound_[i]);
        continue;
      }
      if (!std::exchange(placed, true))
        take(curve_.trajectory->position.row(row).transpose(), time_s);
      const double value = distance(pair, enough);
      bound_[i] = value;
      if (!touching) here = std::min(here, value);
      if (!(value >= required - kDistanceTolerance_m))
        note(pair, place, value, required, required - value);
    }
    clearance = std::min(clearance, here);
    const bool none = here == kInfinity;
    if (none ? std::isnan(stored) : std::abs(stored - here) <= kStoredClearance_m) return;
    runs_.note("clearance", "trajectory", place, stored, none ? kNotSeen : here,
               std::abs(stored - here));
  }

  /// A part of a piece, s in [s0, s1]: its demonstration times, and half its duration.
  struct Stretch {
    std::size_t piece = 0;
    double s0 = 0, s1 = 1;
    double begin_s = 0, middle_s = 0, end_s = 0, half_s = 0;

    double middle() const { return 0.5 * (s0 + s1); }
  };

  Stretch stretch(std::size_t piece, double s0, double s1) const {
    const auto& time = curve_.trajectory->time;
    return {piece,
            s0,
            s1,
            curve_.demonstration_time_at(piece, s0),
            curve_.demonstration_time_at(piece, 0.5 * (s0 + s1)),
            curve_.demonstration_time_at(piece, s1),
            0.5 * (s1 - s0) * (time[piece + 1] - time[piece])};
  }

  /// Nothing is known of any pair.
  void forget() { bound_.assign(pairs_.size(), -kInfinity); }

  /// Whether a pair is as far apart as that, by where it was before. What the hand takes up or
  /// leaves may be elsewhere at once: nothing is known of it.
  bool known(std::size_t index, double enough) const {
    const ContactPair& pair = pairs_[index];
    return !(pair.object && pair.other == carried_.object) && bound_[index] >= enough;
  }

  /// The pairs that may come nearer than `enough(pair)` in a piece, as far as it can be told from
  /// where they were when last looked at and how far they can have travelled since.
  template <class Enough>
  std::vector<std::size_t> near_in(const Stretch& piece, const Enough& enough) {
    by_joints_.noalias() =
        levers_ * curve_.speed.row(static_cast<Eigen::Index>(piece.piece)).transpose();
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const ContactPair& pair = pairs_[i];
      double travel = piece.half_s * by_joints_[static_cast<Eigen::Index>(i)];
      if (pair.object) travel += object_travel_in(piece, pair);
      bound_[i] -= 2 * travel;
      if (!known(i, enough(pair))) near.push_back(i);
    }
    return near;
  }

  /// Proves the pairs clear in a stretch, bisecting for those that are not proved at once.
  void judge_interval(const Stretch& part, const std::vector<std::size_t>& pairs) {
    if (pairs.empty()) return;
    take_middle(part);
    std::vector<std::size_t> open;
    for (const std::size_t index : pairs) {
      const ContactPair& pair = pairs_[index];
      const double travel = travel_in(part, pair);
      const double everywhere = required_in(pair, part);
      const double here =
          required_distance(pair, pair.may_touch && window_.contains(part.middle_s, part.middle_s));
      const double value = distance(pair, everywhere + kAhead * travel);
      bound_[index] = value - travel;
      if (value >= everywhere + travel - kDistanceTolerance_m) continue;
      const bool violated = !(value >= here - kDistanceTolerance_m);
      if (!violated && travel > kBand_m && travel < kHopeless_m && halvings_left_ > 0) {
        open.push_back(index);
      } else {
        const double required = violated ? here : everywhere;
        note(pair, place(part.piece, part.middle()), value, required, required - value);
      }
    }
    if (open.empty()) return;
    --halvings_left_;
    judge_interval(stretch(part.piece, part.s0, part.middle()), open);
    judge_interval(stretch(part.piece, part.middle(), part.s1), open);
  }

  /// Lowers the clearance to the least distance in a stretch of pairs that may not touch, as far as
  /// it lies more than the resolution below.
  void sweep(const Stretch& part, const std::vector<std::size_t>& pairs, double& clearance) {
    if (pairs.empty()) return;
    take_middle(part);
    std::vector<std::size_t> open;
    for (const std::size_t index : pairs) {
      const ContactPair& pair = pairs_[index];
      bound_[index] = -kInfinity;
      if (pair.may_touch && window_.contains(part.begin_s, part.end_s)) continue;
      const double travel = travel_in(part, pair);
      const double value = distance(pair, clearance + kAhead * travel);
      bound_[index] = value - travel;
      const bool touching = pair.may_touch && window_.contains(part.middle_s, part.middle_s);
      if (!touching) clearance = std::min(clearance, value);
      const bool settled = value - travel >= clearance - kResolution_m;
      if (settled || !(travel > 0.1 * kResolution_m && travel < kHopeless_m)) continue;
      if (sweeps_left_ > 0) {
        open.push_back(index);
      } else {
        clearance = std::min(clearance, value - travel);
      }
    }
    if (open.empty()) return;
    --sweeps_left_;
    sweep(stretch(part.piece, part.s0, part.middle()), open, clearance);
    sweep(stretch(part.piece, part.middle(), part.s1), open, clearance);
  }

  /// All bodies are placed where they are at the middle.
  void take_middle(const Stretch& part) {
    curve_.position_at(part.piece, part.middle(), q_);
    take(q_, part.middle_s);
  }

  /// How much nearer a pair can come than at the middle.
  double travel_in(const Stretch& part, const ContactPair& pair) const {
    const bool target = pair.object && pair.other == carried_.object;
    const JointVector& lever = target && carried_.in_hand(part.middle_s)
                                   ? in_hand_lever_[static_cast<std::size_t>(pair.capsule)]
                                   : pair.lever;
    const double by_joints =
        part.half_s * curve_.speed.row(static_cast<Eigen::Index>(part.piece)).dot(lever);
    const bool still = target && part.middle_s >= carried_.begin_s;
    return !pair.object || still ? by_joints : by_joints + object_travel_in(part, pair);
  }

  /// Of the object alone, as it was recorded.
  double object_travel_in(const Stretch& part, const ContactPair& pair) const {
    const ObjectTravel& moved = travels_[static_cast<std::size_t>(pair.other)];
    if (moved.travelled.size() == 1) return 0;
    const double here = moved.at(part.middle_s);
    return std::max(here - moved.at(part.begin_s), moved.at(part.end_s) - here);
  }

  /// All along a stretch.
  double required_in(const ContactPair& pair, const Stretch& part) const {
    return required_distance(pair, pair.may_touch && window_.contains(part.begin_s, part.end_s));
  }

  double required_distance(const ContactPair& pair, bool touching) const {
    const Tolerances& allowed = plan_.tolerances;
    if (!touching) return allowed.margin;
    return -(pair.pad ? allowed.contact_depth : allowed.link_depth.value_or(allowed.contact_depth));
  }

  void take(const JointVector& q, double time_s) {
    frame_poses(robot_, q, now_.base_from_frame);
    now_.axes.resize(robot_.capsules.size());
    for (std::size_t i = 0; i < now_.axes.size(); ++i) {
      const RobotTable::Capsule& capsule = robot_.capsules[i];
      now_.axes[i] = {in_base(now_.base_from_frame, capsule.frame, capsule.from),
                      in_base(now_.base_from_frame, capsule.frame, capsule.to)};
    }
    now_.object_from_base.resize(plan_.scene.objects.size());
    for (std::size_t k = 0; k < now_.object_from_base.size(); ++k)
      now_.object_from_base[k] = recorded_pose(plan_.scene.objects[k], time_s).inverse();
    if (carried_.in_hand(time_s)) {
      now_.object_from_base[static_cast<std::size_t>(carried_.object)] =
          (now_.base_from_frame[static_cast<std::size_t>(carried_.frame)] *
           carried_.frame_from_object)
              .inverse();
    } else if (carried_.released(time_s)) {
      now_.object_from_base[static_cast<std::size_t>(carried_.object)] =
          carried_.base_from_released.inverse();
    }
  }

  /// Exact if below `enough`, else any lower bound that is at least `enough`.
  double distance(const ContactPair& pair, double enough) const {
    const Segment& axis = now_.axes[static_cast<std::size_t>(pair.capsule)];
    const auto other = static_cast<std::size_t>(pair.other);
    if (pair.object) {
      const Pose& object_from_base = now_.object_from_base[other];
      const Segment in_object{object_from_base * axis.from, object_from_base * axis.to};
      const SceneObject& object = plan_.scene.objects[other];
      const double reach = enough + pair.radii;
      return (object.shape == Shape::mesh ? segment_mesh_distance(meshes_[other], in_object, reach)
                                          : segment_solid_distance(object, in_object, reach)) -
             pair.radii;
    }
    const Segment& second = now_.axes[other];
    const double spheres = 0.5 * ((axis.from + axis.to - second.from - second.to).norm() -
                                  (axis.to - axis.from).norm() - (second.to - second.from).norm()) -
                           pair.radii;
    return spheres >= enough ? spheres : segment_distance(axis, second) - pair.radii;
  }

  CurvePoint place(std::size_t piece, double s) const {
    return {static_cast<int>(2 * piece + 1), static_cast<int>(s < 0.5 ? piece : piece + 1),
            curve_.time_at(piece, s)};
  }

  void note(const ContactPair& pair, const CurvePoint& place, double value, double required,
            double excess) {
    runs_.note(pair.object ? "object" : "self", pair.subject, place, value, required, excess);
  }

  const RobotTable& robot_;
  const Plan& plan_;
  const Curve& curve_;
  ViolationRuns& runs_;
  int halvings_left_ = kHalvings, sweeps_left_ = kHalvings;
  std::vector<ContactPair> pairs_;
  TouchWindow window_;
  std::vector<ObjectTravel> travels_;
  std::vector<Mesh> meshes_;  ///< [objects] empty where the object is none
  Carried carried_;
  std::vector<JointVector> in_hand_lever_;  ///< [capsules] relative to the carried target
  JointRows levers_;                        ///< [pairs, n] theirs
  JointVector by_joints_;                   ///< [pairs] fastest approach in the piece at hand [m/s]
  std::vector<double> bound_;  ///< [pairs] no nearer than this at the end of what was looked at [m]
  Snapshot now_;
  JointVector q_;
};

}  // namespace

double judge_contacts(const RobotTable& robot, const Plan& plan, const Curve& curve,
                      ViolationRuns& runs) {
  return ContactJudge(robot, plan, curve, runs).run();
}

}  // namespace morphe::verify
