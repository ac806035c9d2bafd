#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <string_view>

#include "core/collision/mesh_solid.hpp"
#include "core/config/fields.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two seconds of a hand that rests at z = 0.02, and closes around an upright cylinder of radius
/// 0.036 at (0.2, 0.3): tips' axes 0.047 from its axis.
struct Grasping {
  HumanMotion motion;
  Movement movement;
  Grasping() {
    const std::size_t frames = 201;
    motion.tip = Array2D<Vec3>(frames, kFingerCount, unknown_point());
    for (std::size_t i = 0; i < frames; ++i) {
      const double share = std::min(1.0, static_cast<double>(i) / 100);
      motion.time.push_back(5 + 0.01 * static_cast<double>(i));
      motion.wrist.push_back(Vec3(0.2, 0.0 + 0.1 * share, 0.05));
      motion.tip(i, 0) = Vec3(0.2, 0.1, 0.02) + share * Vec3(-0.047 * 0.6, 0.2 - 0.047 * 0.8, 0.07);
      motion.tip(i, 1) = Vec3(0.2, 0.1, 0.02) + share * Vec3(0.047 * 0.6, 0.2 + 0.047 * 0.8, 0.05);
    }
    movement.begin_s = 5;
    movement.end_s = 6.5;
    movement.phases = {{PhaseKind::reach, 5, 6, 1},
                       {PhaseKind::preshape, 5.3, 6, 1},
                       {PhaseKind::grasp, 6, 6.5, 1}};
  }
};

const SceneObject& object(const Scene& scene, std::string_view name) {
  for (const SceneObject& o : scene.objects) {
    if (o.name == name) return o;
  }
  throw std::runtime_error(fmt::format("no object {}", name));
}

std::vector<std::string> names(const Scene& scene) {
  std::vector<std::string> result;
  for (const SceneObject& o : scene.objects) result.push_back(o.name);
  return result;
}

double top(const SceneObject& box) { return box.position[0].z() + box.size[2] / 2; }

TEST(BuildScene, InfersTableAndCup) {
  Grasping g;
  const Scene scene = build_scene({}, {}, g.motion, g.movement);
  EXPECT_THAT(names(scene), ElementsAre("table", "cup"));
  EXPECT_EQ(g.movement.target, "cup");
  const SceneObject &table = object(scene, "table"), &cup = object(scene, "cup");
  EXPECT_EQ(table.shape, Shape::box);
  EXPECT_NEAR(top(table), 0.02 - 0.012, 1e-12);
  EXPECT_NEAR(table.position[0].y() - table.size[1] / 2, 0.0 - 0.05, 1e-12);
  EXPECT_EQ(cup.shape, Shape::cylinder);
  EXPECT_NEAR(cup.size[0], 0.036, 1e-12);
  EXPECT_NEAR(cup.position[0].x(), 0.2, 1e-12);
  EXPECT_NEAR(cup.position[0].y(), 0.3, 1e-12);
  // It stands on the table and ends 20 mm above the higher tip (0.09).
  EXPECT_NEAR(cup.position[0].z() - cup.size[1] / 2, top(table), 1e-12);
  EXPECT_NEAR(cup.position[0].z() + cup.size[1] / 2, 0.11, 1e-12);
  EXPECT_EQ(cup.attach_s, 6.5);
  EXPECT_EQ(cup.release_s, 6.5);
  EXPECT_TRUE(cup.orientation[0].isApprox(Quat::Identity()));
}

TEST(BuildScene, TheTableIsBelowEveryPlannedTipButNotBelowAStrayOne) {
  Grasping g;
  g.motion.tip(50, 1).z() = 0.015;   // planned
  g.motion.tip(180, 1).z() = -0.30;  // after the movement: a marker that was swapped
  const Scene scene = build_scene({}, {}, g.motion, g.movement);
  EXPECT_NEAR(top(object(scene, "table")), 0.015 - 0.012, 1e-12);
}

