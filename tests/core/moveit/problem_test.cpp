#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/motion/input_error.hpp"
#include "tests/support/moveit_problem.hpp"

namespace morphe::moveit {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path kProblems = fs::path(MORPHE_SOURCE_DIR) / "datasets/motionbenchmaker";

robot::RobotDescription panda() { return robot::load_robot(kProblems / "panda.yaml"); }

TEST(MoveItProblem, AllShippedProblemsAreRead) {
  const robot::RobotDescription robot = panda();
  EXPECT_EQ(robot.table.joints(), 7u);
  EXPECT_EQ(robot.table.capsules.size(), 59u);  // grep -c '<sphere' panda_spherized.urdf
  std::size_t problems = 0, objects = 0;
  for (const auto& folder : fs::directory_iterator(kProblems)) {
    if (!folder.is_directory()) continue;
    for (const auto& file : fs::directory_iterator(folder)) {
      const std::string name = file.path().filename().string();
      if (!name.starts_with("scene")) continue;
      const fs::path request = folder.path() / ("request" + name.substr(5));
      const PlanningProblem problem = read_moveit_problem(file.path(), request, robot);
      ++problems;
      objects += problem.scene.objects.size();
      ASSERT_EQ(problem.goals.size(), 1u);
      EXPECT_EQ(problem.goals[0].lower, problem.goals[0].upper);
      EXPECT_TRUE(problem.start.allFinite());
      // The scenes' matrices say what the SRDF says.
      EXPECT_EQ(problem.robot.allowed_collision_pairs, robot.table.allowed_collision_pairs);
    }
  }
  EXPECT_EQ(problems, 70u);
  EXPECT_EQ(objects, 820u);
}

TEST(MoveItProblem, HoldsWhatTheFilesSay) {
  const fs::path folder = kProblems / "box_panda";
  const PlanningProblem problem =
      read_moveit_problem(folder / "scene0001.yaml", folder / "request0001.yaml", panda());
  const SceneObject& can = problem.scene.objects.at(0);
  EXPECT_EQ(can.name, "Can1");
  EXPECT_EQ(can.shape, Shape::cylinder);
  EXPECT_EQ(can.size, (std::vector<double>{0.03, 0.14}));
  EXPECT_EQ(can.position.at(0), Vec3(0.5408380884576693, 0.3580155146897772, -0.3762264457751537));
  EXPECT_NEAR(can.orientation.at(0).z(), 0.07406844364750122, 1e-15);
  EXPECT_NEAR(can.orientation.at(0).w(), 0.9972531602635496, 1e-15);
  const JointVector start{{0, -0.785, 0, -2.356, 0, 1.571, 0.785}};
  EXPECT_EQ(problem.start, start);
  EXPECT_EQ(problem.goals[0].lower[3], -0.8667848896139277);
  EXPECT_THAT(problem.notes, testing::ElementsAre(HasSubstr("panda_finger_joint1"),
                                                  HasSubstr("panda_finger_joint2")));
}

class MoveItText : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("morphe_moveit_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  PlanningProblem read(const std::string& scene, const std::string& request) const {
    std::ofstream(folder_ / "scene.yaml") << scene;
    std::ofstream(folder_ / "request.yaml") << request;
    return read_moveit_problem(folder_ / "scene.yaml", folder_ / "request.yaml", robot_);
  }
  PlanningProblem read_object(const std::string& object) const {
    return read("world: {collision_objects: [" + object + "]}\n" + kState, kGoal);
  }
  std::string error(const std::string& scene, const std::string& request) const {
    try {
      read(scene, request);
    } catch (const InputError& failure) {
      return failure.what();
    }
    return "none";
  }
  std::string object_error(const std::string& object) const {
    return error("world:\n  collision_objects:\n    - " + object + "\n" + kState, kGoal);
  }

  const std::string kState =
      "robot_state: {joint_state: {name: [panda_joint1, panda_joint2, panda_joint3, panda_joint4, "
      "panda_joint5, panda_joint6, panda_joint7], position: [0, 0, 0, -1, 0, 1, 0]}}\n";
  const std::string kGoal =
      "goal_constraints: [{joint_constraints: [{joint_name: panda_joint2, position: 0.5, "
      "tolerance_above: 0.1, tolerance_below: 0.2}]}]\n";
  const std::string kBox =
      "{id: box, primitives: [{type: box, dimensions: [1, 2, 3]}], primitive_poses: "
      "[{position: [1, 0, 0], orientation: [0, 0, 0, 1]}]}";
  robot::RobotDescription robot_ = panda();
  fs::path folder_;
};

