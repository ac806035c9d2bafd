// MJCF files written by hand in the ways that robots use: the URDF made of each has the forward
// kinematics that MuJoCo computes from the MJCF itself.
#include <gmock/gmock.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "core/motion/input_error.hpp"
#include "core/physics/model.hpp"
#include "core/robot/files/mjcf_urdf.hpp"
#include "core/robot/files/urdf_model.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "tests/core/robot/files/written_urdf.hpp"

#if __has_include(<mujoco/mujoco.h>)
#include <mujoco/mujoco.h>
#endif

namespace morphe::robot {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

namespace fs = std::filesystem;

constexpr double kTolerance = 1e-9;  // m, and of entries of rotation matrices

fs::path mjcf_folder() { return fs::path(MORPHE_SOURCE_DIR) / "tests/data/mjcf"; }

std::vector<std::string> mjcf_names() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(mjcf_folder()))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

MjcfModel shipped_mjcf(const std::string& name) {
  return read_mjcf(mjcf_folder() / (name + ".xml"));
}

/// The URDF of an MJCF, written and read again.
struct Converted {
  MjcfModel mjcf;
  MjcfUrdf urdf;
  UrdfModel model;
};
Converted converted(MjcfModel mjcf) {
  MjcfUrdf urdf = urdf_of(mjcf, robot_folder());
  UrdfModel model = load_urdf_model(write_text("converted.urdf", urdf.text));
  return {std::move(mjcf), std::move(urdf), std::move(model)};
}
Converted converted(const std::string& name) { return converted(shipped_mjcf(name)); }

/// Returns random positions of the URDF's joints within their limits.
JointVector random_posture(const RobotModel& table, std::mt19937& random) {
  JointVector q(table.lower.size());
  for (Eigen::Index k = 0; k < q.size(); ++k)
    q[k] = std::uniform_real_distribution(table.lower[k], table.upper[k])(random);
  return q;
}

/// Returns the position of a joint of the MJCF: the URDF's, or what its coupling says.
double position_of(const Converted& robot, const MjcfJoint& joint, const JointVector& q) {
  if (joint.coupling) {
    const auto& [driver, ratio, offset] = *joint.coupling;
    if (driver.empty()) return offset;
    return offset + ratio * position_of(robot, *find_joint(robot.mjcf, driver), q);
  }
  const auto& names = robot.model.table.joint_names;
  return q[std::ranges::find(names, joint.name) - names.begin()];
}