TEST(BuildScene, TheTableHoldsAllPlannedTips) {
  Grasping g;
  SceneOptions options;
  options.table.size = {0.1, 0.1};
  const SceneObject table = build_scene(options, {}, g.motion, g.movement).objects[0];
  for (std::size_t i = 0; i <= 150; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3 away = g.motion.tip(i, k) - table.position[0];
      EXPECT_LT(std::abs(away.x()), table.size[0] / 2);
      EXPECT_LT(std::abs(away.y()), table.size[1] / 2);
    }
  }
}

TEST(BuildScene, TableHeightAndCupRadiusCanBeGiven) {
  Grasping g;
  SceneOptions options;
  options.table.infer = false;
  options.table.height = -0.03;
  options.target.radius = 0.02;
  const Scene scene = build_scene(options, {}, g.motion, g.movement);
  EXPECT_NEAR(top(object(scene, "table")), -0.03, 1e-12);
  EXPECT_EQ(object(scene, "cup").size[0], 0.02);
  EXPECT_NEAR(object(scene, "cup").size[1], 0.11 + 0.03, 1e-12);
}

TEST(BuildScene, WithoutTableTheCupIsCentredAtTheTips) {
  Grasping g;
  SceneOptions options;
  options.table.infer = false;
  const Scene scene = build_scene(options, {}, g.motion, g.movement);
  EXPECT_THAT(names(scene), ElementsAre("cup"));
  EXPECT_NEAR(object(scene, "cup").position[0].z(), 0.08, 1e-12);
}

TEST(BuildScene, WhatIsGraspedFarAboveTheTableDoesNotStandOnIt) {
  Grasping g;
  SceneOptions options;
  options.table.height = 0.11 - 0.299;  // the rim is 20 mm above the higher tip, at 0.11
  EXPECT_NEAR(object(build_scene(options, {}, g.motion, g.movement), "cup").size[1], 0.299, 1e-12);
  options.table.height = 0.11 - 0.301;
  const SceneObject cup = object(build_scene(options, {}, g.motion, g.movement), "cup");
  EXPECT_NEAR(cup.size[1], options.target.height, 1e-12);
  EXPECT_NEAR(cup.position[0].z(), 0.08, 1e-12) << "as without a table";
}

TEST(BuildScene, ACupIsCarriedUntilTheLastTransportEnds) {
  Grasping g;
  g.movement.phases.push_back({PhaseKind::transport, 6.5, 6.7, 1});
  g.movement.phases.push_back({PhaseKind::transport, 6.8, 6.9, 1});
  EXPECT_EQ(object(build_scene({}, {}, g.motion, g.movement), "cup").release_s, 6.9);
}

TEST(BuildScene, NoGraspNoTarget) {
  Grasping g;
  g.movement.phases.resize(1);
  EXPECT_THAT(names(build_scene({}, {}, g.motion, g.movement)), ElementsAre("table"));
  EXPECT_EQ(g.movement.target, "");
}

TEST(BuildScene, UnseenTipsGiveNoTarget) {
  Grasping g;
  for (std::size_t i = 0; i < g.motion.time.size(); ++i) g.motion.tip(i, 0) = unknown_point();
  EXPECT_THAT(names(build_scene({}, {}, g.motion, g.movement)), ElementsAre("table"));
  EXPECT_EQ(g.movement.target, "");
  for (Vec3& tip : g.motion.tip.values) tip = unknown_point();
  EXPECT_THAT(names(build_scene({}, {}, g.motion, g.movement)), testing::IsEmpty());
}

TEST(BuildScene, ATipHiddenInTheGraspIsWhereItArrived) {
  Grasping g;
  const Phase grasp = g.movement.phases.back();
  for (std::size_t i = 0; i < g.motion.time.size(); ++i) {
    if (g.motion.time[i] >= grasp.begin_s - 1e-9) g.motion.tip(i, 1) = unknown_point();
  }
  EXPECT_THAT(names(build_scene({}, {}, g.motion, g.movement)), ElementsAre("table", "cup"));
  EXPECT_EQ(g.movement.target, "cup");
}

