#include "sample_data.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace morphe::store {
namespace {

/// Numbers that do not repeat and have no short binary form; every 17th is NaN, unless all are
/// seen.
class Numbers {
 public:
  Numbers() = default;
  Numbers(int begin, bool all_seen) : all_seen_(all_seen), count_(begin) {}
  double operator()() {
    ++count_;
    return count_ % 17 == 0 && !all_seen_ ? kUnknown : 0.1 * count_ + 1.0 / count_;
  }
  Vec3 point() {
    const double x = (*this)(), y = (*this)();
    return {x, y, (*this)()};
  }
  Quat rotation() {
    const Vec3 axis = Vec3(1.0 + count_, 2.0, -3.0).normalized();
    return ++count_ % 5 == 0 && !all_seen_ ? unknown_rotation()
                                           : Quat(Eigen::AngleAxisd(0.01 * count_, axis));
  }
  Pose pose() { return make_pose({(*this)(), 2, 3}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))); }
  std::vector<double> many(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) value = (*this)();
    return values;
  }
  /// All seen, each behind the one before.
  std::vector<double> times(std::size_t count) {
    std::vector<double> values(count);
    for (double& value : values) {
      ++count_;
      value = 0.1 * count_ + 1e-3 / count_;
    }
    return values;
  }
  std::vector<Vec3> points(std::size_t count) {
    std::vector<Vec3> values(count);
    for (Vec3& value : values) value = point();
    return values;
  }
  std::vector<Quat> rotations(std::size_t count) {
    std::vector<Quat> values(count);
    for (Quat& value : values) value = rotation();
    return values;
  }
  Array2D<Vec3> points(std::size_t rows, std::size_t cols) {
    Array2D<Vec3> table(rows, cols, Vec3::Zero());
    table.values = points(rows * cols);
    return table;
  }
  Array2D<Quat> rotations(std::size_t rows, std::size_t cols) {
    Array2D<Quat> table(rows, cols, Quat::Identity());
    table.values = rotations(rows * cols);
    return table;
  }
  JointRows rows(Eigen::Index row_count, Eigen::Index col_count) {
    JointRows table(row_count, col_count);
    for (double& value : table.reshaped()) value = (*this)();
    return table;
  }
  JointVector vector(Eigen::Index count) { return rows(count, 1); }

 private:
  bool all_seen_ = false;
  int count_ = 0;
};

Streams full_streams(Numbers& number, HandKind kind) {
  Streams streams;
  streams.markers = {{"RSHO1", "RÜAR", "m 3"}, number.times(4), number.points(4, 3)};
  streams.sensors = {
      {"shoulder", "elbow"}, {}, number.times(5), number.points(5, 2), number.rotations(5, 2)};
  streams.skeleton = {{"hips", "chest"},
                      {"", "hips"},
                      number.times(3),
                      number.points(3, 2),
                      number.rotations(3, 2)};
  streams.arm_angles = {{"flexion", "rotation"}, number.times(6), number.rows(6, 2)};
  HandStream& hand = streams.hand.emplace();
  hand.kind = kind;
  hand.time = number.times(2);
  if (kind == HandKind::glove || kind == HandKind::joint_angles) {
    for (int i = 0; i < (kind == HandKind::glove ? 22 : 3); ++i)
      hand.names.push_back(fmt::format("s{}", i));
    hand.angles = number.rows(2, static_cast<Eigen::Index>(hand.names.size()));
  } else {
    hand.position = number.points(2, kind == HandKind::keypoints ? 21 : 5);
  }
  return streams;
}

std::vector<SceneObject> objects() {
  Numbers number(1000, true);
  std::vector<SceneObject> all(5);
  const std::size_t sizes[] = {1, 3, 2, 2, 0};
  const char* names[] = {"zebra", "cup", "bottle", "pen", "apple"};  // not sorted
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].name = names[i];
    all[i].shape = static_cast<Shape>(i);
    all[i].size = number.many(sizes[i]);
    all[i].time = number.times(i + 1);
    all[i].position = number.points(i + 1);
    all[i].orientation = number.rotations(i + 1);
  }
  all[1].attached_frame = "palm";
  all[1].attach_s = 1.25;
  all[1].release_s = 2.5;
  all[1].pose_origin = all[2].shape_origin = ObjectOrigin::inferred;
  all[1].shape_origin = ObjectOrigin::configured;
  all[4].vertices = number.points(4);
  all[4].triangles = {{0, 1, 2}, {3, 2, 1}};
  return all;
}

Trajectory trajectory(Numbers& number, std::size_t samples) {
  Trajectory t;
  const auto rows = static_cast<Eigen::Index>(samples);
  t.time = number.many(samples);
  t.position = number.rows(rows, 3);
  t.velocity = number.rows(rows, 3);
  t.acceleration = number.rows(rows, 3);
  t.demonstration_time = number.many(samples);
  t.clearance = number.many(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    t.phase.push_back(static_cast<PhaseKind>((i + 1) % enum_count<PhaseKind>()));
    t.origin.push_back(static_cast<SampleOrigin>((i + 1) % 3));
  }
  return t;
}

