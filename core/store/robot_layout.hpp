#pragma once

#include "core/motion/robot_model.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// Lays out /robot of docs/formats.md.
template <class Io, class T>
void lay_out_robot(Io& io, T& robot) {
  io.attribute("name", robot.name);
  io.attribute("shoulder_frame", robot.shoulder_frame);
  io.attribute("palm_frame", robot.palm_frame);
  io.optional_attribute("side", robot.side);
  io.names("joint_names", robot.joint_names);
  io.dataset("lower", robot.lower, joint_attributes());
  io.dataset("upper", robot.upper, joint_attributes());
  io.dataset("velocity", robot.velocity, joint_attributes("/s"));
  io.dataset("acceleration", robot.acceleration, joint_attributes("/s^2"));
  io.dataset("jerk", robot.jerk, joint_attributes("/s^3"));
  io.group("frames", [&](Io& in) {
    using Frame = RobotModel::Frame;
    in.column("name", robot.frames, &Frame::name, {});
    in.column("parent", robot.frames, &Frame::parent, {"1", "", ""});
    in.column("transform", robot.frames, &Frame::transform, {"m", "parent", ""});
    in.column("axis", robot.frames, &Frame::axis, {"1", "joint", ""});
    in.column("joint", robot.frames, &Frame::joint, {"1", "", ""});
    in.column("ratio", robot.frames, &Frame::ratio, {"1", "", ""});
    in.column("offset", robot.frames, &Frame::offset, joint_attributes());
    in.column_if(robot.has_prismatic_joint(), "prismatic", robot.frames, &Frame::prismatic,
                 {"1", "", "0=revolute,1=prismatic"});
  });
  io.group_if(!robot.coupled_limits.empty(), "coupled_limits", [&](Io& in) {
    using Limit = RobotModel::CoupledLimit;
    in.column("frame", robot.coupled_limits, &Limit::frame, {"1", "", ""});
    in.column("lower", robot.coupled_limits, &Limit::lower, joint_attributes());
    in.column("upper", robot.coupled_limits, &Limit::upper, joint_attributes());
    in.column("velocity", robot.coupled_limits, &Limit::velocity, joint_attributes("/s"));
    in.column("acceleration", robot.coupled_limits, &Limit::acceleration, joint_attributes("/s^2"));
    in.column("jerk", robot.coupled_limits, &Limit::jerk, joint_attributes("/s^3"));
  });
  io.group_if(!robot.braking_curves.empty(), "braking_curves", [&](Io& in) {
    using Curve = RobotModel::BrakingCurve;
    in.column("joint", robot.braking_curves, &Curve::joint, {"1", "", ""});
    in.column("twice_deceleration", robot.braking_curves, &Curve::twice_deceleration,
              joint_attributes("/s^2"));
    in.column("velocity_offset", robot.braking_curves, &Curve::velocity_offset,
              joint_attributes("/s"));
    in.column("lower_end", robot.braking_curves, &Curve::lower_end, joint_attributes());
    in.column("upper_end", robot.braking_curves, &Curve::upper_end, joint_attributes());
  });
  io.group("tips", [&](Io& in) {
    using Tip = RobotModel::Tip;
    in.column("name", robot.tips, &Tip::name, {});
    in.column("frame", robot.tips, &Tip::frame, {"1", "", ""});
    in.column("transform", robot.tips, &Tip::transform, {"m", "joint", ""});
    in.column("finger", robot.tips, &Tip::finger,
              {"1", "", "-1=wrist,0=thumb,1=index,2=middle,3=ring,4=little"});
    in.column("finger_curve_share", robot.tips, &Tip::finger_curve_share, {"1", "", ""});
  });
  io.group("joint_centres", [&](Io& in) {
    using Centre = RobotModel::JointCentre;
    in.column("frame", robot.joint_centres, &Centre::frame, {"1", "", ""});
    in.column("chain", robot.joint_centres, &Centre::chain, {});
  });
  io.group("capsules", [&](Io& in) {
    using Capsule = RobotModel::Capsule;
    in.column("name", robot.capsules, &Capsule::name, {});
    in.column("frame", robot.capsules, &Capsule::frame, {"1", "", ""});
    in.column("from", robot.capsules, &Capsule::from, {"m", "joint", ""});
    in.column("to", robot.capsules, &Capsule::to, {"m", "joint", ""});
    in.column("radius", robot.capsules, &Capsule::radius, {"m", "", ""});
    in.column("may_touch_target", robot.capsules, &Capsule::may_touch_target,
              {"1", "", "0=no,1=yes"});
  });
  io.dataset("allowed_collision_pairs", robot.allowed_collision_pairs, {"1", "", ""});
  io.optional_names("unchecked_links", robot.unchecked_links);
}

}  // namespace morphe::store