TEST(BuildScene, ARecordedObjectIsTheTarget) {
  Grasping g;
  Demonstration demonstration;
  for (const double y : {0.6, 0.33}) {
    SceneObject o;
    o.name = y > 0.5 ? "far" : "near";
    o.shape = Shape::sphere;
    o.size = {0.03};
    o.time = {5, 7};
    o.position = {Vec3(0.2, y, 0.05), Vec3(0.2, y, 0.25)};
    o.orientation = {Quat::Identity(), Quat::Identity()};
    demonstration.objects.push_back(o);
  }
  const Scene scene = build_scene({}, demonstration, g.motion, g.movement);
  EXPECT_THAT(names(scene), ElementsAre("table", "far", "near"));
  EXPECT_EQ(g.movement.target, "near");
  EXPECT_EQ(object(scene, "near").position.size(), 2u);
  g.movement.target = "far";  // known already, from its motion
  build_scene({}, demonstration, g.motion, g.movement);
  EXPECT_EQ(g.movement.target, "far");
}

TEST(BuildScene, AnObjectOutOfTheHandsReachIsAnObstacleAndNoTarget) {
  Grasping g;
  Demonstration demonstration;
  SceneObject shelf;
  shelf.name = "shelf";
  shelf.size = {0.4, 0.2, 0.02};  // its edge 0.2 m behind the tips
  shelf.time = {5};
  shelf.position = {Vec3(0.2, 0.6, 0.08)};
  shelf.orientation = {Quat::Identity()};
  demonstration.objects = {shelf};
  EXPECT_THAT(names(build_scene({}, demonstration, g.motion, g.movement)),
              ElementsAre("table", "shelf", "cup"));
  EXPECT_EQ(g.movement.target, "cup");
  demonstration.objects[0].position[0].y() = 0.5;  // 0.1 m
  g.movement.target.clear();
  build_scene({}, demonstration, g.motion, g.movement);
  EXPECT_EQ(g.movement.target, "shelf");
  // What the inferred target would be called was recorded: no second one of that name.
  demonstration.objects[0].position[0].y() = 0.8;
  demonstration.objects[0].name = "cup";
  g.movement.target.clear();
  EXPECT_THAT(names(build_scene({}, demonstration, g.motion, g.movement)),
              ElementsAre("table", "cup"));
  EXPECT_EQ(g.movement.target, "cup");
}

TEST(BuildScene, ARecordedTableIsTheTable) {
  Grasping g;
  Demonstration demonstration;
  SceneObject table;
  table.name = "table";
  table.size = {1, 1, 0.04};
  table.time = {5};
  table.position = {Vec3(0.2, 0.6, -0.4)};
  table.orientation = {Quat::Identity()};
  demonstration.objects = {table};
  const Scene scene = build_scene({}, demonstration, g.motion, g.movement);
  EXPECT_THAT(names(scene), ElementsAre("table", "cup"));
  EXPECT_EQ(scene.objects[0].position[0].z(), -0.4);
}

TEST(MoveScene, MovesEveryPose) {
  Grasping g;
  Scene scene = build_scene({}, {}, g.motion, g.movement);
  scene.objects[0].time = {0, 1};
  scene.objects[0].position = {Vec3(1, 2, 3), Vec3(1, 2, 4)};
  scene.objects[0].orientation = {Quat::Identity(), Quat(0, 0, 0, 1)};
  // Quarter turn about z: (x, y, z) → (−y, x, z), then shifted.
  const Pose pose = make_pose(Vec3(10, 0, 0), Quat(std::sqrt(0.5), 0, 0, std::sqrt(0.5)));
  const Scene moved = transform_scene(scene, pose);
  EXPECT_TRUE(moved.objects[0].position[0].isApprox(Vec3(8, 1, 3), 1e-12));
  EXPECT_TRUE(moved.objects[0].position[1].isApprox(Vec3(8, 1, 4), 1e-12));
  const Vec3 x = moved.objects[0].orientation[0] * Vec3::UnitX();
  EXPECT_TRUE(x.isApprox(Vec3::UnitY(), 1e-12));
  const Vec3 x1 = moved.objects[0].orientation[1] * Vec3::UnitX();
  EXPECT_TRUE(x1.isApprox(-Vec3::UnitY(), 1e-12));
  EXPECT_EQ(moved.objects[1].size, scene.objects[1].size);
  EXPECT_EQ(moved.objects[1].attach_s, scene.objects[1].attach_s);
}

