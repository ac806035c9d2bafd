#include <algorithm>
#include <cmath>

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
  for (const double coordinate : point) add(out, coordinate);
}
void add(Column& out, const Pose& pose) {
  for (const double element : pose.matrix().reshaped()) add(out, element);
}

/// Returns the column of a data member of all rows.
template <class Rows, class Value, class Row>
Column member(const char* name, const Rows& rows, Value Row::*value) {
  return column(name, rows, [&](Column& out, const Row& row) { add(out, row.*value); });
}

std::vector<Column> columns_of(const RobotModel& robot) {
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
      member("frames/name", robot.frames, &RobotModel::Frame::name),
      member("frames/parent", robot.frames, &RobotModel::Frame::parent),
      member("frames/transform", robot.frames, &RobotModel::Frame::transform),
      member("frames/axis", robot.frames, &RobotModel::Frame::axis),
      member("frames/joint", robot.frames, &RobotModel::Frame::joint),
      member("frames/ratio", robot.frames, &RobotModel::Frame::ratio),
      member("frames/offset", robot.frames, &RobotModel::Frame::offset),
      member("frames/prismatic", robot.frames, &RobotModel::Frame::prismatic),
      member("tips/name", robot.tips, &RobotModel::Tip::name),
      member("tips/frame", robot.tips, &RobotModel::Tip::frame),
      member("tips/transform", robot.tips, &RobotModel::Tip::transform),
      member("tips/finger", robot.tips, &RobotModel::Tip::finger),
      member("tips/finger_curve_share", robot.tips, &RobotModel::Tip::finger_curve_share),
      member("joint_centres/frame", robot.joint_centres, &RobotModel::JointCentre::frame),
      member("joint_centres/chain", robot.joint_centres, &RobotModel::JointCentre::chain),
      member("capsules/name", robot.capsules, &RobotModel::Capsule::name),
      member("capsules/frame", robot.capsules, &RobotModel::Capsule::frame),
      member("capsules/from", robot.capsules, &RobotModel::Capsule::from),
      member("capsules/to", robot.capsules, &RobotModel::Capsule::to),
      member("capsules/radius", robot.capsules, &RobotModel::Capsule::radius),
      member("capsules/may_touch_target", robot.capsules, &RobotModel::Capsule::may_touch_target),
      column("allowed_collision_pairs", robot.allowed_collision_pairs,
             [](Column& out, const std::array<int, 2>& pair) {
               add(out, std::min(pair[0], pair[1]));
               add(out, std::max(pair[0], pair[1]));
             }),
      column("coupled_limits", robot.coupled_limits,
             [](Column& out, const auto& own) {
               out.numbers.insert(out.numbers.end(), {1.0 * own.frame, own.lower, own.upper,
                                                      own.velocity, own.acceleration, own.jerk});
             }),
      column("braking_curves", robot.braking_curves,
             [](Column& out, const auto& own) {
               out.numbers.insert(out.numbers.end(),
                                  {1.0 * own.joint, own.twice_deceleration, own.velocity_offset,
                                   own.lower_end, own.upper_end});
             }),
      column("unchecked_links", robot.unchecked_links, itself),
  };
}

bool agrees(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b));
}

}  // namespace

void verify_robot(const RobotModel& stored, const RobotModel& request, ViolationLog& violations) {
  const std::vector<Column> stored_columns = columns_of(stored), columns = columns_of(request);
  for (int c = 0; c < std::ssize(columns); ++c) {
    const Column &own = stored_columns[c], &column = columns[c];
    const std::vector<double>&own_numbers = own.numbers, &numbers = column.numbers;
    if (own.names != column.names || own_numbers.size() != numbers.size()) {
      violations.note_plan("robot", own.name, static_cast<double>(own_numbers.size()),
                           static_cast<double>(numbers.size()));
      continue;
    }
    const auto [found, wanted] = std::ranges::mismatch(own_numbers, numbers, agrees);
    if (found != own_numbers.end()) violations.note_plan("robot", own.name, *found, *wanted);
  }
}

}  // namespace morphe::verify
