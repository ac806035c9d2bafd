#pragma once

#include "core/motion/robot_table.hpp"
#include "core/store/layout.hpp"

namespace morphe::store {

/// /robot of docs/formats.md.
template <class Io, class T>
void lay_out_robot(Io& io, T& robot) {
  io.attribute("name", robot.name);
  io.attribute("shoulder_frame", robot.shoulder_frame);
  io.attribute("palm_frame", robot.palm_frame);
  io.maybe("side", robot.side);
  io.names("joint_names", robot.joint_names);
  io.dataset("lower", robot.lower, of_joints());
  io.dataset("upper", robot.upper, of_joints());
  io.dataset("velocity", robot.velocity, of_joints("/s"));
  io.dataset("acceleration", robot.acceleration, of_joints("/s^2"));
  io.dataset("jerk", robot.jerk, of_joints("/s^3"));
  io.group("frames", [&](Io& in) {
    using Frame = RobotTable::Frame;
    in.column("name", robot.frames, &Frame::name, {});
    in.column("parent", robot.frames, &Frame::parent, {"1", "", ""});
    in.column("transform", robot.frames, &Frame::transform, {"m", "parent", ""});
    in.column("axis", robot.frames, &Frame::axis, {"1", "joint", ""});
    in.column("joint", robot.frames, &Frame::joint, {"1", "", ""});
    in.column("ratio", robot.frames, &Frame::ratio, {"1", "", ""});
    in.column("offset", robot.frames, &Frame::offset, of_joints());
    in.column_if(robot.some_slide(), "slides", robot.frames, &Frame::slides,
                 {"1", "", "0=turns,1=slides"});
  });
  io.group_if(!robot.coupled_limits.empty(), "coupled_limits", [&](Io& in) {
    using Limit = RobotTable::CoupledLimit;
    in.column("frame", robot.coupled_limits, &Limit::frame, {"1", "", ""});
    in.column("lower", robot.coupled_limits, &Limit::lower, of_joints());
    in.column("upper", robot.coupled_limits, &Limit::upper, of_joints());
    in.column("velocity", robot.coupled_limits, &Limit::velocity, of_joints("/s"));
    in.column("acceleration", robot.coupled_limits, &Limit::acceleration, of_joints("/s^2"));
    in.column("jerk", robot.coupled_limits, &Limit::jerk, of_joints("/s^3"));
  });
  io.group_if(!robot.braking_curves.empty(), "braking_curves", [&](Io& in) {
    using Curve = RobotTable::BrakingCurve;
    in.column("joint", robot.braking_curves, &Curve::joint, {"1", "", ""});
    in.column("slope", robot.braking_curves, &Curve::slope, of_joints("/s^2"));
    in.column("drop", robot.braking_curves, &Curve::drop, of_joints("/s"));
    in.column("lower_end", robot.braking_curves, &Curve::lower_end, of_joints());
    in.column("upper_end", robot.braking_curves, &Curve::upper_end, of_joints());
  });
  io.group("tips", [&](Io& in) {
    using Tip = RobotTable::Tip;
    in.column("name", robot.tips, &Tip::name, {});
    in.column("frame", robot.tips, &Tip::frame, {"1", "", ""});
    in.column("transform", robot.tips, &Tip::transform, {"m", "joint", ""});
    in.column("finger", robot.tips, &Tip::finger,
              {"1", "", "-1=wrist,0=thumb,1=index,2=middle,3=ring,4=little"});
    in.column("along", robot.tips, &Tip::along, {"1", "", ""});
  });
  io.group("centres", [&](Io& in) {
    using Centre = RobotTable::Centre;
    in.column("frame", robot.centres, &Centre::frame, {"1", "", ""});
    in.column("chain", robot.centres, &Centre::chain, {});
  });
  io.group("capsules", [&](Io& in) {
    using Capsule = RobotTable::Capsule;
    in.column("name", robot.capsules, &Capsule::name, {});
    in.column("frame", robot.capsules, &Capsule::frame, {"1", "", ""});
    in.column("from", robot.capsules, &Capsule::from, {"m", "joint", ""});
    in.column("to", robot.capsules, &Capsule::to, {"m", "joint", ""});
    in.column("radius", robot.capsules, &Capsule::radius, {"m", "", ""});
    in.column("may_touch_target", robot.capsules, &Capsule::may_touch_target,
              {"1", "", "0=no,1=yes"});
  });
  io.dataset("allowed_pairs", robot.allowed_pairs, {"1", "", ""});
  io.names_if_any("unchecked_links", robot.unchecked_links);
}

}  // namespace morphe::store