SceneOptions read(const std::string& yaml) {
  const config::ConfigNode node = config::ConfigNode::parse(yaml, "c.yaml");
  SceneOptions options;
  config::read_options(node, options);
  load_scene_files(options, node);
  node.require_all_keys_read();
  return options;
}

std::string error_of(const std::string& yaml) {
  try {
    read(yaml);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SceneOptions, ConfiguredObjectsStandInTheScene) {
  const SceneOptions options = read(
      "objects:\n"
      "  - {name: post, shape: cylinder, size: [0.02, 0.3], position: [0.1, 0.2, 0.15],\n"
      "     rpy: [0, 90 deg, 0]}\n"
      "  - {name: hidden, shape: sphere, size: [0.05], position: [1, 1, 1], avoid_in_mapping: "
      "false}\n");
  Grasping g;
  const Scene scene = build_scene(options, {}, g.motion, g.movement);
  EXPECT_THAT(names(scene), ElementsAre("post", "hidden", "table", "cup"));
  EXPECT_THAT(mapping_obstacles(options, scene), ElementsAre("table", "post"));
  const Vec3 axis = object(scene, "post").orientation[0] * Vec3::UnitZ();
  EXPECT_TRUE(axis.isApprox(Vec3::UnitX(), 1e-12));
}

TEST(SceneOptions, WrittenOptionsReadBackTheSame) {
  SceneOptions options;
  options.table.height = 0.01;
  ConfiguredObject post;
  post.name = "post";
  post.size = {0.1, 0.2, 0.3};
  post.position = Vec3(1, 2, 3);
  post.rpy = Vec3(0, 0, 1);
  post.avoid_in_mapping = false;
  options.objects = {post};
  const std::string written = config::write_options(options);
  EXPECT_EQ(config::write_options(read(written)), written);
}

/// Quarter turns, so that every position is known: the table's x is the base's y.
TEST(RelativeObjects, StandInTheFrameThatTheyName) {
  const Quat quarter(Eigen::AngleAxisd(90 * kRadPerDegree, Vec3::UnitZ()));
  WorldFrames frames;
  frames.base_from_world = make_pose(Vec3(1, 0, 0), quarter);
  frames.base_from_table = make_pose(Vec3(0.5, 0.2, 0.7), quarter);
  frames.base_from_target = make_pose(Vec3(0.4, 0.1, 0.8), Quat::Identity());
  frames.shoulder = Vec3(0, 0, 1.2);
  SceneOptions options = read(
      "objects:\n"
      "  - {name: a, shape: box, size: [0.2, 0.4, 0.1], relative_to: table, anchor: bottom_centre,"
      " position: [0.1, 0, 0], rpy: [0, 0, 90 deg]}\n"
      "  - {name: b, shape: sphere, size: [0.1], relative_to: target, position: [0.3, 0, 0]}\n"
      "  - {name: c, shape: sphere, size: [0.1], relative_to: shoulder, position: [0.3, 0, 0]}\n"
      "  - {name: d, shape: sphere, size: [0.1], relative_to: base, position: [0.3, 0, 0]}\n"
      "  - {name: e, shape: sphere, size: [0.1], position: [0.3, 0, 0]}\n");
  Scene scene;
  EXPECT_EQ(add_relative_objects(options, frames, 5, scene), "");
  ASSERT_THAT(names(scene), ElementsAre("a", "b", "c", "d"));
  EXPECT_TRUE(object(scene, "a").position[0].isApprox(Vec3(0.5, 0.3, 0.75), 1e-12));
  EXPECT_NEAR(angle_between(object(scene, "a").orientation[0], quarter * quarter), 0, 1e-7);
  EXPECT_TRUE(object(scene, "b").position[0].isApprox(Vec3(0.7, 0.1, 0.8), 1e-12));
  EXPECT_TRUE(object(scene, "c").position[0].isApprox(Vec3(0, 0.3, 1.2), 1e-12));
  EXPECT_TRUE(object(scene, "d").position[0].isApprox(Vec3(0.3, 0, 0), 1e-12));

  frames.base_from_target = unknown_pose();
  EXPECT_EQ(add_relative_objects(options, frames, 5, scene),
            "b is placed relative to the target, which does not exist in this movement");
  EXPECT_THAT(error_of("table: {infer: false}\nobjects: [{name: a, shape: sphere, size: [1], "
                       "relative_to: table, position: [0, 0, 0]}]"),
              HasSubstr("a is relative_to: table, but table.infer is false"));
}

TEST(SceneOptions, PositionsInMillimetresAreNoticed) {
  EXPECT_THAT(error_of("objects: [{name: a, shape: sphere, size: [0.1], position: [400, 0, 0]}]"),
              HasSubstr("position[0]: must be at least -20 and at most 20 m, not 400"));
}

TEST(SceneOptions, ErrorsNameFileLineAndKey) {
  const auto with = [](const std::string& body) {
    return "table: {infer: true}\nobjects:\n  - {name: a, position: [0, 0, 0], " + body + "}\n";
  };
  EXPECT_EQ(error_of(with("shape: box, size: [1, 1, 1]")), "");
  EXPECT_THAT(error_of(with("shape: cone, size: [1]")),
              testing::StartsWith("c.yaml:3: objects[0].shape: must be sphere, box, "));
  EXPECT_THAT(error_of(with("shape: mesh")),
              testing::StartsWith("c.yaml:3: objects[0]: file: required for a mesh"));
  EXPECT_THAT(error_of(with("shape: mesh, file: nowhere.stl")),
              testing::StartsWith("c.yaml:3: objects[0].file: nowhere.stl cannot be read"));
  EXPECT_THAT(error_of(with("shape: mesh, file: cup.step")), HasSubstr("STL, OBJ, DAE or glTF"));
  EXPECT_THAT(error_of(with("shape: convex, file: a.stl, scale: 0")), HasSubstr("scale"));
  EXPECT_THAT(error_of(with("shape: sphere, size: [1], file: a.stl")),
              HasSubstr("not allowed for a sphere"));
  EXPECT_THAT(error_of(with("shape: box, size: [1, -1, 1]")),
              testing::StartsWith("c.yaml:3: objects[0].size[1]: must be above 0"));
  EXPECT_THAT(error_of(with("shape: sphere, size: [1, 1]")),
              testing::StartsWith("c.yaml:3: objects[0].size: a sphere needs 1 number,"));
  EXPECT_THAT(error_of(with("shape: box")), HasSubstr("size"));
  EXPECT_THAT(error_of("target: {max_radius: 0.001}"), HasSubstr("max_radius"));
  EXPECT_THAT(error_of("table: {thickness: 0}"), HasSubstr("c.yaml:1: table.thickness"));
  EXPECT_THAT(error_of("objects: [{name: cup, shape: sphere, size: [1], position: [0, 0, 0]}]"),
              HasSubstr("the name 'cup' is already used"));
  EXPECT_THAT(error_of("tabel: {}"), HasSubstr("tabel"));
  EXPECT_THAT(error_of("file: nowhere.yaml"), HasSubstr("nowhere.yaml"));
}

TEST(SceneOptions, EveryShippedSceneLoads) {
  const std::filesystem::path folder = std::filesystem::path(MORPHE_SOURCE_DIR) / "configs/scenes";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    const SceneOptions options = read("file: " + entry.path().string());
    EXPECT_FALSE(options.file_objects.empty()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 1);
}

class MeshFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("morphe_meshes_") +
               testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  static std::string object_of(const std::string& shape, const std::string& file) {
    return "objects:\n  - name: a\n    position: [1, 2, 3]\n    shape: " + shape +
           "\n    scale: 0.001\n    file: " + file + "\n";
  }
  const std::string kPyramid =
      "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 50 50 80\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\n"
      "f 3 4 5\nf 4 1 5\n";
  std::filesystem::path folder_;
};