TEST_F(MoveItText, JointGoalWithTolerance) {
  const PlanningProblem problem = read_object(kBox);
  const PlanningGoal& goal = problem.goals.at(0);
  EXPECT_DOUBLE_EQ(goal.lower[1], 0.3);
  EXPECT_DOUBLE_EQ(goal.upper[1], 0.6);
  EXPECT_EQ(goal.lower[0], robot_.table.lower[0]);
  EXPECT_EQ(goal.upper[6], robot_.table.upper[6]);
}

TEST_F(MoveItText, PoseGoalNamesLinkAndRegion) {
  const PlanningProblem problem =
      read("world: {collision_objects: []}\n" + kState,
           "goal_constraints:\n- position_constraints:\n  - link_name: panda_hand\n"
           "    target_point_offset: {x: 0, y: 0, z: 0.1}\n    constraint_region:\n"
           "      primitives: [{type: 2, dimensions: [0.01]}]\n"
           "      primitive_poses: [{position: {x: 0.5, y: 0.1, z: 0.4}}]\n"
           "  orientation_constraints:\n  - {link_name: panda_hand, orientation: [1, 0, 0, 0], "
           "absolute_x_axis_tolerance: 0.1}\n");
  const PlanningGoal& goal = problem.goals.at(0);
  ASSERT_EQ(goal.positions.size(), 1u);
  const int hand = robot_.links.at("panda_hand");
  EXPECT_EQ(problem.robot.frames.at(static_cast<std::size_t>(hand)).name, "panda_hand");
  EXPECT_EQ(goal.positions[0].frame, hand);
  EXPECT_EQ(goal.positions[0].point_in_frame, Vec3(0, 0, 0.1));
  EXPECT_EQ(goal.positions[0].regions.at(0).shape, Shape::sphere);
  EXPECT_EQ(goal.positions[0].regions[0].position[0], Vec3(0.5, 0.1, 0.4));
  EXPECT_EQ(goal.orientations.at(0).orientation.x(), 1);
  EXPECT_EQ(goal.orientations[0].tolerance, Vec3(0.1, 0, 0));
}

TEST_F(MoveItText, EverythingStandsInTheRobotsBaseFrame) {
  // The base stands 1 m along x, turned by 90 degrees about z; a fixed frame lies 2 m along y.
  const std::string scene =
      "fixed_frame_transforms: [{child_frame_id: rack, transform: {translation: [0, 2, 0], "
      "rotation: [0, 0, 0, 1]}}]\n"
      "world: {collision_objects: [{id: shelf, header: {frame_id: rack}, pose: {position: "
      "[0, 0, 1]}, primitives: [{type: sphere, dimensions: [0.1]}, {type: sphere, dimensions: "
      "[0.2]}], primitive_poses: [{position: [0.5, 0, 0]}, {position: [0, 0, 0]}]}]}\n";
  std::string state = kState;
  state.insert(state.rfind('}'),
               ", multi_dof_joint_state: {transforms: [{translation: [1, 0, 0], rotation: "
               "[0, 0, 0.7071067811865476, 0.7071067811865476]}]}");
  const PlanningProblem problem = read(scene + state, kGoal);
  ASSERT_EQ(problem.scene.objects.size(), 2u);
  EXPECT_EQ(problem.scene.objects[0].name, "shelf");
  EXPECT_EQ(problem.scene.objects[1].name, "shelf_2");
  // World (0.5, 2, 1) less (1, 0, 0), turned back by 90 degrees.
  EXPECT_TRUE(problem.scene.objects[0].position[0].isApprox(Vec3(2, 0.5, 1), 1e-12));
  EXPECT_TRUE(problem.scene.objects[1].position[0].isApprox(Vec3(2, 1, 1), 1e-12));
}