/// Returns the poses of all bodies in the MJCF's world, by the URDF.
std::map<std::string, Pose> body_poses(const Converted& robot, const JointVector& q) {
  std::vector<Pose> frames;
  forward_kinematics(robot.model.table, q, frames);
  std::map<std::string, Pose> poses;
  for (const auto& [body, link_from_body] : robot.urdf.link_from_body) {
    poses[body] = robot.urdf.world_from_root *
                  frames[static_cast<std::size_t>(robot.model.links.at(body))] * link_from_body;
  }
  return poses;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

#if __has_include(<mujoco/mujoco.h>)
/// A model that MuJoCo itself reads from the file.
class MuJoCo {
 public:
  /// MuJoCo 2 does not know yet that a range limits a joint.
  explicit MuJoCo(const std::string& name) {
    const fs::path folder = robot_folder() / "mujoco";
    fs::copy(mjcf_folder(), folder,
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    std::string text = text_of(folder / (name + ".xml"));
    text.insert(text.rfind("</mujoco>"), "<compiler autolimits=\"true\"/>");
    std::ofstream(folder / (name + ".xml")) << text;
    char error[1000] = "";
    model_ = mj_loadXML((folder / (name + ".xml")).c_str(), nullptr, error, sizeof error);
    message = error;
    if (model_) data_ = mj_makeData(model_);
  }
  MuJoCo(const MuJoCo&) = delete;
  ~MuJoCo() {
    if (data_) mj_deleteData(data_);
    if (model_) mj_deleteModel(model_);
  }
  std::string message;
  explicit operator bool() const { return model_ != nullptr; }

  void move(const Converted& robot, const JointVector& q) {
    for (const MjcfBody& body : robot.mjcf.bodies) {
      const int body_id = id(mjOBJ_BODY, body.name);
      if (body_id < 0) continue;  // unnamed
      int k = model_->body_jntadr[body_id];
      for (const MjcfJoint& joint : body.joints) {
        while (model_->jnt_type[k] != mjJNT_HINGE && model_->jnt_type[k] != mjJNT_SLIDE) ++k;
        data_->qpos[model_->jnt_qposadr[k++]] = position_of(robot, joint, q);
      }
    }
    set_joints_of_unnamed_bodies(robot, q);
    mj_kinematics(model_, data_);
  }
  int id(int kind, const std::string& name) const { return mj_name2id(model_, kind, name.c_str()); }
  Pose body(int id) const { return pose(data_->xpos + 3 * id, data_->xmat + 9 * id); }
  Pose geom(int id) const { return pose(data_->geom_xpos + 3 * id, data_->geom_xmat + 9 * id); }
  Pose site(int id) const { return pose(data_->site_xpos + 3 * id, data_->site_xmat + 9 * id); }

 private:
  /// Joints are in the file's order in both, if no surroundings are left out.
  void set_joints_of_unnamed_bodies(const Converted& robot, const JointVector& q) {
    std::vector<const MjcfJoint*> joints;
    for (const MjcfBody& body : robot.mjcf.bodies)
      for (const MjcfJoint& joint : body.joints) joints.push_back(&joint);
    for (int k = 0; k < model_->njnt; ++k) {
      if (mj_id2name(model_, mjOBJ_BODY, model_->jnt_bodyid[k])) continue;
      data_->qpos[model_->jnt_qposadr[k]] =
          position_of(robot, *joints[static_cast<std::size_t>(k)], q);
    }
  }

  static Pose pose(const double* position, const double* matrix) {
    Pose pose = Pose::Identity();
    pose.translation() = Vec3(position[0], position[1], position[2]);
    pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(matrix);
    return pose;
  }
  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
};

/// Those that the installed MuJoCo cannot read have a test of their own below.
const std::set<std::string> kNewerThanMuJoCo2 = {"29_frames", "30_new_attributes"};

/// Returns the names of the files that it can read.
std::vector<std::string> names_for_mujoco_2() {
  std::vector<std::string> names = mjcf_names();
  std::erase_if(names, [](const std::string& name) { return kNewerThanMuJoCo2.contains(name); });
  return names;
}

class MjcfKinematics : public testing::TestWithParam<std::string> {};

TEST_P(MjcfKinematics, AreThoseOfMuJoCo) {
  MuJoCo expected(GetParam());
  ASSERT_TRUE(expected) << expected.message;
  const Converted robot = converted(GetParam());
  std::mt19937 random(7);
  int compared = 0;
  for (int posture = 0; posture < 5; ++posture) {
    const JointVector q = random_posture(robot.model.table, random);
    expected.move(robot, q);
    const std::map<std::string, Pose> poses = body_poses(robot, q);
    for (const MjcfBody& body : robot.mjcf.bodies) {
      const Pose& pose = poses.at(body.name);
      const int id = expected.id(mjOBJ_BODY, body.name);
      if (id >= 0) {
        EXPECT_LT((expected.body(id).matrix() - pose.matrix()).cwiseAbs().maxCoeff(), kTolerance)
            << body.name;
        ++compared;
      }
      for (const MjcfGeom& geom : body.geoms) {
        const int geom_id = expected.id(mjOBJ_GEOM, geom.name);
        if (geom.name.empty() || geom_id < 0) continue;
        const Pose ours = pose * geom.shape.link_from_shape, theirs = expected.geom(geom_id);
        EXPECT_LT((ours.translation() - theirs.translation()).norm(), kTolerance) << geom.name;
        const bool round = geom.shape.kind != Shape::box;
        if (!round) {
          EXPECT_LT((ours.linear() - theirs.linear()).cwiseAbs().maxCoeff(), kTolerance)
              << geom.name;
        } else if (geom.name != "egg") {  // an ellipsoid has another axis
          EXPECT_GT(std::abs(ours.linear().col(2).dot(theirs.linear().col(2))), 1 - kTolerance);
        }
      }
      for (const MjcfSite& site : body.sites) {
        const Pose theirs = expected.site(expected.id(mjOBJ_SITE, site.name));
        EXPECT_LT(((pose * site.body_from_site).matrix() - theirs.matrix()).cwiseAbs().maxCoeff(),
                  kTolerance)
            << site.name;
      }
    }
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Files, MjcfKinematics, testing::ValuesIn(names_for_mujoco_2()),
                         [](const auto& parameter) { return parameter.param; });
#endif

double largest_difference(const Converted& one, const Converted& other) {
  std::mt19937 random(3);
  double largest = 0;
  for (int posture = 0; posture < 5; ++posture) {
    const JointVector q = random_posture(one.model.table, random);
    const auto poses = body_poses(one, q), others = body_poses(other, q);
    for (const auto& [body, pose] : poses)
      largest = std::max(largest, (pose.matrix() - others.at(body).matrix()).cwiseAbs().maxCoeff());
  }
  return largest;
}

Converted written_mjcf(const std::string& text) {
  return converted(read_mjcf(write_text("written.xml", text)));
}

TEST(Mjcf, FramesAreAppliedToAllThatTheyContain) {
  // The poses of 29_frames.xml, multiplied by hand: bodies in bodies instead of frames.
  const Converted nested = written_mjcf(R"(<mujoco><compiler angle="radian"/><worldbody>
    <body name="base" pos="0.5 0 0" euler="0 0 0.4"><geom size="0.05"/>
      <body name="frame1" pos="0 0 0.1" euler="0.2 0 0">
        <body name="arm" pos="0.1 0 0" euler="0 0.3 0"><joint name="j" axis="0 1 0"/><geom size="0.02"/>
          <body name="frame2" euler="0 0 0.5"><body name="frame3" pos="0 0.1 0">
            <body name="hand"><joint name="k" axis="1 0 0" pos="0 0 0.02"/><geom size="0.02"/></body>
          </body></body>
        </body>
      </body>
    </body></worldbody></mujoco>)");
  EXPECT_LT(largest_difference(converted("29_frames"), nested), 1e-12);
  const MjcfModel frames = shipped_mjcf("29_frames");
  const MjcfGeom& brick = frames.bodies[0].geoms[1];
  EXPECT_LT((brick.shape.link_from_shape.translation() - Vec3(0.1, 0, 0.1)).norm(), 1e-12);
}

TEST(Mjcf, AttributesOfNewerVersionsAreReadOrIgnored) {
  const Converted plain = written_mjcf(R"(<mujoco><compiler angle="radian"/><worldbody>
    <body name="base"><body name="arm" pos="0 0 0.1"><joint name="j" axis="0 1 0" range="-1 1"/>
      <body name="hand" pos="0 0 0.2"><joint name="k" axis="1 0 0" range="-2 2"/></body>
    </body></body></worldbody></mujoco>)");
  const Converted robot = converted("30_new_attributes");
  EXPECT_LT(largest_difference(robot, plain), 1e-12);
  EXPECT_EQ(find_joint(robot.mjcf, "j")->effort, 25);  // the smaller one of joint and actuator
  EXPECT_EQ(find_joint(robot.mjcf, "k")->effort, 5);
}

TEST(Mjcf, ThePoseOfAnOffsetHingeIsTheOneComputedByHand) {
  const Converted robot = converted("01_slide_and_hinge");
  const JointVector q = JointVector{{0.1, 0.5}};
  const Vec3 b = body_poses(robot, q).at("b").translation();
  EXPECT_NEAR(b.x(), 0.2 + 0.05 - 0.05 * std::cos(0.5), 1e-12);
  EXPECT_NEAR(b.z(), 0.2 + 0.05 * std::sin(0.5), 1e-12);
}

TEST(Mjcf, LimitsFollowRangeAndLimited) {
  const MjcfModel model = shipped_mjcf("31_limits");
  using Range = std::array<double, 2>;
  EXPECT_EQ(find_joint(model, "by_range")->range, (Range{-1, 2}));
  EXPECT_FALSE(find_joint(model, "free_of_it")->range);
  EXPECT_FALSE(find_joint(model, "without")->range);
  EXPECT_EQ(find_joint(model, "slide")->range, (Range{-0.1, 0.25}));
  const Converted robot = converted("31_limits");
  EXPECT_EQ(robot.model.joint("without")->kind, JointKind::continuous);
  EXPECT_EQ(robot.model.joint("by_range")->upper, 2);
  EXPECT_FALSE(robot.model.joint("by_range")->velocity);  // an MJCF has none
  const MjcfModel degrees = shipped_mjcf("02_degrees");
  EXPECT_NEAR((*find_joint(degrees, "bend")->range)[0], -20.5 * kRadPerDegree, 1e-15);
}

TEST(Mjcf, RangesThatLookLikeRadiansWithoutAUnitAreToBeChecked) {
  const std::string text = R"(<mujoco><worldbody><body name="l1" pos="0 0 0.1">
      <joint name="a1" axis="0 0 1" range="-2.9 2.9"/></body></worldbody></mujoco>)";
  const fs::path file = write_text("unit.xml", text);
  EXPECT_THAT(read_mjcf(file).to_check,
              Contains(HasSubstr("angles are in degrees, MuJoCo's default (joint a1 turns from "
                                 "-2.9 to 2.9 deg)")));
  EXPECT_THAT(shipped_mjcf("24_joint_on_the_world").to_check, IsEmpty());
  EXPECT_THAT(shipped_mjcf("31_limits").to_check, IsEmpty());
}

TEST(Mjcf, EffortsComeFromActuators) {
  const MjcfModel motors = shipped_mjcf("28_motors");
  EXPECT_EQ(find_joint(motors, "ja")->effort, 20);
  EXPECT_EQ(find_joint(motors, "jb")->effort, 20);
  EXPECT_FALSE(find_joint(motors, "jc")->effort);  // a velocity's command is not a force
  EXPECT_FALSE(find_joint(motors, "jd")->effort);
  EXPECT_EQ(find_joint(shipped_mjcf("27_arm_as_published"), "elbow_joint")->effort, 150);
  EXPECT_EQ(find_joint(shipped_mjcf("27_arm_as_published"), "wrist_1_joint")->effort, 28);
}

TEST(Mjcf, JointsWithoutAnActuatorAreToBeChecked) {
  EXPECT_THAT(shipped_mjcf("28_motors").to_check,
              testing::ElementsAre(HasSubstr("have no actuator, but are taken as driven: jd")));
  // Couplings and tendons drive joints too, and a file without actuators does not say.
  for (const char* name : {"18_gripper_with_tendon", "16_coupled_joints", "27_arm_as_published"})
    EXPECT_THAT(shipped_mjcf(name).to_check, IsEmpty()) << name;
}

/// A four-bar linkage whose coupler is free to turn, but held at its limit by a spring, as that of
/// an underactuated gripper. `anchor` is the pin of the coupler in the follower's frame.
std::string linkage(const std::string& anchor) {
  return fmt::format(R"(<mujoco><compiler angle="radian"/><default><joint axis="1 0 0"/></default>
    <worldbody><body name="base">
      <body name="driver" pos="0 0.03 0.05"><joint name="drive" range="0 0.8"/>
        <body name="coupler" pos="0 0.03 0"><joint name="couple" range="-1.5 0"/></body></body>
      <body name="link" pos="0 0.01 0.06"><joint name="swing" range="-1 1" stiffness="0.1" springref="2.6"/>
        <body name="follower" pos="0 0.04 0.045"><joint name="follow" range="-1.5 1.5"/></body></body>
    </body></worldbody>
    <equality><connect body1="follower" body2="coupler" anchor="{}"/></equality>
    <actuator><motor joint="drive"/></actuator></mujoco>)",
                     anchor);
}

TEST(Mjcf, TheLoopOfAParallelogramIsClosedByCouplings) {
  const MjcfModel model = read_mjcf(write_text("loop.xml", linkage("0 0.02 -0.01")));
  // The pins of driver and link are (0.02, -0.01) apart too, so their arms are parallel and equal.
  const auto coupling = [&](const char* name) { return find_joint(model, name)->coupling.value(); };
  EXPECT_EQ(coupling("swing").driver, "drive");
  EXPECT_NEAR(coupling("swing").ratio, 1, 1e-4);
  EXPECT_NEAR(coupling("swing").offset, 0, 1e-4);
  EXPECT_NEAR(coupling("follow").ratio, -1, 1e-4);
  EXPECT_EQ(coupling("couple").driver, "");  // at its limit, where the spring pushes it
  EXPECT_NEAR(coupling("couple").offset, 0, 1e-4);
  EXPECT_THAT(model.notes, IsEmpty());
  EXPECT_THAT(model.to_check, testing::ElementsAre(HasSubstr(
                                  "the loop follower-coupler follows drive along straight lines")));
  const Converted robot = converted(model);
  EXPECT_EQ(robot.model.table.joint_names, std::vector<std::string>{"drive"});
}

TEST(Mjcf, ALoopThatIsFarFromStraightLinesStaysOpen) {
  const MjcfModel model = read_mjcf(write_text("loop.xml", linkage("0 -0.015 0.01")));
  EXPECT_THAT(model.notes, Contains(HasSubstr("closed loops are left open")));
  EXPECT_THAT(model.to_check, Contains(HasSubstr("no actuator, but are taken as driven: couple, "
                                                 "swing, follow")));
  EXPECT_FALSE(find_joint(model, "swing")->coupling);
}

TEST(Mjcf, AnUnderactuatedGripperHasOneJoint) {
  const Converted robot = converted("33_linkage_gripper");
  EXPECT_EQ(robot.model.table.joint_names, std::vector<std::string>{"left_driver_joint"});
}

TEST(Mjcf, PartsThatAUrdfCannotExpressAreNamed) {
  EXPECT_THAT(shipped_mjcf("14_free_base").notes,
              Contains(HasSubstr("14_free_base.xml:7: floating_base is a free joint")));
  EXPECT_THAT(shipped_mjcf("15_ball_joint").notes, Contains(HasSubstr("gaze is a ball joint")));
  EXPECT_THAT(shipped_mjcf("17_held_and_nonlinear").notes,
              Contains(HasSubstr("joint curved: only the constant and the linear coefficient")));
  EXPECT_THAT(shipped_mjcf("18_gripper_with_tendon").notes, IsEmpty());  // the equality suffices
  EXPECT_THAT(shipped_mjcf("26_hand").notes,
              Contains(HasSubstr("A_FFJ0 (FFJ2, FFJ1), A_MFJ0 (MFJ2, MFJ1)")));
  EXPECT_THAT(shipped_mjcf("26_hand").notes,
              Contains(HasSubstr("command less than the joint's range, which is taken: THJ5")));
  const std::vector<std::string> notes = shipped_mjcf("23_two_arms_and_surroundings").notes;
  EXPECT_THAT(notes, Contains(HasSubstr("(bodies without a joint): table, cup")));
  EXPECT_THAT(notes, Contains(HasSubstr("1 shape of the world itself")));
  const MjcfModel loop = read_mjcf(write_text("loop.xml", R"(<mujoco><worldbody>
    <body name="a"><joint name="j"/><body name="b"><joint name="k"/></body></body></worldbody>
    <equality><connect body1="a" body2="b" anchor="0 0 0"/><joint joint1="j" joint2="k"/>
      <joint joint1="k" joint2="j"/></equality></mujoco>)"));
  EXPECT_THAT(loop.notes,
              Contains(HasSubstr("closed loops are left open, as a URDF is a tree: a-b")));
  EXPECT_THAT(loop.notes, Contains(HasSubstr("joint k: is left out, as joint j already follows")));
}

TEST(Mjcf, ShapesKeepTheirSizesAndRoles) {
  const Converted robot = converted("20_shapes");
  const auto shapes = [&](const std::string& link, bool visual) {
    std::vector<UrdfShape> found;
    for (const UrdfShape& shape : robot.model.shapes)
      if (shape.link == link && shape.visual == visual) found.push_back(shape);
    return found;
  };
  ASSERT_EQ(shapes("base", false).size(), 1u);
  EXPECT_EQ(shapes("base", false)[0].kind, Shape::cylinder);
  EXPECT_EQ(shapes("base", false)[0].size, Vec3(0.1, 0.04, 0));
  ASSERT_EQ(shapes("base", true).size(), 1u);
  EXPECT_EQ(shapes("base", true)[0].size, Vec3(0.2, 0.2, 0.04));
  // A capsule is a cylinder with a ball at each end, which is what the URDF's reader takes for one.
  EXPECT_EQ(shapes("arm", false).size(), 1u + 3u + 3u);
  EXPECT_EQ(shapes("finger", false).size(), 2u);
  EXPECT_EQ(shapes("finger", true).size(), 1u);  // group 3 is not shown
}

TEST(Mjcf, AnEllipsoidIsWithinItsCapsule) {
  const MjcfModel model = shipped_mjcf("20_shapes");
  const MjcfGeom& egg = *std::ranges::find(model.bodies[1].geoms, "egg", &MjcfGeom::name);
  ASSERT_EQ(egg.shape.kind, Shape::capsule);
  const Vec3 axes(0.02, 0.05, 0.03);
  const Pose body_from_egg = make_pose(
      Vec3(0.1, 0, 0),
      Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()) * Eigen::AngleAxisd(0.2, Vec3::UnitZ())));
  double farthest = 0;
  for (int i = 0; i < 400; ++i) {
    const double z = -1 + 2 * (i + 0.5) / 400, angle = 2.399963 * i, r = std::sqrt(1 - z * z);
    const Vec3 point = egg.shape.link_from_shape.inverse() * body_from_egg *
                       Vec3(axes.cwiseProduct(Vec3(r * std::cos(angle), r * std::sin(angle), z)));
    const double half = 0.5 * egg.shape.size.y();
    const Vec3 nearest(0, 0, std::clamp(point.z(), -half, half));
    farthest = std::max(farthest, (point - nearest).norm() - egg.shape.size.x());
  }
  EXPECT_LT(farthest, 1e-12);
  EXPECT_GT(farthest, -1e-4);  // and touches it
}