TEST_F(MeshFiles, StandInTheSceneInMetres) {
  Grasping g;
  for (const char* shape : {"mesh", "convex"}) {
    const SceneOptions options = read(object_of(shape, write("pyramid.obj", kPyramid)));
    const Scene scene = build_scene(options, {}, g.motion, g.movement);
    const SceneObject& mesh = object(scene, "a");
    EXPECT_EQ(mesh.shape, Shape::mesh);
    EXPECT_EQ(mesh.triangles.size(), 6u);
    EXPECT_EQ(mesh.position[0], Vec3(1, 2, 3));
    Vec3 high = Vec3::Zero();
    for (const Vec3& vertex : mesh.vertices) high = high.cwiseMax(vertex);
    EXPECT_TRUE(high.isApprox(Vec3(0.1, 0.1, 0.08), 1e-7));
  }
}

TEST_F(MeshFiles, ConvexFillsWhatIsHollow) {
  // A tetrahedron and a point inside it.
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.1 0.1 0.1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  const SceneOptions options = read(object_of("convex", write("star.obj", text)));
  EXPECT_EQ(options.objects[0].mesh.vertices.size(), 4u);
  EXPECT_EQ(options.objects[0].mesh.triangles.size(), 4u);
  EXPECT_THAT(error_of(object_of("convex", write("flat.obj",
                                                 "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n"
                                                 "f 1 2 3\nf 2 4 3\n"))),
              HasSubstr("the mesh is flat"));
}

