#include "stages/verify/contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stages/verify/carried_object.hpp"
#include "stages/verify/closest_pairs.hpp"
#include "stages/verify/frame_poses.hpp"
#include "stages/verify/object_travel.hpp"
#include "stages/verify/pair_distance.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {
namespace {

constexpr double kDistanceTolerance_m = 1e-6;
/// Intervals that are still undecided when no body travels farther than this count as violations.
/// This is less than the 0.1 mm of planning, so that no clearance that planning proved with other
/// intervals is left undecided.
constexpr double kMinContactTravel_m = 1e-5;
/// Resolution of the least clearance along the whole curve.
constexpr double kClearanceResolution_m = 1e-5;
/// Undecided intervals with at least this travel count as violations and are not bisected.
constexpr double kMaxContactTravel_m = 10;
/// The maximum number of bisections for a proof: ten metres at every 0.01 mm. Intervals that are
/// undecided after these count as violations. The search for the least clearance may bisect as
/// often, and takes its lower bound for intervals that are undecided then.
constexpr int kMaxContactBisections = 1000000;
/// Distances are evaluated exactly up to the required one plus this multiple of the travel in the
/// interval, so that the next pieces can skip the pair.
constexpr double kLookaheadRatio = 8;

class ContactVerifier {
 public:
  ContactVerifier(const RobotModel& robot, const Plan& plan, const Curve& curve,
                  ViolationLog& violations)
      : plan_(plan), curve_(curve), violations_(violations), bodies_(robot, plan) {
    pairs_ = contact_pairs(robot, plan);
    bound_.assign(pairs_.size(), -kInfinity);
    window_ = touch_window(plan.movement.phases);
    for (const SceneObject& object : plan.scene.objects)
      object_travels_.push_back(object_travel(object));
    motion_bounds_.resize(pairs_.size(), robot.lower.size());
    for (int i = 0; i < std::ssize(pairs_); ++i) motion_bounds_.row(i) = pairs_[i].motion_bound;
    const AttachedObject& attached = bodies_.attached();
    carried_ = verify_carried_object(robot, plan, curve, bodies_.meshes(), attached, violations);
    for (const ContactPair& pair : pairs_)
      kinds_.push_back({pair.is_object, pair.may_touch, is_attached_target(pair),
                        static_cast<int>(kind_of_pair(plan, pair))});
    if (attached.object < 0) return;
    const double radius = bounding_radius(plan.scene.objects[attached.object]);
    const Vec3 centre = attached.frame_from_object.translation();
    for (int i = 0; i < std::ssize(robot.capsules); ++i)
      attached_motion_bounds_.push_back(
          relative_motion_bound(robot, i, attached.frame, centre, radius));
  }

  ClearanceByKind run() {
    ClearanceByKind clearance = no_clearance();
    verify_sample(0, clearance);
    for (int piece = 0; piece < curve_.pieces; ++piece) {
      const PieceInterval whole = make_interval(piece, 0, 1);
      verify_interval(whole, candidate_pairs(whole, clearance));
      verify_sample(piece + 1, clearance);
    }
    for (auto first = near_pairs_.begin(); first != near_pairs_.end();) {
      const int piece = first->piece;
      std::vector<int> near;
      for (; first != near_pairs_.end() && first->piece == piece; ++first) {
        const PairKind& kind = kinds_[first->index];
        if (!(first->bound >= clearance[kind.clearance]) || kind.is_attached_target)
          near.push_back(first->index);
      }
      refine_clearance(make_interval(piece, 0, 1), near, clearance);
    }
    for (int k = 0; k < kClearanceKindCount; ++k)
      clearance[k] = std::min(clearance[k], carried_.along_curve[k]);
    if (curve_.trajectory == &plan_.trajectory)
      verify_closest_pairs(plan_, curve_, pairs_, bodies_, violations_);
    return clearance;
  }

 private:
  void verify_sample(int sample, ClearanceByKind& clearance) {
    const Trajectory& trajectory = *curve_.trajectory;
    const double time_s = trajectory.demonstration_time[sample];
    const CurvePoint point = point_at_sample(trajectory, sample);
    const double stored = trajectory.clearance[sample];
    // Without a stored clearance, the least distance itself is computed.
    const double limit = std::isfinite(stored) ? stored + kStoredClearanceTolerance_m : kInfinity;
    double least = carried_.at_samples[sample];
    bool poses_updated = false;
    const bool in_window = window_.contains(time_s, time_s);
    for (int i = 0; i < std::ssize(pairs_); ++i) {
      const ContactPair& pair = pairs_[i];
      const bool touching = in_window && kinds_[i].may_touch;
      const double required = required_distance(pair, touching);
      const double enough =
          touching ? required
                   : std::max({required, clearance[kinds_[i].clearance], std::min(limit, least)});
      if (!is_known_clear(i, enough)) {
        if (!std::exchange(poses_updated, true))
          bodies_.move_to(trajectory.position.row(sample).transpose(), time_s);
        bound_[i] = bodies_.distance(pair, enough);
        if (!(bound_[i] >= required - kDistanceTolerance_m)) note(pair, point, bound_[i], required);
      }
      if (touching) continue;
      least = std::min(least, bound_[i]);
      double& of_kind = clearance[kinds_[i].clearance];
      of_kind = std::min(of_kind, bound_[i]);
    }
    const bool none = least == kInfinity;
    if (none ? std::isnan(stored) : std::abs(stored - least) <= kStoredClearanceTolerance_m) return;
    violations_.note("clearance", "trajectory", point, stored, none ? kUnknown : least,
                     std::abs(stored - least));
  }

