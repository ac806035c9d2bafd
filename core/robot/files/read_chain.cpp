#include <fmt/format.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"
#include "core/robot/files/limit_bounds.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::robot {
namespace {

constexpr double kParallelSine = 1e-6;  ///< of the angle below which an axis is along the link

JointLimits read_limits(const config::ConfigNode& row) {
  const auto read = [&](const char* key) { return row[key].number(limit_bounds(key)); };
  const double lower = read("lower"), upper = read("upper");
  if (lower >= upper) row["upper"].fail("must be above lower");
  return {lower, upper, read("velocity"), read("acceleration"), read("jerk")};
}

void read_coupling(const config::ConfigNode& couple, const FileScope& scope,
                   const std::string& joint, const RobotModel& table, RobotModel::Frame& frame) {
  const config::ConfigNode driver = couple["joint"];
  frame.joint = find_joint(table, scope, driver.text());
  if (frame.joint < 0) {
    if (driver.text() == joint) driver.fail("is the joint itself; name another joint");
    driver.fail(fmt::format("there is no actuated joint '{}' before this one", driver.text()));
  }
  if (couple.has("ratio")) frame.ratio = couple["ratio"].number(bounds::kCoupling);
  if (frame.ratio == 0) couple["ratio"].fail("must not be 0");
  if (couple.has("offset")) frame.offset += couple["offset"].number(bounds::kJointPosition);
}

void read_coupled_limit(const config::ConfigNode& row, int frame, RobotModel& table) {
  RobotModel::CoupledLimit limit;
  limit.frame = frame;
  bool is_limited = false;
  const auto read = [&](const char* key, double& value) {
    if (!row.has(key)) return;
    value = row[key].number(limit_bounds(key));
    is_limited = true;
  };
  read("lower", limit.lower);
  read("upper", limit.upper);
  read("velocity", limit.velocity);
  read("acceleration", limit.acceleration);
  read("jerk", limit.jerk);
  if (limit.lower >= limit.upper) row["upper"].fail("must be above lower");
  if (is_limited) table.coupled_limits.push_back(limit);
}

bool read_prismatic(const config::ConfigNode& row) {
  if (!row.has("type")) return false;
  const std::string word = row["type"].text();
  if (word != "revolute" && word != "prismatic")
    row["type"].fail(fmt::format("must be revolute or prismatic, not '{}'", word));
  return word == "prismatic";
}

/// Returns the frames of revolute joints whose axis is not along the line to the chain's next frame
/// at another place, all joints at zero.
std::vector<int> hinges_of(const RobotModel& table, const std::vector<int>& frames) {
  std::vector<Pose> base_from_frame;
  forward_kinematics(table, JointVector::Zero(table.joints()), base_from_frame);
  std::vector<int> hinges;
  for (auto frame = frames.begin(); frame != frames.end(); ++frame) {
    const RobotModel::Frame& f = table.frames[*frame];
    const Pose& pose = base_from_frame[*frame];
    const Vec3 position = pose.translation(), axis = pose.linear() * f.axis;
    const auto next = std::find_if(frame + 1, frames.end(), [&](int other) {
      return (base_from_frame[other].translation() - position).norm() > kCoincidentTolerance_m;
    });
    if (f.joint < 0 || f.prismatic || next == frames.end()) continue;
    const Vec3 direction = (base_from_frame[*next].translation() - position).normalized();
    if (axis.cross(direction).norm() > kParallelSine) hinges.push_back(*frame);
  }
  return hinges;
}

}  // namespace

DhConvention read_convention(const config::ConfigNode& node) {
  const std::string word = node.text();
  if (word == "modified") return DhConvention::modified;
  if (word == "standard") return DhConvention::standard;
  node.fail(fmt::format("must be modified or standard, not '{}'", word));
}

void read_chain(Assembly& assembly, const FileScope& scope, DhConvention convention,
                const config::ConfigNode& node) {
  const config::ConfigNode name = node["name"];
  const std::string full_name = scope.prefix + name.text();
  if (has_frame_or_chain(assembly, full_name))
    name.fail(fmt::format("a frame or chain '{}' already exists", full_name));
  if (node.has("convention")) convention = read_convention(node["convention"]);
  Chain chain{full_name, name.text() == "arm", {}, {}, read_mount_point(assembly, scope, node)};
  for (const config::ConfigNode& row : node["joints"].items()) {
    const DhRow dh{row["theta"].number(bounds::kAngle), row["d"].number(bounds::kSignedLength),
                   row["a"].number(bounds::kSignedLength), row["alpha"].number(bounds::kAngle)};
    const DhLink link = dh_link(convention, dh);
    RobotModel::Frame frame;
    frame.parent = chain.end.frame;
    frame.transform = chain.end.frame_from_mount * link.before;
    frame.prismatic = read_prismatic(row);
    if (frame.prismatic) {
      frame.transform.rotate(Eigen::AngleAxisd(dh.theta, Vec3::UnitZ()));
    } else {
      frame.offset = dh.theta;
    }
    const std::string joint = row["name"].text();
    if (row.has("couple")) {
      read_coupling(row["couple"], scope, joint, assembly.table, frame);
    } else {
      frame.joint = append_joint(assembly, scope.prefix + joint, read_limits(row));
    }
    chain.end = {add_frame(assembly, scope, row["name"], frame), link.after};
    if (row.has("couple")) read_coupled_limit(row, chain.end.frame, assembly.table);
    chain.frames.push_back(chain.end.frame);
    if (dh.d == 0 && !frame.prismatic) chain.hinges.push_back(chain.end.frame);
  }
  if (chain.frames.empty()) node["joints"].fail("must not be empty");
  assembly.chains.push_back(std::move(chain));
}

void read_urdf_chain(Assembly& assembly, const FileScope& scope, const config::ConfigNode& node) {
  const config::ConfigNode name = node["name"];
  Chain chain{scope.prefix + name.text(), name.text() == "arm", {}, {}, {}};
  if (has_frame_or_chain(assembly, chain.name))
    name.fail(fmt::format("a frame or chain '{}' already exists", chain.name));
  const auto end = [&](const char* key) {
    const std::string joint = scope.prefix + node[key].text();
    int frame = frame_index(assembly.table, joint);  // joints take precedence over links
    if (frame < 0) frame = find_frame(assembly, scope, node[key].text());
    if (frame < 0) node[key].fail(fmt::format("there is no joint or link '{}'", node[key].text()));
    return frame;
  };
  const int first = end("first"), last = end("last");
  if (!is_in_subtree(assembly.table, last, first))
    node["last"].fail("must be a descendant of first");
  for (const int frame : ancestors(assembly.table, last)) {
    chain.frames.push_back(frame);
    if (frame == first) break;
  }
  std::ranges::reverse(chain.frames);
  chain.hinges = hinges_of(assembly.table, chain.frames);
  chain.end = {last};
  assembly.chains.push_back(std::move(chain));
}

}  // namespace morphe::robot