TEST_F(MeshFiles, BrokenOnesAreNamedWithFileAndKey) {
  const auto error = [&](const std::string& name, const std::string& text) {
    return error_of(object_of("mesh", write(name, text)));
  };
  for (const std::string& wrong :
       {error("empty.stl", ""), error("noise.stl", "solid x\nfacet nor"), error("empty.obj", ""),
        error("points.obj", "v 0 0 0\nv 1 0 0\n"), error("cut.stl", std::string(83, '\x01')),
        error("short.stl",
              std::string(80, 'x') + std::string("\x0c\0\0\0", 4) + std::string(5 * 50, '\0')),
        error("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 1 2\nf 3 3 3\n"),
        error("dot.obj", "v 0 0 0\nv 1e-7 0 0\nv 0 1e-7 0\nf 1 2 3\n"),
        error("index.obj", "v 0 0 0\nf 1 2 3\n"),
        error("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")}) {
    EXPECT_THAT(wrong, testing::StartsWith("c.yaml:6: objects[0].file: "));
    EXPECT_THAT(wrong, HasSubstr(folder_.string()));
  }
}

TEST_F(MeshFiles, MillimetresTakenForMetresAreNoticed) {
  const std::string file = write("pyramid.obj", kPyramid);  // 100 wide
  const std::string unscaled =
      "objects: [{name: a, shape: mesh, position: [0, 0, 0], file: " + file;
  EXPECT_THAT(
      error_of(unscaled + "}]\n"),
      testing::AllOf(testing::StartsWith("c.yaml:1: objects[0].file: "),
                     HasSubstr("100 m long: give scale: 0.001 if its numbers are mm (0.1 m)")));
  EXPECT_EQ(error_of(unscaled + ", scale: 1}]\n"), "");
  EXPECT_EQ(error_of(unscaled + ", scale: 0.01}]\n"), "");
}

TEST_F(MeshFiles, MetresTakenForMillimetresAreNoticed) {
  const std::string text =
      "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  EXPECT_THAT(error_of(object_of("mesh", write("small.obj", text))),
              HasSubstr("0.1 mm long with scale: 0.001: omit scale"));
}

