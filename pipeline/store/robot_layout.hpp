#pragma once

#include "pipeline/motion/robot_table.hpp"
#include "pipeline/store/layout.hpp"

namespace morphe::store {

/// /robot of docs/formats.md.
template <class Io, class T>
void lay_out_robot(Io& io, T& robot) {
  io.attribute("name", robot.name);
  io.attribute("shoulder_frame", robot.shoulder_frame);
  io.attribute("palm_frame", robot.palm_frame);
  io.names("joint_names", robot.joint_names);
  io.dataset("lower", robot.lower, {"rad", "", ""});
  io.dataset("upper", robot.upper, {"rad", "", ""});
  io.dataset("velocity", robot.velocity, {"rad/s", "", ""});
  io.dataset("acceleration", robot.acceleration, {"rad/s^2", "", ""});
  io.dataset("jerk", robot.jerk, {"rad/s^3", "", ""});
  io.group("frames", [&](Io& in) {
    using Frame = RobotTable::Frame;
    in.column("name", robot.frames, &Frame::name, {});
    in.column("parent", robot.frames, &Frame::parent, {"1", "", ""});
    in.column("transform", robot.frames, &Frame::transform, {"m", "parent", ""});
    in.column("axis", robot.frames, &Frame::axis, {"1", "joint", ""});
    in.column("joint", robot.frames, &Frame::joint, {"1", "", ""});
    in.column("ratio", robot.frames, &Frame::ratio, {"1", "", ""});
    in.column("offset", robot.frames, &Frame::offset, {"rad", "", ""});
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
}

}  // namespace morphe::store