TEST(Mjcf, MeshesAreFoundScaledAndMirrored) {
  const Converted robot = converted("21_meshes");
  const fs::path brick = mjcf_folder() / "meshes/brick.stl";
  ASSERT_EQ(robot.model.shapes.size(), 5u);
  for (const UrdfShape& shape : robot.model.shapes)
    EXPECT_TRUE(fs::equivalent(robot_folder() / shape.mesh, brick)) << shape.mesh;
  EXPECT_EQ(robot.model.shapes[1].size, Vec3(0.001, -0.001, 0.001));
  // refpos is subtracted, then refquat turned back, then scaled.
  const UrdfShape& large = robot.mjcf.bodies[2].geoms[0].shape;
  const Vec3 vertex(40, 20, 60);
  const Vec3 expected = 0.002 * Vec3(20, -(40 - 10), 60);
  EXPECT_LT((large.link_from_shape * Vec3(large.size.cwiseProduct(vertex)) - expected).norm(),
            1e-12);
}

TEST(Mjcf, InertiasAreKept) {
  const Converted robot = converted("27_arm_as_published");
  const UrdfInertia& upper = robot.model.inertias.at("upper_arm_link");
  EXPECT_EQ(upper.mass, 8.4);
  EXPECT_EQ(upper.inertia(0, 1), 0.001);
  EXPECT_EQ(upper.inertia(1, 2), 0.003);
  EXPECT_LT((upper.link_from_inertia.translation() - Vec3(0, 0, 0.2125)).norm(), 1e-12);
}

