#include <fmt/format.h>

#include <algorithm>

#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

double read_positive(const config::ConfigNode& node) {
  const double value = node.number();
  if (value <= 0) node.fail("must be above 0");
  return value;
}

/// Returns the name given in the file, with the file's prefix.
std::string prefixed(const FileScope& scope, const config::ConfigNode& name) {
  return scope.prefix + name.text();
}

/// Adds an actuated joint and returns its index.
int add_joint(Assembly& assembly, const std::string& name, const config::ConfigNode& row) {
  assembly.lower.push_back(row["lower"].number());
  assembly.upper.push_back(row["upper"].number());
  if (assembly.lower.back() >= assembly.upper.back()) row["upper"].fail("must be above lower");
  assembly.velocity.push_back(read_positive(row["velocity"]));
  assembly.acceleration.push_back(read_positive(row["acceleration"]));
  assembly.jerk.push_back(read_positive(row["jerk"]));
  assembly.table.joint_names.push_back(name);
  return static_cast<int>(assembly.table.joint_names.size()) - 1;
}

void read_coupling(const config::ConfigNode& couple, const FileScope& scope,
                   const std::string& joint, const RobotModel& table, RobotModel::Frame& frame) {
  const config::ConfigNode driver = couple["joint"];
  auto found = std::ranges::find(table.joint_names, prefixed(scope, driver));
  if (found == table.joint_names.end()) found = std::ranges::find(table.joint_names, driver.text());
  if (found == table.joint_names.end()) {
    if (driver.text() == joint) driver.fail("is the joint itself; name another joint");
    driver.fail(fmt::format("there is no actuated joint '{}' before this one", driver.text()));
  }
  frame.joint = static_cast<int>(found - table.joint_names.begin());
  if (couple.has("ratio")) frame.ratio = couple["ratio"].number();
  if (frame.ratio == 0) couple["ratio"].fail("must not be 0");
  if (couple.has("offset")) frame.offset += couple["offset"].number();
}

/// Reads the limits of a coupled joint itself, if its row has any.
void read_coupled_limit(const config::ConfigNode& row, int frame, RobotModel& table) {
  RobotModel::CoupledLimit limit;
  limit.frame = frame;
  bool any = false;
  const auto read = [&](const char* key, double& value, bool above_zero) {
    if (!row.has(key)) return;
    value = above_zero ? read_positive(row[key]) : row[key].number();
    any = true;
  };
  read("lower", limit.lower, false);
  read("upper", limit.upper, false);
  read("velocity", limit.velocity, true);
  read("acceleration", limit.acceleration, true);
  read("jerk", limit.jerk, true);
  if (limit.lower >= limit.upper) row["upper"].fail("must be above lower");
  if (any) table.coupled_limits.push_back(limit);
}

bool read_slides(const config::ConfigNode& row) {
  if (!row.has("type")) return false;
  const std::string word = row["type"].text();
  if (word != "revolute" && word != "prismatic") {
    row["type"].fail(fmt::format("must be revolute or prismatic, not '{}'", word));
  }
  return word == "prismatic";
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
  if (has_frame_or_chain(assembly, prefixed(scope, name))) {
    name.fail(fmt::format("a frame or chain '{}' already exists", prefixed(scope, name)));
  }
  if (node.has("convention")) convention = read_convention(node["convention"]);
  Chain chain{
      prefixed(scope, name), name.text() == "arm", {}, {}, read_mount_point(assembly, scope, node)};
  for (const config::ConfigNode& row : node["joints"].items()) {
    const DhRow dh{row["theta"].number(), row["d"].number(), row["a"].number(),
                   row["alpha"].number()};
    const DhLink link = dh_link(convention, dh);
    RobotModel::Frame frame;
    frame.parent = chain.end.frame;
    frame.transform = chain.end.frame_from_mount * link.before;
    frame.prismatic = read_slides(row);
    if (frame.prismatic) {
      frame.transform.rotate(Eigen::AngleAxisd(dh.theta, Vec3::UnitZ()));
    } else {
      frame.offset = dh.theta;
    }
    const bool coupled = row.has("couple");
    if (coupled) {
      read_coupling(row["couple"], scope, row["name"].text(), assembly.table, frame);
    } else {
      frame.joint = add_joint(assembly, prefixed(scope, row["name"]), row);
    }
    chain.end = {add_frame(assembly, scope, row["name"], frame), link.after};
    if (coupled) read_coupled_limit(row, chain.end.frame, assembly.table);
    chain.frames.push_back(chain.end.frame);
    if (dh.d == 0 && !frame.prismatic) chain.hinges.push_back(chain.end.frame);
  }
  if (chain.frames.empty()) node["joints"].fail("must not be empty");
  assembly.chains.push_back(std::move(chain));
}

}  // namespace morphe::robot
