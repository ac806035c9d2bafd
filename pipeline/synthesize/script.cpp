#include "pipeline/synthesize/script.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/synthesize/waypoint_sampler.hpp"

namespace morphe::synthesize {
namespace {

MovementKind draw_kind(const KindWeights& w, math::RandomStream& random) {
  const double weights[] = {w.minimum_jerk, w.lognormal,          w.asymmetric, w.curved,
                            w.two_peaks,    w.pause_before_grasp, w.no_grasp};
  double sum = 0;
  for (const double weight : weights) sum += weight;
  double remainder = sum * random.uniform();
  int last = 0;  // rounding must not select a kind of weight 0
  for (int k = 0; k < 7; ++k) {
    if (weights[k] == 0) continue;
    last = k;
    remainder -= weights[k];
    if (remainder < 0) break;
  }
  return static_cast<MovementKind>(last);
}

SpeedProfile draw_profile(MovementKind kind, double begin_s, double duration_s,
                          math::RandomStream& random) {
  const double sigma = random.uniform(0.2, 0.35), peak = random.uniform(0.3, 0.45);
  if (kind == MovementKind::lognormal)
    return {SpeedProfileShape::lognormal, begin_s, duration_s, sigma};
  if (kind == MovementKind::asymmetric) return {SpeedProfileShape::beta, begin_s, duration_s, peak};
  return {SpeedProfileShape::minimum_jerk, begin_s, duration_s, 0};
}

/// Draws a unit vector perpendicular to a path, to its right, its left or upwards.
Vec3 random_perpendicular(const Vec3& path, math::RandomStream& random) {
  const Vec3 along = path.normalized();
  const Vec3 side = along.cross(Vec3::UnitZ()).normalized();
  const double angle = random.uniform(0, std::numbers::pi);
  return std::cos(angle) * side + std::sin(angle) * side.cross(along);
}

/// Returns true if no angle of the arm comes near a limit, at which it would have to stop abruptly.
bool within_human_limits(const Script& script, const Subject& subject) {
  constexpr double kStep_s = 0.02, kLimitMargin_rad = 0.05;
  const human::ArmLimits& limits = human::human_arm_limits();
  for (double t = 0; t < script.length_s; t += kStep_s) {
    const human::ArmAngles angles = arm_sample(subject, arm_state(script.motion, t)).angles;
    for (int k = 0; k < std::ssize(angles); ++k)
      if (angles[k] < limits.lower[k] + kLimitMargin_rad ||
          angles[k] > limits.upper[k] - kLimitMargin_rad)
        return false;
  }
  return true;
}
class ScriptGenerator {
 public:
  ScriptGenerator(const SynthesizeOptions& options, const Subject& subject,
                  math::RandomStream& random)
      : o_(options),
        m_(options.movements),
        subject_(subject),
        random_(random),
        places_(options.movements, subject, random) {
    script_.motion.arm.start = home_ = places_.draw_home();
    script_.motion.hand.start = hand_ = subject.postures.resting;
    script_.motion.drift = draw_drift(options.body, random);
    script_.motion.tremor = draw_tremor(options.body, random);
    arm_ = home_;
    target_ = places_.draw_target(home_);
    const double widest = aperture(subject.hand, subject.postures.open);
    const double max_radius =
        0.5 * (widest - options.hand.peak_aperture_excess[0]) - options.hand.pad_depth;
    script_.object_radius = std::min(random.uniform(options.object.radius), max_radius);
  }

  Script write() {
    const int count = random_.uniform_integer(m_.movements_per_recording);
    now_s_ = random_.uniform(m_.rest_s);
    for (int k = 0; k < count; ++k) {
      write_movement();
      now_s_ += random_.uniform(m_.rest_s);
    }
    script_.begin_s = 0;
    script_.end_s = script_.length_s = now_s_;
    const auto draw_s = [&](const ScriptedMovement& movement) {
      return random_.uniform(movement.phases.front().begin_s, movement.phases.back().end_s);
    };
    if (random_.bernoulli(m_.truncated_start_share))
      script_.begin_s = draw_s(script_.movements.front());
    if (random_.bernoulli(m_.truncated_end_share))
      script_.end_s = std::max(draw_s(script_.movements.back()), script_.begin_s + kMinRecording_s);
    return std::move(script_);
  }

 private:
  static constexpr double kMinRecording_s = 0.5;

  void write_movement() {
    ScriptedMovement& movement = script_.movements.emplace_back();
    movement.kind = draw_kind(m_.kinds, random_);
    movement.grasps = movement.kind != MovementKind::no_grasp;
    if (movement.grasps) {
      write_reach(movement, places_.perturb(target_, 0.004, 0.04));
      write_carrying(movement);
      write_return(movement, now_s_ + random_.uniform(0.08, 0.2));
    } else {
      write_touch(movement);
      write_return(movement, now_s_);
    }
  }

