#include "stages/simulate/hold_monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stages/simulate/options.hpp"

namespace morphe::simulate {
namespace {

constexpr double kMinPivotCosine = 0.7;  ///< between a rotation's axis and the grasp axis
/// Share of the allowed motion at which its cause is determined. At the whole of it, a falling
/// target may have left the hand.
constexpr double kOnsetShare = 0.25;

bool is_within(const Displacement& displacement, double distance_m, double angle_deg) {
  return displacement.distance_m < distance_m && displacement.angle_deg < angle_deg;
}

/// Returns the direction between the two contacts whose forces are most opposed; zero without two.
Vec3 grasp_axis(const std::vector<TargetContact>& contacts) {
  Vec3 line = Vec3::Zero();
  double min_cosine = 1;
  for (const TargetContact& a : contacts) {
    for (const TargetContact& b : contacts) {
      if (a.inward.dot(b.inward) >= min_cosine) continue;
      min_cosine = a.inward.dot(b.inward);
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
  for (int f = 0; f < std::ssize(robot.frames); ++f) {
    const std::string name = fmt::format("f{}", f);
    bodies.push_back(model.body(name));
    joints.push_back(robot.frames[f].joint >= 0 ? model.joint(name) : -1);
  }
  for (int j = 0; j < std::ssize(robot.joint_names); ++j)
    motors.push_back(model.actuator(fmt::format("m{}", j)));
  for (int k = 0; k < std::ssize(robot.capsules); ++k)
    capsule_of_geom[model.geom(fmt::format("c{}", k))] = k;
}

std::vector<TargetContact> target_contacts(const physics::State& state, const ModelIds& parts,
                                           std::vector<physics::GeomContact>& touches) {
  state.contacts(touches);
  std::vector<TargetContact> contacts;
  for (const physics::GeomContact& pair : touches) {
    const bool target_first = pair.first == parts.target_geom;
    if (!target_first && pair.second != parts.target_geom) continue;
    const int capsule = parts.capsule_of_geom[target_first ? pair.second : pair.first];
    if (capsule >= 0 && pair.force > 0)
      contacts.push_back(
          {capsule, pair.point, target_first ? Vec3(-pair.normal) : pair.normal, pair.force});
  }
  return contacts;
}

bool has_opposing_contacts(const std::vector<TargetContact>& contacts) {
  for (const TargetContact& a : contacts)
    for (const TargetContact& b : contacts)
      if (a.inward.dot(b.inward) < 0) return true;
  return false;
}

void update_maximum(const Displacement& displacement, Displacement& maximum) {
  maximum.distance_m = std::max(maximum.distance_m, displacement.distance_m);
  maximum.angle_deg = std::max(maximum.angle_deg, displacement.angle_deg);
}

Pose palm_from_target(const physics::State& state, const ModelIds& parts) {
  return state.body(parts.palm_body).inverse() * state.body(parts.target_body);
}

Displacement displacement_between(const Pose& from, const Pose& to) {
  return {(to.translation() - from.translation()).norm(),
          angle_between(Quat(from.linear()), Quat(to.linear())) / kRadPerDegree};
}

HoldMonitor::HoldMonitor(const RobotModel& robot, const ModelIds& parts,
                         const physics::State& squeezed, bool limits_drift)
    : robot_(robot),
      parts_(parts),
      limits_drift_(limits_drift),
      start_(palm_from_target(squeezed, parts)) {
  contacts_ = target_contacts(squeezed, parts, touches_);
  const Pose base_from_palm = squeezed.body(parts.palm_body);
  grasp_axis_ = base_from_palm.linear().transpose() * grasp_axis(contacts_);
  const Pose target_from_base = squeezed.body(parts.target_body).inverse();
  for (const TargetContact& contact : contacts_) {
    const int frame = robot.capsules[contact.capsule].frame;
    if (frame < 0) continue;
    const Pose base_from_link = squeezed.body(parts.bodies[frame]);
    anchors_.push_back(
        {frame, target_from_base * contact.point, base_from_link.inverse() * contact.point});
  }
}

void HoldMonitor::update(const physics::State& state, bool settled, bool at_limit) {
  const Pose pose = palm_from_target(state, parts_);
  const Displacement displacement = displacement_between(start_, pose);
  update_maximum(displacement, result_.in_hand_displacement);
  at_limit_ = at_limit;
  for (const ContactAnchor& anchor : anchors_) {
    const Pose link_from_target =
        state.body(parts_.bodies[anchor.frame]).inverse() * state.body(parts_.target_body);
    result_.slip_m =
        std::max(result_.slip_m, (link_from_target * anchor.on_target - anchor.on_finger).norm());
  }
  if (!settled_) result_.droop = displacement;
  if (settled && !settled_) settled_ = pose;
  if (settled) update_maximum(displacement_between(*settled_, pose), result_.drift);
  contacts_ = target_contacts(state, parts_, touches_);
  if (first_cause_ == Failure::none &&
      !is_within(displacement, kOnsetShare * kMaxInHandDisplacement_m,
                 kOnsetShare * kMaxInHandDisplacement_deg))
    first_cause_ = classify_failure(start_, pose);
  if (!is_within(displacement, kMaxInHandDisplacement_m, kMaxInHandDisplacement_deg))
    result_.failure = contacts_.empty() ? first_cause_ : classify_failure(start_, pose);
  else if (limits_drift_ && !is_within(result_.drift, kMaxDrift_m, kMaxDrift_deg))
    result_.failure = classify_failure(*settled_, pose);
}

Failure HoldMonitor::classify_failure(const Pose& from, const Pose& palm_from_target) const {
  if (at_limit_) return Failure::torque_limit;
  if (contacts_.empty()) return Failure::contact_lost;
  const auto [distance_m, angle_deg] = displacement_between(from, palm_from_target);
  const Eigen::AngleAxisd turn(palm_from_target.linear() * from.linear().transpose());
  if (angle_deg / kMaxInHandDisplacement_deg > distance_m / kMaxInHandDisplacement_m) {
    const bool pivots = std::abs(turn.axis().dot(grasp_axis_)) >= kMinPivotCosine;
    return pivots ? Failure::pivot : Failure::roll;
  }
  return result_.slip_m > 0.5 * distance_m ? Failure::slip : Failure::droop;
}

HoldResult HoldMonitor::result() const {
  HoldResult result = result_;
  if (result.is_held() && !has_opposing_contacts(contacts_)) result.failure = Failure::contact_lost;
  return result;
}

}  // namespace morphe::simulate