struct MjcfFault {
  std::string name, from, to, message;
};
class MjcfError : public testing::TestWithParam<MjcfFault> {};

constexpr const char* kGoodMjcf = R"(<mujoco model="faults">
  <compiler angle="radian" eulerseq="xyz"/>
  <default>
    <default class="part"><joint axis="0 1 0"/></default>
  </default>
  <asset><mesh name="m" file="m.stl"/></asset>
  <worldbody>
    <body name="a" childclass="part" pos="0 0 1">
      <joint name="j" range="-1 1"/>
      <geom name="g" type="box" size="1 1 1"/>
    </body>
    <body name="b"><joint name="k" type="slide" axis="0 0 1"/></body>
  </worldbody>
  <equality><joint joint1="j" joint2="k"/></equality>
  <actuator><motor name="t" joint="j"/></actuator>
</mujoco>
)";

TEST_P(MjcfError, NamesFileLineAndKey) {
  const MjcfFault& fault = GetParam();
  std::string text = kGoodMjcf;
  const std::size_t at = text.find(fault.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, fault.from.size(), fault.to);
  const fs::path file = write_text("bad.xml", text);
  try {
    read_mjcf(file);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + fault.message));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, MjcfError,
    testing::Values(
        MjcfFault{"not_closed", "</worldbody>", "", ":7: not valid XML: "},
        MjcfFault{"angle", "\"radian\"", "\"gon\"",
                  ":2: compiler.angle: must be degree or radian, not 'gon'"},
        MjcfFault{"global", "angle=", "coordinate=\"global\" angle=",
                  ":2: compiler.coordinate: global coordinates are not supported"},
        MjcfFault{"sequence", "eulerseq=\"xyz\"", "eulerseq=\"xy\"", ":2: compiler.eulerseq: "},
        MjcfFault{"class_twice", "</default>\n  </default>",
                  "</default><default class=\"part\"/></default>",
                  ":4: default.class: 'part' appears twice"},
        MjcfFault{"class_unnamed", "<default class=\"part\">", "<default>",
                  ":4: default.class: is missing"},
        MjcfFault{"no_class", "childclass=\"part\"", "childclass=\"parts\"",
                  ":8: body a.childclass: there is no default class 'parts'"},
        MjcfFault{"axis", "axis=\"0 1 0\"", "axis=\"0 0 0\"", ":9: joint j.axis: must not be zero"},
        MjcfFault{"number", "pos=\"0 0 1\"", "pos=\"0 0 l\"",
                  ":8: body a.pos: must be 3 numbers, not '0 0 l'"},
        MjcfFault{"not_finite", "size=\"1 1 1\"", "size=\"1 1 nan\"",
                  ":10: geom g.size: must be 3 numbers, not '1 1 nan'"},
        MjcfFault{"sizes", "size=\"1 1 1\"", "size=\"1 1\"", ":10: geom g.size: must be 3 numbers"},
        MjcfFault{"no_size", " size=\"1 1 1\"", "", ":10: geom g.size: is missing"},
        MjcfFault{"negative", "size=\"1 1 1\"", "size=\"1 -1 1\"",
                  ":10: geom g.size: must be above 0"},
        MjcfFault{"type", "type=\"box\"", "type=\"cube\"", ":10: geom g.type: must be plane, "},
        MjcfFault{"mesh", "type=\"box\"", "type=\"mesh\" mesh=\"n\"",
                  ":10: geom g.mesh: there is no mesh 'n'"},
        MjcfFault{"two_orientations", "pos=\"0 0 1\"", "quat=\"1 0 0 0\" euler=\"0 0 0\"",
                  ":8: body a.euler: must not be given beside quat"},
        MjcfFault{"zero_quat", "pos=\"0 0 1\"", "quat=\"0 0 0 0\"",
                  ":8: body a.quat: must not be zero"},
        MjcfFault{"range", "range=\"-1 1\"", "range=\"1 -1\"", ":9: joint j.range: "},
        MjcfFault{"limited", "range=\"-1 1\"", "limited=\"true\"",
                  ":9: joint j.range: is missing, although limited"},
        MjcfFault{"joint_type", "type=\"slide\"", "type=\"screw\"",
                  ":12: joint k.type: must be free, ball, slide or hinge, not 'screw'"},
        MjcfFault{"body_twice", "<body name=\"b\">", "<body name=\"a\">",
                  ":12: body a.name: appears twice"},
        MjcfFault{"joint_twice", "name=\"k\"", "name=\"j\"", ":12: joint j.name: appears twice"},
        MjcfFault{"equality", "joint1=\"j\"", "joint1=\"i\"",
                  ":14: joint.joint1: there is no hinge or slide 'i'"},
        MjcfFault{"tendon", "joint=\"j\"", "tendon=\"j\"",
                  ":15: motor t.tendon: there is no tendon 'j'"},
        MjcfFault{"connect", "<equality>", "<equality><connect body1=\"a\" body2=\"c\"/>",
                  ":14: connect.body2: there is no body 'c' in the robot"},
        MjcfFault{"include", "<asset>", "<include file=\"gone.xml\"/><asset>",
                  ":6: include.file: '"},
        MjcfFault{"itself", "<asset>", "<include file=\"bad.xml\"/><asset>",
                  ":6: include.file: 'bad.xml' is included twice"},
        MjcfFault{"replicate", "<geom name=\"g\"", "<replicate count=\"2\"/><geom name=\"g\"",
                  ":10: replicate: is not supported; load the model with MuJoCo"}),
    [](const auto& parameter) { return parameter.param.name; });

TEST(Mjcf, WithoutAJointIsRefused) {
  const fs::path file =
      write_text("still.xml", "<mujoco>\n<worldbody><body name='a'/></worldbody></mujoco>");
  try {
    read_mjcf(file);
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), file.string() + ":1: worldbody: has no body with a hinge or slide");
  }
}

}  // namespace
}  // namespace morphe::robot