/// Flags with and without an interval, one for each response.
std::vector<Assumption> assumptions() {
  return {{AssumptionKind::set_by_hand, "map.starts", "64"},
          {AssumptionKind::inferred, "heading", "rotated by 3°"}};
}

std::vector<RecordingFlag> flags() {
  return {{FlagCode::spike, FlagResponse::mended, 1.42, 1.43, "RFTP", 20, 5, "m/s", "RFTP jumps"},
          {FlagCode::mirrored, FlagResponse::flagged, kUnknown, kUnknown, "", kUnknown, kUnknown,
           "", "the thumb is on the wrong side"},
          {FlagCode::no_grasp, FlagResponse::accepted, 0.5, 2.75, "", 0, 1, "1", "no grasp"}};
}

}  // namespace

Demonstration full_demonstration(const std::string& name) {
  Numbers number;
  Demonstration demo;
  demo.name = name;
  demo.subject = "ADL001";
  demo.task = "drink";
  demo.hand = Side::left;
  demo.source = "made for this test";
  demo.licence = "none";
  demo.upper_arm = number();
  demo.forearm = number();
  demo.hand_length = number();
  demo.hand_breadth = number();
  demo.streams = full_streams(number, HandKind::glove);
  demo.streams.sensors->orientation(0, 0) = Quat(0.1, 0.7, -0.7, 0.1);
  demo.calibration = full_streams(number, HandKind::keypoints);
  demo.objects = objects();
  demo.flags = flags();
  demo.assumptions = assumptions();
  demo.accepted_flags = {{FlagCode::jitter}, {FlagCode::no_grasp}};
  demo.labels = {{0.1, 0.2, PhaseKind::reach}, {0.2, kUnknown, PhaseKind::grasp}};
  return demo;
}

RobotModel small_robot() {
  Numbers number;
  RobotModel robot;
  robot.name = "three";
  robot.joint_names = {"S1", "E1", "index_distal"};
  robot.lower = number.vector(3);
  robot.upper = number.vector(3);
  robot.velocity = number.vector(3);
  robot.acceleration = number.vector(3);
  robot.jerk = number.vector(3);
  robot.frames = {{"S1", -1, number.pose(), number.point(), 0, 0.5, 0.25},
                  {"E1", 0, number.pose(), number.point(), 1, 1.5, 0.75},
                  {"fixed", 1, number.pose(), number.point(), -1, 2.5, 1.25},
                  {"coupled", 2, number.pose(), number.point(), 2, -1, 3, true}};
  robot.coupled_limits = {{3, -0.5, 0.25, 1.5, RobotModel::kUnbounded, 12}};
  robot.braking_curves = {{1, 12, 0.3, -2.75, 2.5}};
  robot.unchecked_links = {"fixed", "E1"};
  robot.tips = {{"ring_tip", 3, number.pose(), 3, 0.75}, {"wrist_tip", 2, number.pose(), -1}};
  robot.joint_centres = {{1, "arm"}, {2, "index"}};
  robot.capsules = {{"base", -1, number.point(), number.point(), 0.1, false},
                    {"upper", 0, number.point(), number.point(), 0.2, false},
                    {"finger", 3, number.point(), number.point(), 0.01, true}};
  robot.allowed_collision_pairs = {{0, 1}, {1, 2}};
  robot.shoulder_frame = 1;
  robot.palm_frame = 2;
  return robot;
}

PlanFileHeader plan_header() {
  PlanFileHeader header;
  header.config = "seed: 7\n" + std::string(100000, '#') + "\n";
  header.config_sha256 = "abc";
  header.dataset_sha256 = "def";
  header.software = "morphe 0.1.0";
  header.built_with = "GNU 12.2.0, OMPL 1.5.2";
  header.inputs = {{"../robots/pa10.yaml", "name: pa10\n"},
                   {"../robots/dlr.yaml", "name: dlr_hit2 °\n"},
                   {"human.yaml", ""},
                   {"meshes/post.stl", std::string("solid\0\xff", 7)}};
  header.settings = {"map.starts=3", "robots=pa10"};
  header.assumptions = assumptions();
  return header;
}