  /// A part of a piece, s in [s0, s1], with its demonstration times and half its duration.
  struct PieceInterval {
    int piece = 0;
    double s0 = 0, s1 = 1, middle = 0.5;
    double begin_s = 0, middle_s = 0, end_s = 0, half_s = 0;
  };

  PieceInterval make_interval(int piece, double s0, double s1) const {
    const std::vector<double>& time = curve_.trajectory->time;
    const double middle = 0.5 * (s0 + s1);
    const double half_s = 0.5 * (s1 - s0) * (time[piece + 1] - time[piece]);
    const auto at = [&](double s) { return curve_.demonstration_time_at(piece, s); };
    return {piece, s0, s1, middle, at(s0), at(middle), at(s1), half_s};
  }

  bool is_attached_target(const ContactPair& pair) const {
    return pair.is_object && pair.other == bodies_.attached().object;
  }

  bool may_touch_in(const ContactPair& pair, double begin_s, double end_s) const {
    return pair.may_touch && window_.contains(begin_s, end_s);
  }

  /// Returns true if a pair's previous distance bound is at least `enough`. For the target, if it
  /// is attached, no bound is used: its pose may jump when the hand attaches or releases it.
  bool is_known_clear(int index, double enough) const {
    return bound_[index] >= enough && !kinds_[index].is_attached_target;
  }

  /// Lowers the distance bounds of all pairs by their greatest travel in a whole piece. Returns the
  /// pairs that may then come closer than required, and keeps those that may come closer than the
  /// `clearance` of their kind, the least distance at the samples so far: others cannot lower it.
  std::vector<int> candidate_pairs(const PieceInterval& whole, const ClearanceByKind& clearance) {
    approach_speed_.noalias() = motion_bounds_ * curve_.speed.row(whole.piece).transpose();
    std::vector<int> candidates;
    for (int i = 0; i < std::ssize(pairs_); ++i) {
      double travel = whole.half_s * approach_speed_[i];
      if (kinds_[i].is_object) travel += max_object_travel(whole, pairs_[i]);
      bound_[i] -= 2 * travel;
      const double required = kinds_[i].may_touch ? required_clearance_in(pairs_[i], whole)
                                                  : plan_.tolerances.required_clearance;
      if (!is_known_clear(i, required)) candidates.push_back(i);
      if (!is_known_clear(i, clearance[kinds_[i].clearance]))
        near_pairs_.push_back({whole.piece, i, bound_[i]});
    }
    return candidates;
  }

  /// Proves that the pairs are clear in an interval, bisecting it for those that are undecided.
  void verify_interval(const PieceInterval& part, const std::vector<int>& pairs) {
    if (pairs.empty()) return;
    update_poses_at_middle(part);
    std::vector<int> undecided;
    for (const int index : pairs) {
      const ContactPair& pair = pairs_[index];
      const double travel = max_travel(part, pair);
      const double required = required_clearance_in(pair, part);
      const double required_at_middle =
          required_distance(pair, may_touch_in(pair, part.middle_s, part.middle_s));
      const double value = bodies_.distance(pair, required + kLookaheadRatio * travel);
      bound_[index] = value - travel;
      if (value >= required + travel - kDistanceTolerance_m) continue;
      const bool violated = !(value >= required_at_middle - kDistanceTolerance_m);
      if (!violated && travel > kMinContactTravel_m && travel < kMaxContactTravel_m &&
          bisections_left_ > 0) {
        undecided.push_back(index);
      } else {
        note(pair, curve_.point_at(part.piece, part.middle), value,
             violated ? required_at_middle : required);
      }
    }
    if (undecided.empty()) return;
    --bisections_left_;
    verify_interval(make_interval(part.piece, part.s0, part.middle), undecided);
    verify_interval(make_interval(part.piece, part.middle, part.s1), undecided);
  }

