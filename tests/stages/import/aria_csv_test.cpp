#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::HasSubstr;
using AriaCsv = RecordingFolder;

const std::filesystem::path kAria = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/aria";

constexpr const char* kWrists =
    "tracking_timestamp_us,left_tracking_confidence,tx_left_wrist_device,ty_left_wrist_device,"
    "tz_left_wrist_device,right_tracking_confidence,tx_right_wrist_device,ty_right_wrist_device,"
    "tz_right_wrist_device\n";
constexpr const char* kTrajectory =
    "graph_uid,tracking_timestamp_us,utc_timestamp_ns,tx_world_device,ty_world_device,"
    "tz_world_device,qx_world_device,qy_world_device,qz_world_device,qw_world_device,"
    "gravity_x_world,gravity_y_world,gravity_z_world\n";

std::string device(const std::string& uid, int us, double x, const std::string& gravity) {
  return fmt::format("{},{},0,{},0,0,0,0,0.6,0.8,{}\n", uid, us, x, gravity);
}
const std::string kDown = "0,0,-9.81";

Vec3 right_wrist(const Demonstration& d, std::size_t row) {
  const BodyStream& body = *d.streams.skeleton;
  const auto at = std::ranges::find(body.names, "right_wrist") - body.names.begin();
  return body.position(row, static_cast<std::size_t>(at));
}

TEST_F(AriaCsv, TheDeviceCarriesTheHands) {
  write(kTrajectory + device("a", 0, 0, kDown) + device("a", 100000, 1, kDown) +
            device("b", 150000, 7, kDown),
        "closed_loop_trajectory.csv");
  const Demonstration d =
      read(write(std::string(kWrists) + "25000,-1,0,0,0,0.5,1,0,0\n"    // between two rows
                                        "50000,-1,0,0,0,0,1,0,0\n"      // no confidence
                                        "104000,-1,0,0,0,0.9,1,0,0\n"   // held
                                        "120000,-1,0,0,0,0.9,1,0,0\n"   // nowhere
                                        "151000,-1,0,0,0,0.9,1,0,0\n")  // another world
      );
  // x of the device points to (0.28, 0.96, 0): turned by 2 atan(0.6 / 0.8) about z.
  EXPECT_LT((right_wrist(d, 0) - Vec3(0.25 + 0.28, 0.96, 0)).norm(), 1e-12);
  EXPECT_FALSE(is_known(right_wrist(d, 1)));
  EXPECT_LT((right_wrist(d, 2) - Vec3(1.28, 0.96, 0)).norm(), 1e-12);
  EXPECT_FALSE(is_known(right_wrist(d, 3)));
  EXPECT_FALSE(is_known(right_wrist(d, 4)));
  EXPECT_EQ(d.streams.skeleton->names[0], "head");
  EXPECT_NEAR(d.streams.skeleton->time[4], 0.126, 1e-12);
  EXPECT_THAT(d.import_notes, Contains("time 0 is 0.025 s of the device clock"));
  EXPECT_DOUBLE_EQ(d.streams.skeleton->confidence(0, 1), 0.5);
  EXPECT_DOUBLE_EQ(d.streams.skeleton->confidence(1, 1), 0);
  EXPECT_THAT(d.import_notes, Contains("the left hand is never visible"));
  EXPECT_THAT(d.import_notes, Contains("the right hand is visible in 2 of 5 frames"));
  EXPECT_THAT(d.import_notes,
              Contains(HasSubstr("1 of 5 rows are outside of the device trajectory")));
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("(graph_uid): 1 of 5 rows are in another map")));
}

