#include "tests/pipeline/setup/arm_table.hpp"

namespace morphe::setup {
namespace {

using Joints = std::vector<TableJoint>;

/// Appends the joints of a limb, each on the one before.
void add_limb(Joints& joints, std::string parent, const Joints& limb) {
  for (TableJoint joint : limb) {
    joint.parent = parent;
    parent = joint.name;
    joints.push_back(joint);
  }
}

/// Returns the same limb on the right side: joints l_… become r_….
Joints mirrored(Joints limb) {
  for (TableJoint& joint : limb) {
    joint.name = "r" + joint.name.substr(1);
    joint.y = -joint.y;
  }
  return limb;
}

void add_both(Joints& joints, const std::string& parent, const Joints& limb) {
  add_limb(joints, parent, limb);
  add_limb(joints, parent, mirrored(limb));
}

/// Legs of six joints from a pelvis at the origin.
void add_legs(Joints& joints) {
  add_both(joints, "",
           {{"l_q1", "", 'y', 0, 0.06, -0.1},
            {"l_q2", "", 'x', 0, 0.12, -0.13},
            {"l_q3", "", 'z', 0, 0.12, -0.2},
            {"l_q4", "", 'y', 0, 0.12, -0.4},
            {"l_q5", "", 'y', 0, 0.12, -0.7},
            {"l_q6", "", 'x', 0, 0.12, -0.72}});
}

TableRobot sawyer() {
  TableRobot robot{"sawyer", {}, "", "j0", "j3", {"j1", "j2"}, {"j4", "j5"}};
  add_limb(robot.joints, "",
           {{"j0", "", 'z', 0, 0, 0.08},
            {"j1", "", 'y', 0.081, 0.05, 0.317},
            {"j2", "", 'x', 0.22, 0.1925, 0.317},
            {"j3", "", 'y', 0.481, 0.15, 0.317},
            {"j4", "", 'x', 0.6, 0.024, 0.317},
            {"j5", "", 'y', 0.881, 0.055, 0.317},
            {"j6", "", 'x', 0.99, 0.16, 0.317}});
  robot.joints.push_back({"head_pan", "j0", 'z', 0.03, 0, 0.38});
  return robot;
}

TableRobot baxter() {
  TableRobot robot{"baxter", {}, "l_w2", "l_s0", "l_e1", {"l_s1", "l_e0"}, {"l_w0", "l_w1"}};
  robot.joints.push_back({"head_pan", "", 'z', 0.06, 0, 0.7});
  add_both(robot.joints, "",
           {{"l_s0", "", 'z', 0.064, 0.259, 0.13},
            {"l_s1", "", 'y', 0.133, 0.259, 0.4},
            {"l_e0", "", 'x', 0.235, 0.259, 0.4},
            {"l_e1", "", 'y', 0.497, 0.259, 0.331},
            {"l_w0", "", 'x', 0.601, 0.259, 0.331},
            {"l_w1", "", 'y', 0.871, 0.259, 0.321},
            {"l_w2", "", 'x', 0.987, 0.259, 0.321}});
  return robot;
}

TableRobot yumi() {
  TableRobot robot{"yumi", {}, "r_a6", "r_a1", "r_a3", {"r_a2"}, {"r_a5"}};
  add_both(robot.joints, "",
           {{"l_a1", "", 'z', 0.05, 0.07, 0.41},
            {"l_a2", "", 'y', 0.08, 0.07, 0.51},
            {"l_a7", "", 'z', 0.05, 0.07, 0.68},
            {"l_a3", "", 'y', 0.008, 0.07, 0.76},
            {"l_a4", "", 'z', 0.0485, 0.07, 0.93},
            {"l_a5", "", 'y', 0.0215, 0.07, 1.03},
            {"l_a6", "", 'z', 0.0485, 0.07, 1.06}});
  return robot;
}

/// The arm of Unitree's humanoids: forearm forwards at zero.
Joints unitree_arm(double y, double z, double pitch_roll, double upper, double fore, double last) {
  return {{"l_a1", "", 'y', 0, y - 0.04, z},
          {"l_a2", "", 'x', 0.01, y, z - pitch_roll},
          {"l_a3", "", 'z', 0, y + 0.004, z - 0.1},
          {"l_a4", "", 'y', 0.015, y + 0.004, z - upper},
          {"l_a5", "", 'x', 0.1, y + 0.004, z - upper - 0.01},
          {"l_a6", "", 'y', 0.015 + fore, y + 0.004, z - upper - 0.01},
          {"l_a7", "", 'z', 0.015 + fore + last, y + 0.004, z - upper - 0.01}};
}

TableRobot unitree(const char* name, const Joints& waist, const Joints& arm) {
  TableRobot robot{name, {}, "l_a7", "l_a1", "l_a4", {"l_a3"}, {"l_a5", "l_a6"}};
  add_legs(robot.joints);
  add_limb(robot.joints, "", waist);
  for (const TableJoint& joint : waist) robot.trunk.push_back(joint.name);
  add_both(robot.joints, waist.back().name, arm);
  return robot;
}

TableRobot g1() {
  TableRobot robot = unitree(
      "g1", {{"w1", "", 'z', 0, 0, 0}, {"w2", "", 'x', 0, 0, 0.035}, {"w3", "", 'y', 0, 0, 0.054}},
      unitree_arm(0.141, 0.289, 0.014, 0.185, 0.138, 0.046));
  robot.shoulder = {"l_a1", "l_a3"};
  return robot;
}

TableRobot h1_2() {
  TableRobot robot = unitree("h1_2", {{"w1", "", 'z', 0, 0, 0.1}},
                             unitree_arm(0.209, 0.434, 0.006, 0.33, 0.211, 0.02));
  robot.shoulder = {"l_a1", "l_a3"};
  return robot;
}

TableRobot h2() {
  TableRobot robot = unitree(
      "h2", {{"w1", "", 'z', 0, 0, 0}, {"w2", "", 'x', 0, 0, 0.05}, {"w3", "", 'y', 0, 0, 0.08}},
      unitree_arm(0.178, 0.461, 0.04, 0.234, 0.17, 0.069));
  robot.shoulder = {"l_a2", "l_a3"};
  return robot;
}

TableRobot h1() {
  TableRobot robot = unitree("h1", {{"w1", "", 'z', 0, 0, 0.1}}, {});
  Joints arm = unitree_arm(0.209, 0.434, 0.006, 0.33, 0.211, 0.02);
  arm.resize(4);
  arm.push_back({"l_end", "", 'f', 0.3, 0.2, 0.1});
  add_both(robot.joints, "w1", arm);
  robot.arm = "l_a4";
  robot.shoulder = {"l_a1", "l_a3"};
  robot.wrist = {};
  return robot;
}

TableRobot gr1t2() {
  TableRobot robot{
      "gr1t2", {}, "l_a7", "l_a1", "l_a4", {"l_a1", "l_a2"}, {"l_a5", "l_a6"}, {"w1", "w2", "w3"}};
  add_legs(robot.joints);
  add_limb(robot.joints, "",
           {{"w1", "", 'z', 0, 0, 0}, {"w2", "", 'y', 0, 0, 0.05}, {"w3", "", 'x', 0, 0, 0.1}});
  add_both(robot.joints, "w3",
           {{"l_a1", "", 'y', 0, 0.13, 0.415},
            {"l_a2", "", 'x', 0, 0.188, 0.415},
            {"l_a3", "", 'z', 0, 0.228, 0.36},
            {"l_a4", "", 'y', 0, 0.228, 0.162},
            {"l_a5", "", 'z', 0, 0.228, 0.1},
            {"l_a6", "", 'x', 0, 0.228, -0.089},
            {"l_a7", "", 'y', 0, 0.228, -0.089}});
  return robot;
}

TableRobot talos() {
  TableRobot robot{"talos",          {},          "l_a7", "l_a1", "l_a4", {"l_a2", "l_a3"},
                   {"l_a5", "l_a6"}, {"t1", "t2"}};
  add_legs(robot.joints);
  add_limb(robot.joints, "", {{"t1", "", 'z', 0, 0, 0.07}, {"t2", "", 'y', 0, 0, 0.07}});
  add_both(robot.joints, "t2",
           {{"l_a1", "", 'z', 0, 0.157, 0.3},
            {"l_a2", "", 'x', 0.005, 0.294, 0.351},
            {"l_a3", "", 'z', 0, 0.294, 0.2},
            {"l_a4", "", 'y', 0.02, 0.294, 0.078},
            {"l_a5", "", 'z', 0, 0.294, 0.0},
            {"l_a6", "", 'x', 0, 0.294, -0.187},
            {"l_a7", "", 'y', 0, 0.294, -0.187}});
  add_limb(robot.joints, "t2", {{"h1", "", 'y', 0, 0, 0.35}, {"h2", "", 'z', 0, 0, 0.4}});
  return robot;
}

TableRobot fetch() {
  TableRobot robot{"fetch", {}, "", "a1", "a4", {"a2", "a3"}, {"a5", "a6"}, {"lift"}};
  robot.joints = {{"r_wheel", "", 'y', 0, -0.19, 0.06}, {"l_wheel", "", 'y', 0, 0.19, 0.06}};
  add_limb(robot.joints, "", {{"lift", "", 'Z', -0.087, 0, 0.38}});
  add_limb(robot.joints, "lift", {{"h1", "", 'z', -0.03, 0, 0.98}, {"h2", "", 'y', 0.1, 0, 1.04}});
  add_limb(robot.joints, "lift",
           {{"a1", "", 'z', 0.033, 0, 0.726},
            {"a2", "", 'y', 0.15, 0, 0.786},
            {"a3", "", 'x', 0.369, 0, 0.786},
            {"a4", "", 'y', 0.502, 0, 0.786},
            {"a5", "", 'x', 0.699, 0, 0.786},
            {"a6", "", 'y', 0.8235, 0, 0.786},
            {"a7", "", 'x', 0.962, 0, 0.786}});
  return robot;
}

TableRobot pr2() {
  TableRobot robot{"pr2", {}, "r_a7", "r_a1", "r_a4", {"r_a2", "r_a3"}, {"r_a5", "r_a6"}, {"lift"}};
  for (const char* corner : {"fl", "fr"}) {  // casters are no hands
    const std::string caster = corner;
    robot.joints.push_back({caster, "", 'z', 0.22, 0.22, 0.08});
    robot.joints.push_back({caster + "_l", caster, 'y', 0.22, 0.27, 0.08});
    robot.joints.push_back({caster + "_r", caster, 'y', 0.22, 0.17, 0.08});
  }
  add_limb(robot.joints, "", {{"lift", "", 'Z', -0.05, 0, 0.79}});
  add_both(robot.joints, "lift",
           {{"l_a1", "", 'z', -0.05, 0.188, 0.79},
            {"l_a2", "", 'y', 0.05, 0.188, 0.79},
            {"l_a3", "", 'x', 0.05, 0.188, 0.79},
            {"l_a4", "", 'y', 0.45, 0.188, 0.79},
            {"l_a5", "", 'x', 0.45, 0.188, 0.79},
            {"l_a6", "", 'y', 0.771, 0.188, 0.79},
            {"l_a7", "", 'x', 0.771, 0.188, 0.79}});
  return robot;
}

TableRobot icub() {
  TableRobot robot{"icub",           {},
                   "r_a7",           "r_a1",
                   "r_a4",           {"r_a1", "r_a2", "r_a3"},
                   {"r_a5", "r_a6"}, {"t1", "t2", "t3"}};
  add_legs(robot.joints);
  add_limb(
      robot.joints, "",
      {{"t1", "", 'y', 0.03, 0, 0}, {"t2", "", 'x', 0.03, 0, 0.005}, {"t3", "", 'z', 0, 0, 0.1}});
  add_limb(robot.joints, "t3",
           {{"n1", "", 'y', 0, 0, 0.28},
            {"n2", "", 'x', 0, 0, 0.29},
            {"n3", "", 'z', 0, 0, 0.3},
            {"e1", "", 'y', 0.06, 0, 0.36}});
  robot.joints.push_back({"e2", "e1", 'z', 0.06, 0.034, 0.36});
  robot.joints.push_back({"e3", "e1", 'z', 0.06, -0.034, 0.36});
  add_both(robot.joints, "t3",
           {{"l_a1", "", 'y', 0, 0.11, 0.25},
            {"l_a2", "", 'x', 0, 0.11, 0.25},
            {"l_a3", "", 'z', 0, 0.11, 0.2},
            {"l_a4", "", 'y', 0.015, 0.11, 0.098},
            {"l_a5", "", 'z', 0, 0.11, 0.03},
            {"l_a6", "", 'x', 0, 0.11, -0.039},
            {"l_a7", "", 'y', 0, 0.11, -0.039}});
  return robot;
}

TableRobot industrial(const char* name, double pan_lift, const Joints& before) {
  TableRobot robot{name, {}, "", "a1", "a3", {"a2"}, {"a4", "a5", "a6"}};
  add_limb(robot.joints, "", before);
  for (const TableJoint& joint : before) robot.trunk.push_back(joint.name);
  const double x = pan_lift;
  add_limb(robot.joints, before.empty() ? "" : before.back().name,
           {{"a1", "", 'z', 0, 0, 0.2},
            {"a2", "", 'y', x, 0, 0.4},
            {"a3", "", 'y', x, 0, 0.86},
            {"a4", "", 'x', x + 0.2, 0, 0.9},
            {"a5", "", 'y', x + 0.42, 0, 0.9},
            {"a6", "", 'x', x + 0.5, 0, 0.9}});
  return robot;
}

TableRobot parallel_axes(const char* name, const Joints& before) {
  TableRobot robot{name, {}, "", "a1", "a3", {"a1", "a2"}, {"a4", "a5"}};
  add_limb(robot.joints, "", before);
  for (const TableJoint& joint : before) robot.trunk.push_back(joint.name);
  add_limb(robot.joints, before.empty() ? "" : before.back().name,
           {{"a1", "", 'z', 0, 0, 0.16},
            {"a2", "", 'y', 0, 0.13, 0.16},
            {"a3", "", 'y', 0.425, 0.02, 0.16},
            {"a4", "", 'y', 0.817, 0.13, 0.16},
            {"a5", "", 'z', 0.817, 0.13, 0.06},
            {"a6", "", 'y', 0.817, 0.23, 0.06}});
  return robot;
}

TableRobot hobby() {
  TableRobot robot{"hobby", {}, "", "a1", "a3", {"a2"}, {"a4", "a5"}};
  add_limb(robot.joints, "",
           {{"a1", "", 'z', 0, 0, 0.05},
            {"a2", "", 'y', 0.03, 0, 0.11},
            {"a3", "", 'y', 0.058, 0, 0.223},
            {"a4", "", 'y', 0.193, 0, 0.23},
            {"a5", "", 'x', 0.254, 0, 0.23}});
  return robot;
}

TableRobot tiago() {
  TableRobot robot{"tiago", {}, "", "a1", "a4", {"a2", "a3"}, {"a5", "a6"}, {"lift"}};
  add_limb(robot.joints, "",
           {{"lift", "", 'Z', -0.06, 0, 0.19},
            {"a1", "", 'z', 0.09, 0, 0.6},
            {"a2", "", 'y', 0.215, 0, 0.57},
            {"a3", "", 'x', 0.3, 0, 0.57},
            {"a4", "", 'y', 0.526, 0, 0.55},
            {"a5", "", 'x', 0.6, 0, 0.57},
            {"a6", "", 'y', 0.837, 0, 0.57},
            {"a7", "", 'z', 0.837, 0, 0.57}});
  return robot;
}

TableRobot nao() {
  TableRobot robot{"nao", {}, "l_a5", "l_a1", "l_a4", {"l_a1"}, {"l_a5"}};
  add_legs(robot.joints);
  add_limb(robot.joints, "", {{"h1", "", 'z', 0, 0, 0.127}, {"h2", "", 'y', 0, 0, 0.127}});
  add_both(robot.joints, "",
           {{"l_a1", "", 'y', 0, 0.098, 0.1},
            {"l_a2", "", 'z', 0, 0.098, 0.1},
            {"l_a3", "", 'x', 0.105, 0.113, 0.1},
            {"l_a4", "", 'z', 0.105, 0.113, 0.1},
            {"l_a5", "", 'x', 0.161, 0.113, 0.1},
            {"l_end", "", 'f', 0.219, 0.113, 0.088}});
  return robot;
}

TableRobot scara() {
  TableRobot robot{"scara", {}, "", "a1", "a2", {"a1"}, {"a4"}};
  add_limb(robot.joints, "",
           {{"a1", "", 'z', 0, 0, 0.2},
            {"a2", "", 'z', 0.25, 0, 0.25},
            {"a3", "", 'Z', 0.45, 0, 0.25},
            {"a4", "", 'z', 0.45, 0, 0.1}});
  return robot;
}

TableRobot whole_arm() {
  TableRobot robot{"whole_arm", {}, "", "a1", "a4", {"a1", "a2", "a3"}, {"a5", "a6", "a7"}};
  add_limb(robot.joints, "",
           {{"a1", "", 'z', 0, 0, 0.346},
            {"a2", "", 'y', 0, 0, 0.346},
            {"a3", "", 'z', 0, 0, 0.7},
            {"a4", "", 'y', 0.045, 0, 0.896},
            {"a5", "", 'z', 0, 0, 1.0},
            {"a6", "", 'y', 0, 0, 1.196},
            {"a7", "", 'z', 0, 0, 1.25}});
  return robot;
}

}  // namespace

std::vector<TableRobot> table_robots() {
  return {sawyer(),
          baxter(),
          yumi(),
          g1(),
          h1_2(),
          h2(),
          h1(),
          gr1t2(),
          talos(),
          fetch(),
          pr2(),
          icub(),
          industrial("spherical_wrist", 0, {}),
          industrial("offset_pan", 0.15, {}),
          industrial("mobile_lift", 0.025, {{"lift", "", 'Z', 0, 0, 0.1}}),
          industrial("rail", 0.025, {{"rail", "", 'X', 0, 0, 0.1}}),
          parallel_axes("ur", {}),
          parallel_axes("ur_on_torso", {{"yaw", "", 'z', -0.1, 0, 0.1}}),
          hobby(),
          tiago(),
          nao(),
          scara(),
          whole_arm()};
}

}  // namespace morphe::setup