  /// Lowers the clearances to the least distances of the pairs in an interval, at times at which
  /// they may not touch. May miss a distance that is smaller by less than the resolution.
  void refine_clearance(const PieceInterval& part, const std::vector<int>& pairs,
                        ClearanceByKind& clearances) {
    if (pairs.empty()) return;
    update_poses_at_middle(part);
    std::vector<int> undecided;
    for (const int index : pairs) {
      const ContactPair& pair = pairs_[index];
      if (may_touch_in(pair, part.begin_s, part.end_s)) continue;
      double& clearance = clearances[kinds_[index].clearance];
      const double travel = max_travel(part, pair);
      const double value = bodies_.distance(pair, clearance + kLookaheadRatio * travel);
      if (!may_touch_in(pair, part.middle_s, part.middle_s)) clearance = std::min(clearance, value);
      if (value - travel >= clearance - kClearanceResolution_m ||
          !(travel > 0.1 * kClearanceResolution_m && travel < kMaxContactTravel_m))
        continue;
      if (clearance_bisections_left_ > 0) {
        undecided.push_back(index);
      } else {
        clearance = std::min(clearance, value - travel);
      }
    }
    if (undecided.empty()) return;
    --clearance_bisections_left_;
    refine_clearance(make_interval(part.piece, part.s0, part.middle), undecided, clearances);
    refine_clearance(make_interval(part.piece, part.middle, part.s1), undecided, clearances);
  }

  void update_poses_at_middle(const PieceInterval& part) {
    curve_.position_at(part.piece, part.middle, q_);
    bodies_.move_to(q_, part.middle_s);
  }

  /// Returns by how much a pair's distance may be less anywhere in an interval than at its middle.
  double max_travel(const PieceInterval& part, const ContactPair& pair) const {
    const bool target = is_attached_target(pair);
    const JointVector& lever = target && bodies_.attached().is_attached(part.middle_s)
                                   ? attached_motion_bounds_[pair.capsule]
                                   : pair.motion_bound;
    const double travel = part.half_s * curve_.speed.row(part.piece).dot(lever);
    const bool off_recording = target && part.middle_s >= bodies_.attached().attach_s;
    return !pair.is_object || off_recording ? travel : travel + max_object_travel(part, pair);
  }

  /// Returns the greatest travel of the object alone, along its recorded poses.
  double max_object_travel(const PieceInterval& part, const ContactPair& pair) const {
    const ObjectTravel& travel = object_travels_[pair.other];
    if (travel.travelled.size() == 1) return 0;
    const double middle = travel.until(part.middle_s);
    return std::max(middle - travel.until(part.begin_s), travel.until(part.end_s) - middle);
  }

  /// Returns the clearance required along a whole interval.
  double required_clearance_in(const ContactPair& pair, const PieceInterval& part) const {
    return required_distance(pair, may_touch_in(pair, part.begin_s, part.end_s));
  }

  double required_distance(const ContactPair& pair, bool touching) const {
    const Tolerances& allowed = plan_.tolerances;
    if (!touching) return allowed.required_clearance;
    return -(pair.is_pad ? allowed.max_penetration
                         : allowed.max_link_penetration.value_or(allowed.max_penetration));
  }

  void note(const ContactPair& pair, const CurvePoint& point, double value, double required) {
    violations_.note(pair.is_object ? "object_collision" : "self_collision", pair.subject, point,
                     value, required, required - value);
  }

  const Plan& plan_;
  const Curve& curve_;
  ViolationLog& violations_;
  BodyDistances bodies_;
  int bisections_left_ = kMaxContactBisections, clearance_bisections_left_ = kMaxContactBisections;
  /// The properties of a pair that are asked for in every piece, apart from its others: these fit
  /// into the cache.
  struct PairKind {
    bool is_object = false, may_touch = false, is_attached_target = false;
    int clearance = 0;  ///< ClearanceKind
  };
  std::vector<ContactPair> pairs_;
  std::vector<PairKind> kinds_;  ///< [pairs]
  TouchWindow window_;
  std::vector<ObjectTravel> object_travels_;
  CarriedClearance carried_;
  std::vector<JointVector> attached_motion_bounds_;  ///< [capsules] relative to the attached target
  JointRows motion_bounds_;                          ///< [pairs, n] motion bounds of the pairs
  JointVector approach_speed_;  ///< [pairs] greatest in the current piece, of the joints [m/s]
  /// [pairs] lower bound of the distance at the end of the last evaluated interval [m]
  std::vector<double> bound_;
  /// A pair that may come closer than the clearance in a piece, with its bound there [m].
  struct NearPair {
    int piece = 0, index = 0;
    double bound = 0;
  };
  std::vector<NearPair> near_pairs_;  ///< in the order of the pieces
  JointVector q_;
};

}  // namespace

ClearanceByKind verify_contacts(const RobotModel& robot, const Plan& plan, const Curve& curve,
                                ViolationLog& violations) {
  return ContactVerifier(robot, plan, curve, violations).run();
}

}  // namespace morphe::verify
