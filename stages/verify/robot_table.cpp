#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "stages/verify/requirements.hpp"

namespace morphe::verify {
namespace {

/// A column of a table: its numbers, and its names concatenated.
struct Column {
  const char* name;
  std::vector<double> numbers;
  std::string names;
};

template <class Rows, class Row>
Column column(const char* name, const Rows& rows, const Row& row) {
  Column out{name, {}, {}};
  for (const auto& one : rows) row(out, one);
  return out;
}

void add(Column& out, const std::string& name) { out.names += name + '\n'; }
void add(Column& out, double number) { out.numbers.push_back(number); }
void add(Column& out, const Vec3& point) {
  out.numbers.insert(out.numbers.end(), point.data(), point.data() + 3);
}
void add(Column& out, const Pose& pose) {
  out.numbers.insert(out.numbers.end(), pose.matrix().data(), pose.matrix().data() + 16);
}

/// Returns the column of a data member of all rows.
template <class Rows, class Value, class Row>
Column member(const char* name, const Rows& rows, Value Row::*value) {
  return column(name, rows, [&](Column& out, const Row& row) { add(out, row.*value); });
}

std::vector<Column> columns_of(const RobotModel& robot) {
  using Frame = RobotModel::Frame;
  using Tip = RobotModel::Tip;
  using Centre = RobotModel::JointCentre;
  using Capsule = RobotModel::Capsule;
  using Limit = RobotModel::CoupledLimit;
  using Curve = RobotModel::BrakingCurve;
  const auto itself = [](Column& out, const auto& value) { add(out, value); };
  const std::vector<double> indices{static_cast<double>(robot.shoulder_frame),
                                    static_cast<double>(robot.palm_frame),
                                    static_cast<double>(robot.side)};
  return {
      column("name", std::vector{robot.name}, itself),
      column("joint_names", robot.joint_names, itself),
      column("shoulder_frame, palm_frame, side", indices, itself),
      column("lower", robot.lower, itself),
      column("upper", robot.upper, itself),
      column("velocity", robot.velocity, itself),
      column("acceleration", robot.acceleration, itself),
      column("jerk", robot.jerk, itself),
      member("frames/name", robot.frames, &Frame::name),
      member("frames/parent", robot.frames, &Frame::parent),
      member("frames/transform", robot.frames, &Frame::transform),
      member("frames/axis", robot.frames, &Frame::axis),
      member("frames/joint", robot.frames, &Frame::joint),
      member("frames/ratio", robot.frames, &Frame::ratio),
      member("frames/offset", robot.frames, &Frame::offset),
      member("frames/prismatic", robot.frames, &Frame::prismatic),
      member("tips/name", robot.tips, &Tip::name),
      member("tips/frame", robot.tips, &Tip::frame),
      member("tips/transform", robot.tips, &Tip::transform),
      member("tips/finger", robot.tips, &Tip::finger),
      member("tips/finger_curve_share", robot.tips, &Tip::finger_curve_share),
      member("joint_centres/frame", robot.joint_centres, &Centre::frame),
      member("joint_centres/chain", robot.joint_centres, &Centre::chain),
      member("capsules/name", robot.capsules, &Capsule::name),
      member("capsules/frame", robot.capsules, &Capsule::frame),
      member("capsules/from", robot.capsules, &Capsule::from),
      member("capsules/to", robot.capsules, &Capsule::to),
      member("capsules/radius", robot.capsules, &Capsule::radius),
      member("capsules/may_touch_target", robot.capsules, &Capsule::may_touch_target),
      column("allowed_collision_pairs", robot.allowed_collision_pairs,
             [](Column& out, const std::array<int, 2>& pair) {
               add(out, std::min(pair[0], pair[1]));
               add(out, std::max(pair[0], pair[1]));
             }),
      column("coupled_limits", robot.coupled_limits,
             [](Column& out, const Limit& own) {
               for (const double value : {static_cast<double>(own.frame), own.lower, own.upper,
                                          own.velocity, own.acceleration, own.jerk})
                 add(out, value);
             }),
      column("braking_curves", robot.braking_curves,
             [](Column& out, const Curve& own) {
               for (const double value : {static_cast<double>(own.joint), own.twice_deceleration,
                                          own.velocity_offset, own.lower_end, own.upper_end})
                 add(out, value);
             }),
      column("unchecked_links", robot.unchecked_links, itself),
  };
}

bool agrees(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

}  // namespace

void verify_robot(const RobotModel& stored, const RobotModel& asked, ViolationCollector& runs) {
  const std::vector<Column> own = columns_of(stored), wanted = columns_of(asked);
  for (std::size_t c = 0; c < own.size(); ++c) {
    const Column &is = own[c], &should = wanted[c];
    if (is.names != should.names || is.numbers.size() != should.numbers.size()) {
      runs.note_plan("robot", is.name, static_cast<double>(is.numbers.size()),
                     static_cast<double>(should.numbers.size()));
      continue;
    }
    for (std::size_t i = 0; i < is.numbers.size(); ++i) {
      if (agrees(is.numbers[i], should.numbers[i])) continue;
      runs.note_plan("robot", is.name, is.numbers[i], should.numbers[i]);
      break;
    }
  }
}

}  // namespace morphe::verify