TEST_F(MoveItText, AllowedMatrixAddsPairsOfLinksOnly) {
  std::string scene = "world: {collision_objects: [" + kBox + "]}\n" + kState;
  scene +=
      "allowed_collision_matrix:\n  entry_names: [panda_link0, panda_link7, box]\n"
      "  entry_values:\n  - [false, true, false]\n  - [true, false, true]\n"
      "  - {enabled: [false, true, false]}\n";
  const PlanningProblem problem = read(scene, kGoal);
  const std::size_t before = robot_.table.allowed_collision_pairs.size();
  EXPECT_EQ(problem.robot.allowed_collision_pairs.size(),
            before + 1 * 5);  // spheres of link0, link7
  EXPECT_THAT(problem.notes, testing::Contains(HasSubstr("box and panda_link7")));
}

TEST_F(MoveItText, MeshesMayBeWrittenOut) {
  const PlanningProblem problem = read_object(
      "{id: m, meshes: [{vertices: [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], triangles: "
      "[{vertex_indices: [0,2,1]},[0,1,3],[0,3,2],[1,2,3]]}], mesh_poses: [{position: [0,0,9]}]}");
  const SceneObject& mesh = problem.scene.objects.at(0);
  EXPECT_EQ(mesh.shape, Shape::mesh);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.position[0].z(), 9);
}

TEST_F(MoveItText, WrongFilesAreNamedWithTheirPlace) {
  const std::string cone = object_error("{id: a, primitives: [{type: cone, dimensions: [1, 2]}]}");
  EXPECT_THAT(cone, HasSubstr("scene.yaml:3: "));
  EXPECT_THAT(cone, HasSubstr("primitives[0].type: must be box, sphere or cylinder, not 'cone'"));
  EXPECT_THAT(object_error("{id: a}"), HasSubstr("has neither primitives nor meshes"));
  EXPECT_THAT(object_error("{id: a, primitives: [{type: box, dimensions: [1, 2]}]}"),
              HasSubstr("dimensions: must have 3 numbers, not 2"));
  EXPECT_THAT(object_error("{id: a, primitives: [{type: sphere, dimensions: [0]}]}"),
              HasSubstr("dimensions[0]: must be above 0 and at most 100 m, not 0"));
  EXPECT_THAT(object_error("{id: a, primitives: [{type: sphere, dimensions: [1]}, {type: sphere, "
                           "dimensions: [1]}], primitive_poses: []}"),
              HasSubstr("2 primitives but 0 primitive_poses"));
  EXPECT_THAT(object_error("{id: a, header: {frame_id: nowhere}, primitives: []}"),
              HasSubstr("there is no fixed frame 'nowhere'"));
  EXPECT_THAT(object_error(kBox + "\n    - " + kBox), HasSubstr("'box' already exists"));
  EXPECT_THAT(object_error("{id: a, planes: [{coef: [0, 0, 1, 0]}]}"), HasSubstr("planes"));
  EXPECT_THAT(object_error("{id: m, meshes: [{vertices: [[0,0,0]], triangles: [[0,1,2]]}]}"),
              HasSubstr("there is no vertex 1"));
  const std::string empty = "world: {collision_objects: []}\n";
  EXPECT_THAT(error(empty, kGoal), HasSubstr("joint 'panda_joint1' has no position"));
  EXPECT_THAT(error(empty + kState,
                    "start_state: {joint_state: {name: [panda_joint1], position: "
                    "[4]}}\n" +
                        kGoal),
              HasSubstr("request.yaml:1: start_state: joint 'panda_joint1' starts at 4, outside"));
  EXPECT_THAT(error(empty + kState, "goal_constraints: []"), HasSubstr("has no goals"));
  EXPECT_THAT(error(empty + kState,
                    "goal_constraints: [{joint_constraints: [{joint_name: x, "
                    "position: 0}]}]"),
              HasSubstr("there is no actuated joint 'x'"));
  EXPECT_THAT(error(empty + kState,
                    "goal_constraints: [{joint_constraints: [{joint_name: "
                    "panda_joint4, position: 1}]}]"),
              HasSubstr("outside the joint's limits"));
  EXPECT_THAT(error(empty + kState, "goal_constraints: [{position_constraints: [{link_name: x}]}]"),
              HasSubstr("there is no link 'x'"));
  EXPECT_THAT(error(empty + kState, kGoal + "path_constraints: {name: x}"),
              HasSubstr("path constraints"));
  EXPECT_THAT(error("robot_state: {attached_collision_objects: [{link_name: a}]}\n" + empty, kGoal),
              HasSubstr("attached objects"));
}

}  // namespace
}  // namespace morphe::moveit