Plan full_plan(const std::string& demonstration, int movement) {
  Numbers number;
  Plan plan;
  plan.demonstration = demonstration;
  plan.subject = "ADL004";
  plan.task = "drink";
  plan.hand = Side::right;
  plan.movement = {movement,
                   0.5,
                   2.75,
                   {{PhaseKind::reach, 0.5, 1, 0.9}, {PhaseKind::hold, 1, kUnknown, 0.8}},
                   "cup"};
  plan.reason = Reason::none;
  plan.detail = "It holds.";
  plan.tolerances = {0.002, 0.004, 0.001, 0.006, 0.03, 0.25, 0.04};
  plan.goals.time = number.many(4);
  plan.goals.tip_position = number.points(4, 2);
  plan.goals.tip_to_pad_share = Array2D<double>(4, 2, 0.25);
  plan.goals.tip_to_pad_share(2, 1) = number();
  plan.goals.auto_closed = {0, 1};
  plan.goals.tip_orientation = number.rotations(4, 2);
  plan.goals.reachable = Array2D<std::uint8_t>(4, 2, 0);
  plan.goals.reachable(1, 1) = plan.goals.reachable(3, 0) = 1;
  plan.goals.shoulder_position = number.points(4);
  plan.goals.elbow_position = number.points(4);
  plan.goals.wrist_position = number.points(4);
  plan.goals.wrist_orientation = number.rotations(4);
  plan.goals.finger_joint_position = number.points(4, 5);
  plan.goals.estimated = {"ring", "little finger"};
  plan.goals.common_base_offset = number.point();
  plan.scene.objects = objects();
  plan.reference_frames = {number.pose(), number.pose(), number.pose(), number.point()};
  plan.mapped.position = number.rows(4, 3);
  plan.mapped.tip_error = number.rows(4, 2);
  plan.mapped.tip_orientation_error = number.rows(4, 2);
  plan.mapped.objective = number.many(4);
  plan.mapped.humanlikeness = number.rows(4, 3);
  plan.branch = {3, {"shoulder left", "elbow negative"}, {"elbow positive -> negative at 0.51 s"}};
  plan.mapped.status = {FrameStatus::compromise, FrameStatus::out_of_reach, FrameStatus::no_goal,
                        FrameStatus::met};
  plan.flags = flags();
  plan.source = "https://example.org/recordings";
  plan.licence = "MIT";
  plan.recording_assumptions = assumptions();
  plan.findings = {{0.6, 0.7, Cause::object_collision, "finger", "table", 0.01},
                   {0.8, 0.9, Cause::joint_limit, "E1", "", 0.02, FindingUnit::radian, 1.5}};
  plan.repair = {{0, "detour", 0.55, 0.75, 0.3, 1, 0, 0.002, "tracking: index_tip", true, ""},
                 {1, "attempt 1", kUnknown, kUnknown, 0, 2, 0.01, 0.02, "object_collision: finger",
                  false, "no detour found"}};
  plan.remaining_findings = {{0.65, 0.7, Cause::tracking, "index_tip", "", 0.002}};
  plan.path.position = number.rows(5, 3);
  plan.path.origin = {SampleOrigin::planned, SampleOrigin::re_solved, SampleOrigin::mapped,
                      SampleOrigin::mapped, SampleOrigin::planned};
  plan.path.demonstration_time = number.many(5);
  plan.grasp.sample = 2;
  plan.grasp.approach_direction = number.point();
  plan.grasp.base_from_object = number.pose();
  plan.grasp.object_from_palm = number.pose();
  plan.grasp.tips_in_object = number.points(2);
  plan.grasp.grasp_posture = number.vector(3);
  plan.grasp.pregrasp_posture = number.vector(3);
  for (const ContactOrigin origin : {ContactOrigin::demonstrated, ContactOrigin::auto_closed}) {
    plan.grasp.contacts.push_back({"tip", "finger", origin, ContactState::touching, number.point(),
                                   number.point(), number.point(), number.point(), number(),
                                   number(), number(), number(), number.point()});
  }
  plan.grasp.quality = {number(), number(), number(), number.point(), number(),
                        number(), number(), number(), number(),       number()};
  plan.grasp.grasp_torque = number.vector(3);
  plan.grasp.servo_target = number.vector(3);
  plan.trajectory = trajectory(number, 6);
  plan.approach = trajectory(number, 2);
  plan.retreat = trajectory(number, 3);
  plan.certificate = {number(), number(), number(), number(),  number(), number(),
                      number(), number(), kUnknown, number(),  number(), number(),
                      number(), number(), number(), number(),  number(), number(),
                      number(), number(), number(), number(),  number(), number(),
                      number(), number(), number(), {"fixed"}, {}};
  plan.certificate.clearance_by_kind = {
      {ClearanceKind::self, number(), "palm", "forearm", number()},
      {ClearanceKind::target, number(), "palm", "cup", number()}};
  plan.mapped.natural_posture_error = number();
  plan.repaired = true;
  return plan;
}

Plan infeasible_plan(const std::string& demonstration, int movement) {
  Plan plan;
  plan.demonstration = demonstration;
  plan.movement.index = movement;
  plan.hand = Side::left;
  plan.reason = Reason::no_goal;
  plan.detail = "Nothing was grasped.";
  return plan;
}

std::filesystem::path fresh_file(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) /
      fmt::format("morphe_store_{}_{}_{}", test->test_suite_name(), test->name(), getpid());
  std::filesystem::create_directories(folder);
  std::filesystem::remove(folder / name);
  return folder / name;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

int run_python(const std::string& script, const std::string& arguments) {
  return std::system(fmt::format("/usr/bin/python3 -B {}/tests/core/store/{} {}", MORPHE_SOURCE_DIR,
                                 script, arguments)
                         .c_str());
}

}  // namespace morphe::store
