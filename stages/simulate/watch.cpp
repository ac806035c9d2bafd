#include "stages/simulate/watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::simulate {
namespace {

constexpr double kAboutLine = 0.7;  ///< share of a turn from which on it is one about the fingers
/// At this share of what is allowed a motion shows how it began; what falls is off the fingers
/// later.
constexpr double kBegins = 0.25;

Pose palm_from_target(const physics::State& state, const Parts& parts) {
  return state.body(parts.palm_body).inverse() * state.body(parts.target_body);
}

void raise(const Way& way, Way& largest) {
  largest.distance_m = std::max(largest.distance_m, way.distance_m);
  largest.angle_deg = std::max(largest.angle_deg, way.angle_deg);
}

bool within(const Way& way, double distance_m, double angle_deg) {
  return way.distance_m < distance_m && way.angle_deg < angle_deg;
}

/// Of the two that press most against each other.
Vec3 line_between(const std::vector<Grip>& grips) {
  Vec3 line = Vec3::Zero();
  double most = 1;
  for (const Grip& a : grips) {
    for (const Grip& b : grips) {
      if (a.inward.dot(b.inward) >= most) continue;
      most = a.inward.dot(b.inward);
      line = a.point - b.point;
    }
  }
  return line.normalized();
}

}  // namespace

Parts::Parts(const physics::Model& model, const RobotTable& robot, bool lifts_base)
    : target_body(model.body("target")),
      target_geom(model.geom("target")),
      palm_body(model.body(fmt::format("f{}", robot.palm_frame))),
      base_motor(lifts_base ? model.actuator("base") : -1),
      capsule_of_geom(static_cast<std::size_t>(model.geom_count()), -1) {
  for (std::size_t f = 0; f < robot.frames.size(); ++f) {
    const std::string name = fmt::format("f{}", f);
    bodies.push_back(model.body(name));
    joints.push_back(robot.frames[f].joint >= 0 ? model.joint(name) : -1);
  }
  for (std::size_t j = 0; j < robot.joints(); ++j)
    motors.push_back(model.actuator(fmt::format("m{}", j)));
  for (std::size_t k = 0; k < robot.capsules.size(); ++k)
    capsule_of_geom[static_cast<std::size_t>(model.geom(fmt::format("c{}", k)))] =
        static_cast<int>(k);
}

std::vector<Grip> grips_of(const physics::State& state, const Parts& parts,
                           std::vector<physics::Touch>& touches) {
  state.touches(touches);
  std::vector<Grip> grips;
  for (const physics::Touch& touch : touches) {
    const bool target_first = touch.first == parts.target_geom;
    if (!target_first && touch.second != parts.target_geom) continue;
    const int capsule =
        parts.capsule_of_geom[static_cast<std::size_t>(target_first ? touch.second : touch.first)];
    if (capsule >= 0 && touch.force > 0)
      grips.push_back(
          {capsule, touch.point, target_first ? Vec3(-touch.normal) : touch.normal, touch.force});
  }
  return grips;
}

bool opposed(const std::vector<Grip>& grips) {
  for (const Grip& a : grips) {
    for (const Grip& b : grips) {
      if (a.inward.dot(b.inward) < 0) return true;
    }
  }
  return false;
}

Way way_between(const Pose& from, const Pose& to) {
  return {(to.translation() - from.translation()).norm(),
          angle_between(Quat(from.linear()), Quat(to.linear())) / kDegree};
}

Watch::Watch(const RobotTable& robot, const Parts& parts, const physics::State& squeezed)
    : robot_(robot), parts_(parts), start_(palm_from_target(squeezed, parts)) {
  grips_ = grips_of(squeezed, parts, touches_);
  const Pose base_from_palm = squeezed.body(parts.palm_body);
  finger_line_ = base_from_palm.linear().transpose() * line_between(grips_);
  const Pose target_from_base = squeezed.body(parts.target_body).inverse();
  for (const Grip& grip : grips_) {
    const int frame = robot.capsules[static_cast<std::size_t>(grip.capsule)].frame;
    if (frame < 0) continue;
    const Pose base_from_link = squeezed.body(parts.bodies[static_cast<std::size_t>(frame)]);
    pads_.push_back({frame, target_from_base * grip.point, base_from_link.inverse() * grip.point});
  }
}

void Watch::look(const physics::State& state, bool settled, bool at_limit) {
  const Pose now = palm_from_target(state, parts_);
  const Way way = way_between(start_, now);
  raise(way, holding_.largest);
  at_limit_ = at_limit;
  for (const Pad& pad : pads_) {
    const Pose link_from_target =
        state.body(parts_.bodies[static_cast<std::size_t>(pad.frame)]).inverse() *
        state.body(parts_.target_body);
    holding_.slip_m =
        std::max(holding_.slip_m, (link_from_target * pad.on_target - pad.on_finger).norm());
  }
  if (!settled_) holding_.sag = way;
  if (settled && !settled_) settled_ = now;
  if (settled) raise(way_between(*settled_, now), holding_.creep);
  grips_ = grips_of(state, parts_, touches_);
  if (began_ == Failure::none && !within(way, kBegins * kMotion_m, kBegins * kMotion_deg))
    began_ = cause(start_, now);
  if (!within(way, kMotion_m, kMotion_deg)) {
    holding_.failure = grips_.empty() ? began_ : cause(start_, now);
  } else if (!within(holding_.creep, kCreep_m, kCreep_deg)) {
    holding_.failure = cause(*settled_, now);
  }
}

/// By what moved most, in shares of what is allowed.
Failure Watch::cause(const Pose& from, const Pose& palm_from_target) const {
  if (at_limit_) return Failure::torque_limit;
  if (grips_.empty()) return Failure::lost;
  const Way way = way_between(from, palm_from_target);
  const Eigen::AngleAxisd turn(palm_from_target.linear() * from.linear().transpose());
  if (way.angle_deg / kMotion_deg > way.distance_m / kMotion_m) {
    return std::abs(turn.axis().dot(finger_line_)) >= kAboutLine ? Failure::pivot : Failure::roll;
  }
  return holding_.slip_m > 0.5 * way.distance_m ? Failure::slip : Failure::sag;
}

Holding Watch::verdict() const {
  Holding holding = holding_;
  if (holding.held() && !opposed(grips_)) holding.failure = Failure::lost;
  return holding;
}

}  // namespace morphe::simulate