  void write_reach(ScriptedMovement& movement, const ArmState& target) {
    const double begin_s = now_s_;
    double duration_s = random_.uniform(m_.reach_s), opening_s = duration_s, closing_s = 0;
    const double peak_aperture_time = random_.uniform(o_.hand.peak_aperture_time);
    const ArmState delta = target - arm_;
    if (movement.kind == MovementKind::two_peaks) {
      const double first_s = random_.uniform(0.62, 0.72) * duration_s;
      const double second_s = begin_s + random_.uniform(0.5, 0.6) * duration_s;
      ArmState first = random_.uniform(0.75, 0.9) * delta;
      first.segment<3>(kWristPosition) +=
          random_.uniform(0.005, 0.02) *
          random_perpendicular(delta.segment<3>(kWristPosition), random_);
      move_arm({SpeedProfileShape::minimum_jerk, begin_s, first_s, 0}, first, 0);
      move_arm({SpeedProfileShape::minimum_jerk, second_s, begin_s + duration_s - second_s, 0},
               delta - first, 0);
    } else if (movement.kind == MovementKind::pause_before_grasp) {
      const double pause_s = random_.uniform(m_.pause_s), last_s = random_.uniform(0.3, 0.45);
      const ArmState first = random_.uniform(0.85, 0.95) * delta;
      move_arm({SpeedProfileShape::minimum_jerk, begin_s, duration_s, 0}, first, draw_detour_m());
      opening_s = duration_s;
      closing_s = begin_s + duration_s + pause_s;
      duration_s += pause_s + last_s;
      move_arm({SpeedProfileShape::minimum_jerk, closing_s, last_s, 0}, delta - first, 0);
    } else {
      const double aside =
          movement.kind == MovementKind::curved ? random_.uniform(0.05, 0.12) : draw_detour_m();
      move_arm(draw_profile(movement.kind, begin_s, duration_s, random_), delta, aside);
    }
    now_s_ = begin_s + duration_s;
    movement.phases.push_back({PhaseKind::reach, begin_s, now_s_});
    if (movement.grasps) {
      const double widest_s = begin_s + peak_aperture_time * opening_s;
      shape_hand(begin_s, widest_s, std::max(closing_s, widest_s));
    } else {
      move_hand(begin_s, now_s_, subject_.postures.pointing);
    }
  }

  /// Opens the hand until `widest_s`, and closes it on the object from `closing_s` until the arm
  /// has arrived at now_s_; both ends are late by the same lag.
  void shape_hand(double begin_s, double widest_s, double closing_s) {
    const double grasp_m = 2 * (script_.object_radius + o_.hand.pad_depth);
    const double peak_m = std::max(grasp_m + random_.uniform(o_.hand.peak_aperture_excess),
                                   aperture(subject_.hand, hand_) + o_.hand.min_aperture_increase);
    const double lag_s = random_.uniform(0, 0.05);
    move_hand(begin_s + lag_s, widest_s, posture(peak_m));
    move_hand(closing_s, now_s_ + lag_s, posture(grasp_m));
  }

  void write_carrying(ScriptedMovement& movement) {
    const ArmState put_down = arm_;
    now_s_ += random_.uniform(m_.grasp_s);
    movement.attach_s = now_s_;
    add_phase(movement, PhaseKind::transport, now_s_, random_.uniform(m_.transport_s),
              places_.draw_lift(arm_));
    now_s_ += random_.uniform(m_.hold_s);
    add_phase(movement, PhaseKind::transport, now_s_, random_.uniform(m_.transport_s), put_down);
    now_s_ += random_.uniform(m_.grasp_s);
    movement.release_s = now_s_;
    const double opened_m = aperture(subject_.hand, hand_) + random_.uniform(0.015, 0.03);
    move_hand(now_s_, now_s_ + random_.uniform(0.22, 0.35), posture(opened_m));
  }

  void write_touch(ScriptedMovement& movement) {
    write_reach(movement, places_.draw_target(home_));
    now_s_ += random_.uniform(m_.hold_s);
  }

  /// Adds the return, which begins at now_s_ with the release by the fingers; the arm sets out at
  /// `begin_s`.
  void write_return(ScriptedMovement& movement, double begin_s) {
    const double release_s = now_s_, duration_s = random_.uniform(m_.return_s);
    add_phase(movement, PhaseKind::return_phase, begin_s, duration_s,
              places_.perturb(home_, 0.006, 0.04));
    movement.phases.back().begin_s = release_s;
    move_hand(begin_s + 0.3 * duration_s, now_s_, subject_.postures.resting);
  }

  void add_phase(ScriptedMovement& movement, PhaseKind phase, double begin_s, double duration_s,
                 const ArmState& to) {
    move_arm(draw_profile(movement.kind, begin_s, duration_s, random_), to - arm_, draw_detour_m());
    now_s_ = begin_s + duration_s;
    movement.phases.push_back({phase, begin_s, now_s_});
  }

  double draw_detour_m() { return random_.uniform(0, 0.02); }

  void move_arm(const SpeedProfile& profile, const ArmState& delta, double detour_m) {
    ArmState aside = ArmState::Zero();
    aside.segment<3>(kWristPosition) =
        detour_m * random_perpendicular(delta.segment<3>(kWristPosition), random_);
    script_.motion.arm.steps.push_back({profile, delta, aside});
    arm_ += delta;
  }
  void move_hand(double begin_s, double end_s, const HandState& to) {
    script_.motion.hand.steps.push_back(
        {{SpeedProfileShape::minimum_jerk, begin_s, end_s - begin_s, 0},
         to - hand_,
         HandState::Zero()});
    hand_ = to;
  }
  HandState posture(double aperture_m) const {
    return posture_of_aperture(subject_.hand, subject_.postures, aperture_m);
  }

  const SynthesizeOptions& o_;
  const SyntheticMovements& m_;  ///< o_.movements
  const Subject& subject_;
  math::RandomStream& random_;
  WaypointSampler places_;
  Script script_;
  ArmState home_, target_;  ///< at rest, and at the object
  ArmState arm_;            ///< at the end of the script so far
  HandState hand_;          ///< at the end of the script so far
  double now_s_ = 0;        ///< end of the script so far
};

}  // namespace

Script draw_script(const SynthesizeOptions& options, const Subject& subject,
                   math::RandomStream& random) {
  constexpr int kMaxTries = 100;
  Script script = ScriptGenerator(options, subject, random).write();
  for (int k = 1; k < kMaxTries && !within_human_limits(script, subject); ++k)
    script = ScriptGenerator(options, subject, random).write();
  return script;
}

}  // namespace morphe::synthesize