TEST_F(MeshFiles, AreTargetsThatStandWhereTheyAreHeld) {
  Grasping g;
  const std::string body = "target: {body: {file: " + write("pyramid.obj", kPyramid);
  const SceneOptions options =
      read(body + ", scale: 0.001, rpy: [0, 0, 90 deg]}}\ntable: {height: 0.01}\n");
  const Scene scene = build_scene(options, {}, g.motion, g.movement);
  EXPECT_EQ(g.movement.target, "cup");
  const SceneObject& target = object(scene, "cup");
  EXPECT_EQ(target.shape, Shape::mesh);
  EXPECT_EQ(options.meshes.size(), 1u);
  // Turned by a quarter its corner at the origin is the right one: x spans [-0.1, 0], y [0, 0.1].
  EXPECT_TRUE(target.position[0].isApprox(Vec3(0.2 + 0.05, 0.3 - 0.05, 0.01), 1e-7));
  EXPECT_EQ(target.attach_s, 6.5);

  const SceneOptions held =
      read(body + ", scale: 0.001, grasp_point: [0.1, 0]}}\ntable: {height: 0.01}\n");
  Grasping again;
  const Scene other = build_scene(held, {}, again.motion, again.movement);
  EXPECT_TRUE(object(other, "cup").position[0].isApprox(Vec3(0.1, 0.3, 0.01), 1e-7));

  EXPECT_THAT(error_of(body + "}}\n"),
              testing::AllOf(testing::StartsWith("c.yaml:1: target.body.file: "),
                             HasSubstr("100 m long: give scale: 0.001")));
  EXPECT_THAT(error_of(body + ", scale: 0.001, grasp_point: [1]}}\n"),
              HasSubstr("grasp_point: needs x and y"));
  EXPECT_THAT(error_of("target: {body: {size: [1]}}"), HasSubstr("file: required for a mesh"));
  EXPECT_THAT(error_of("target: {radius: 0.1, body: {shape: sphere, size: [0.1]}}"),
              HasSubstr("radius: not allowed together with body, which has its own size"));
}

TEST_F(MeshFiles, GiveARecordedTargetItsShapeInItsFrame) {
  Grasping g;
  Demonstration recorded;
  SceneObject box;
  box.name = "box";
  box.shape = Shape::box;
  box.size = {0.1, 0.1, 0.1};
  box.time = {5, 7};
  box.position = {Vec3(0.2, 0.3, 0.05), Vec3(0.2, 0.3, 0.25)};
  box.orientation.resize(2, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())));
  recorded.objects = {box};
  const SceneOptions options =
      read("target: {body: {scale: 0.001, rpy: [0, 0, 1], file: " + write("pyramid.obj", kPyramid) +
           "}}\n");
  const Scene scene = build_scene(options, recorded, g.motion, g.movement);
  EXPECT_EQ(g.movement.target, "box");
  const SceneObject& target = object(scene, "box");
  EXPECT_EQ(target.shape, Shape::mesh);
  EXPECT_TRUE(target.size.empty());
  EXPECT_EQ(target.vertices.size(), 5u);
  EXPECT_EQ(target.position, box.position);
  EXPECT_TRUE(target.orientation[0].isApprox(box.orientation[0]));
}

/// What a file leaves out where nothing fits through is closed, a wide opening is not.
TEST_F(MeshFiles, SmallHolesAreClosed) {
  const auto read_open = [&](const std::string& name, const std::string& text) {
    return collision::is_open(*read(object_of("mesh", write(name, text))).meshes.at(0).solid);
  };
  EXPECT_FALSE(read_open("whole.obj", kPyramid));
  EXPECT_TRUE(read_open("side.obj", kPyramid.substr(0, kPyramid.size() - 8)));
  // A triangle of a side 100 mm wide is split off, 3 mm wide, and missing.
  const std::string slit = kPyramid.substr(0, kPyramid.size() - 8) + "v 0 97 0\nf 6 1 5\n";
  EXPECT_FALSE(read_open("slit.obj", slit));
}

TEST_F(MeshFiles, APlanningSceneOfMoveItIsASceneFile) {
  const std::string file = write("scene.yaml",
                                 "world: {collision_objects: [{id: shelf, primitives: [{type: box, "
                                 "dimensions: [1, 2, 3]}], primitive_poses: [{position: [4, 5, 6], "
                                 "orientation: [0, 0, 1, 0]}]}]}\n");
  const SceneOptions options = read("file: " + file);
  Grasping g;
  const Scene scene = build_scene(options, {}, g.motion, g.movement);
  EXPECT_EQ(object(scene, "shelf").size, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(object(scene, "shelf").position[0], Vec3(4, 5, 6));
  EXPECT_NEAR(std::abs(object(scene, "shelf").orientation[0].z()), 1, 1e-12);
}

}  // namespace
}  // namespace morphe::scene