TEST_F(AriaCsv, ErrorsSayWhere) {
  const std::string row = "25000,-1,0,0,0,0.5,1,0,0\n";
  const auto error = [&](const std::string& text) { return error_of(write(text, "h.csv")); };
  EXPECT_EQ(error(kWrists + row),
            "h.csv: no closed_loop_trajectory.csv beside the file or in a folder slam/: the "
            "positions of the wrists in the world are unknown");
  std::string lacking = kWrists;
  lacking.replace(lacking.find("tz_left"), 7, "tq_left");
  EXPECT_EQ(error(lacking + row), "h.csv:1: tz_left_wrist_device: the column is missing");
  EXPECT_EQ(error(kWrists + row + "1" + row.substr(2)),
            "h.csv:3: tracking_timestamp_us: must be greater than in the previous row");
  EXPECT_EQ(error(kWrists + std::string("25000,-1,0,0,0,0.5,1,0\n")),
            "h.csv:2: the row has 8 cells, the header has 9");
  EXPECT_EQ(error(kWrists + std::string("25000,-1,0,0,0,0.5,1,0,x\n")),
            "h.csv:2: tz_right_wrist_device: must be a number, not 'x'");
  EXPECT_EQ(error(kWrists), "h.csv:1: the file ends before the first row");
  const auto with = [&](const std::string& trajectory) {
    write(trajectory, "closed_loop_trajectory.csv");
    return error(kWrists + row);
  };
  EXPECT_THAT(with(kTrajectory + device("a", 25000, 0, "9.81,0,0")),
              HasSubstr("closed_loop_trajectory.csv: axes: gravity points along (1, 0, 0)"));
  EXPECT_EQ(with(kTrajectory + device("a", 9, 0, kDown) + device("a", 3, 0, kDown)),
            "closed_loop_trajectory.csv:3: tracking_timestamp_us: must be greater than in the "
            "previous row");
  EXPECT_EQ(with(kTrajectory + std::string("a,0,0,0,0,0,0,0,6,8,0,0,-9.81\n")),
            "closed_loop_trajectory.csv:2: qx_world_device: is not a quaternion of unit length");
  EXPECT_EQ(with("graph_uid,x\na,1\n"),
            "closed_loop_trajectory.csv:1: tracking_timestamp_us: the column is missing");
}

// The wrist in the world as numpy has it from the same two files, within what thinning costs.
TEST_F(AriaCsv, TheShippedWristStandsWhereItDid) {
  for (const char* file : {"wrist_and_palm_poses.csv", "wrist_and_palm_poses_v2.csv"}) {
    const Demonstration d = read(kAria / "hand_tracking" / file);
    const BodyStream& body = *d.streams.skeleton;
    ASSERT_EQ(body.time.size(), 122u);
    const auto row = static_cast<std::size_t>(
        std::ranges::lower_bound(body.time, (159402529 - 148502526) / 1e6 - 1e-9) -
        body.time.begin());
    EXPECT_LT((right_wrist(d, row) - Vec3(-1.153, -3.949, -0.700)).norm(), 0.0015);
    EXPECT_LT((body.position(row, 0) - Vec3(-1.339, -4.219, -0.462)).norm(), 0.0015);
    EXPECT_NEAR(body.confidence(row, 1), 0.996126, 1e-9);
    EXPECT_THAT(d.import_notes, Contains("the left hand is never visible"));
    EXPECT_THAT(d.import_notes, Contains("the right hand is visible in 6 of 122 frames"));
  }
}

TEST_F(AriaCsv, WithoutATrajectoryTheHandHasAShape) {
  for (const char* file : {"hand_tracking_results_v1.csv", "hand_tracking_results_v2.csv",
                           "wrist_and_palm_poses_v3.csv"}) {
    const Demonstration d = read(kAria / "other" / file);
    const HandStream& hand = *d.streams.hand;
    EXPECT_EQ(hand.kind, HandKind::keypoints);
    EXPECT_THAT(d.import_notes, Contains(HasSubstr("only the shape of the right hand is used")));
    bool any = false;
    for (std::size_t i = 0; i < hand.time.size(); ++i) {
      EXPECT_FALSE(is_known(hand.position(i, 1)));  // the thumb's root is not tracked
      if (!is_known(hand.position(i, 0))) continue;
      any = true;
      EXPECT_NEAR((hand.position(i, 9) - hand.position(i, 0)).norm(), 0.0957, 0.001);
    }
    EXPECT_TRUE(any);
  }
}

}  // namespace
}  // namespace morphe::imports
