#include "stages/simulate/hold_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace morphe::simulate {
namespace {

/// share of the rotation axis above which it is a rotation about the grasp axis
constexpr double kMinPivotCosine = 0.7;
/// Share of the allowed motion at which its cause is determined; a target that falls leaves the
/// fingers later.
constexpr double kOnsetShare = 0.25;

Pose palm_from_target(const physics::State& state, const ModelIds& parts) {
  return state.body(parts.palm_body).inverse() * state.body(parts.target_body);
}

void update_maximum(const Displacement& way, Displacement& largest) {
  largest.distance_m = std::max(largest.distance_m, way.distance_m);
  largest.angle_deg = std::max(largest.angle_deg, way.angle_deg);
}

bool is_within(const Displacement& way, double distance_m, double angle_deg) {
  return way.distance_m < distance_m && way.angle_deg < angle_deg;
}

/// Returns the line between the two contacts that press most against each other.
Vec3 grasp_axis(const std::vector<TargetContact>& grips) {
  Vec3 line = Vec3::Zero();
  double most = 1;
  for (const TargetContact& a : grips) {
    for (const TargetContact& b : grips) {
      if (a.inward.dot(b.inward) >= most) continue;
      most = a.inward.dot(b.inward);
      line = a.point - b.point;
    }
  }
  return line.normalized();
}

}  // namespace

ModelIds::ModelIds(const physics::Model& model, const RobotModel& robot, bool lifts_base)
    : target_body(model.body("target")),
      target_geom(model.geom("target")),
      palm_body(model.body(fmt::format("f{}", robot.palm_frame))),
      base_motor(lifts_base ? model.actuator("base") : -1),
      capsule_of_geom(model.geom_count(), -1) {
  for (std::size_t f = 0; f < robot.frames.size(); ++f) {
    const std::string name = fmt::format("f{}", f);
    bodies.push_back(model.body(name));
    joints.push_back(robot.frames[f].joint >= 0 ? model.joint(name) : -1);
  }
  for (std::size_t j = 0; j < robot.joints(); ++j)
    motors.push_back(model.actuator(fmt::format("m{}", j)));
  for (std::size_t k = 0; k < robot.capsules.size(); ++k)
    capsule_of_geom[model.geom(fmt::format("c{}", k))] = static_cast<int>(k);
}

std::vector<TargetContact> target_contacts(const physics::State& state, const ModelIds& parts,
                                           std::vector<physics::GeomContact>& touches) {
  state.contacts(touches);
  std::vector<TargetContact> grips;
  for (const physics::GeomContact& touch : touches) {
    const bool target_first = touch.first == parts.target_geom;
    if (!target_first && touch.second != parts.target_geom) continue;
    const int capsule = parts.capsule_of_geom[target_first ? touch.second : touch.first];
    if (capsule >= 0 && touch.force > 0)
      grips.push_back(
          {capsule, touch.point, target_first ? Vec3(-touch.normal) : touch.normal, touch.force});
  }
  return grips;
}

bool has_opposing_contacts(const std::vector<TargetContact>& grips) {
  for (const TargetContact& a : grips) {
    for (const TargetContact& b : grips) {
      if (a.inward.dot(b.inward) < 0) return true;
    }
  }
  return false;
}

Displacement displacement_between(const Pose& from, const Pose& to) {
  return {(to.translation() - from.translation()).norm(),
          angle_between(Quat(from.linear()), Quat(to.linear())) / kRadPerDegree};
}

HoldMonitor::HoldMonitor(const RobotModel& robot, const ModelIds& parts,
                         const physics::State& squeezed)
    : robot_(robot), parts_(parts), start_(palm_from_target(squeezed, parts)) {
  contacts_ = target_contacts(squeezed, parts, touches_);
  const Pose base_from_palm = squeezed.body(parts.palm_body);
  grasp_axis_ = base_from_palm.linear().transpose() * grasp_axis(contacts_);
  const Pose target_from_base = squeezed.body(parts.target_body).inverse();
  for (const TargetContact& grip : contacts_) {
    const int frame = robot.capsules[grip.capsule].frame;
    if (frame < 0) continue;
    const Pose base_from_link = squeezed.body(parts.bodies[frame]);
    anchors_.push_back(
        {frame, target_from_base * grip.point, base_from_link.inverse() * grip.point});
  }
}

void HoldMonitor::update(const physics::State& state, bool settled, bool at_limit) {
  const Pose now = palm_from_target(state, parts_);
  const Displacement way = displacement_between(start_, now);
  update_maximum(way, holding_.in_hand_displacement);
  at_limit_ = at_limit;
  for (const ContactAnchor& pad : anchors_) {
    const Pose link_from_target =
        state.body(parts_.bodies[pad.frame]).inverse() * state.body(parts_.target_body);
    holding_.slip_m =
        std::max(holding_.slip_m, (link_from_target * pad.on_target - pad.on_finger).norm());
  }
  if (!settled_) holding_.droop = way;
  if (settled && !settled_) settled_ = now;
  if (settled) update_maximum(displacement_between(*settled_, now), holding_.drift);
  contacts_ = target_contacts(state, parts_, touches_);
  if (first_cause_ == Failure::none && !is_within(way, kOnsetShare * kMaxInHandDisplacement_m,
                                                  kOnsetShare * kMaxInHandDisplacement_deg))
    first_cause_ = classify_failure(start_, now);
  if (!is_within(way, kMaxInHandDisplacement_m, kMaxInHandDisplacement_deg)) {
    holding_.failure = contacts_.empty() ? first_cause_ : classify_failure(start_, now);
  } else if (!is_within(holding_.drift, kMaxDrift_m, kMaxDrift_deg)) {
    holding_.failure = classify_failure(*settled_, now);
  }
}

/// Classifies by the motion that is largest relative to its limit.
Failure HoldMonitor::classify_failure(const Pose& from, const Pose& palm_from_target) const {
  if (at_limit_) return Failure::torque_limit;
  if (contacts_.empty()) return Failure::contact_lost;
  const Displacement way = displacement_between(from, palm_from_target);
  const Eigen::AngleAxisd turn(palm_from_target.linear() * from.linear().transpose());
  if (way.angle_deg / kMaxInHandDisplacement_deg > way.distance_m / kMaxInHandDisplacement_m) {
    return std::abs(turn.axis().dot(grasp_axis_)) >= kMinPivotCosine ? Failure::pivot
                                                                     : Failure::roll;
  }
  return holding_.slip_m > 0.5 * way.distance_m ? Failure::slip : Failure::droop;
}

HoldResult HoldMonitor::result() const {
  HoldResult holding = holding_;
  if (holding.is_held() && !has_opposing_contacts(contacts_))
    holding.failure = Failure::contact_lost;
  return holding;
}

}  // namespace morphe::simulate
