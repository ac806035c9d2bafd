#include <gtest/gtest.h>

#include "stages/import/folders/recording_descriptor.hpp"

namespace morphe::imports {
namespace {

/// Points of these names, each going there and back by so much [m].
Demonstration moving(const std::vector<std::pair<std::string, double>>& points) {
  constexpr std::size_t kRows = 40;
  Demonstration demonstration;
  MarkerStream& markers = demonstration.streams.markers.emplace();
  markers.position = Array2D<Vec3>(kRows, points.size(), unknown_point());
  for (const auto& point : points) markers.names.push_back(point.first);
  for (std::size_t i = 0; i < kRows; ++i) {
    markers.time.push_back(0.01 * static_cast<double>(i));
    for (std::size_t k = 0; k < points.size(); ++k) {
      markers.position(i, k) = Vec3(i % 2 == 0 ? points[k].second : -points[k].second, 1, 2);
    }
  }
  return demonstration;
}

ReachingHand hand_of(const std::vector<std::pair<std::string, double>>& points) {
  const Demonstration demonstration = moving(points);
  return reaching_hand(demonstration, recording_descriptor(demonstration));
}

TEST(ReachingHand, TheSideThatMovesFarther) {
  EXPECT_EQ(hand_of({{"RTHUM", 0.02}, {"LTHUM", 0.3}}).side, Side::left);
  EXPECT_EQ(hand_of({{"RTHUM", 0.3}, {"LTHUM", 0.02}}).side, Side::right);
  EXPECT_EQ(hand_of({{"LeftHand", 0.3}, {"RightHand", 0.1}, {"Hips", 2}}).side, Side::left);
  EXPECT_EQ(hand_of({{"S:hand_l", 0.3}, {"S:hand_r", 0.1}}).side, Side::left);
  EXPECT_EQ(hand_of({{"lwri", 0.3}, {"rwri", 0.1}}).side, Side::left);
  EXPECT_EQ(hand_of({{"WRIl", 0.3}, {"WRIr", 0.1}}).side, Side::left);
}

TEST(ReachingHand, OneSideAlone) {
  const ReachingHand hand = hand_of({{"LWRI", 0.3}, {"LELB", 0.1}});
  EXPECT_EQ(hand.side, Side::left);
  EXPECT_NE(hand.reason.find("only points of the left side"), std::string::npos);
}

TEST(ReachingHand, JointsCountBesideAMarkerOfSomethingElse) {
  Demonstration demonstration =
      moving({{"left_wrist", 0.3}, {"left_elbow", 0.1}, {"right_shoulder", 0.0}});
  BodyStream& skeleton = demonstration.streams.skeleton.emplace();
  MarkerStream& markers = *demonstration.streams.markers;
  skeleton.names = markers.names;
  skeleton.time = markers.time;
  skeleton.position = markers.position;
  demonstration.streams.markers = moving({{"cup", 0.2}}).streams.markers;
  EXPECT_EQ(reaching_hand(demonstration, recording_descriptor(demonstration)).side, Side::left);
}

TEST(ReachingHand, LateralIsNotLeft) {
  EXPECT_EQ(hand_of({{"gh", 0.0}, {"EpL", 0.3}, {"EpM", 0.3}, {"us", 0.4}}).side, Side::right);
  EXPECT_EQ(hand_of({{"R_FAL", 0.0}, {"R_RSP", 0.3}, {"L_FAL", 0.1}}).side, Side::right);
}

TEST(ReachingHand, AssumedWhereNothingTells) {
  for (const auto& points : {std::vector<std::pair<std::string, double>>{{"wrist", 1}},
                             {{"RTHUM", 0.30}, {"LTHUM", 0.31}}}) {
    const ReachingHand hand = hand_of(points);
    EXPECT_EQ(hand.side, Side::right);
    EXPECT_NE(hand.reason.find("assumed"), std::string::npos);
  }
}

TEST(ReachingHand, KeypointsTellItByTheCurl) {
  // A right hand with its back up (+z): fingers along y, thumb side at -x, tips curled down.
  Demonstration demonstration;
  HandStream& hand = demonstration.streams.hand.emplace();
  hand.kind = HandKind::keypoints;
  hand.time = {0};
  hand.position = Array2D<Vec3>(1, 21, Vec3::Zero());
  for (std::size_t finger = 1; finger < 5; ++finger) {
    const double x = 0.02 * static_cast<double>(finger);
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const double along = static_cast<double>(joint);
      hand.position(0, 1 + 4 * finger + joint) = Vec3(x, 0.09 + 0.02 * along, -0.015 * along);
    }
  }
  EXPECT_EQ(reaching_hand(demonstration, recording_descriptor(demonstration)).side, Side::right);
  for (Vec3& point : hand.position.values) point.x() = -point.x();
  EXPECT_EQ(reaching_hand(demonstration, recording_descriptor(demonstration)).side, Side::left);
}

TEST(RecordingSketch, WandersByHandAndStandsStill) {
  const RecordingDescriptor sketch = recording_descriptor(moving({{"B", 0.2}, {"A", 0.001}}));
  EXPECT_EQ(sketch.points, (std::vector<std::string>{"A", "B"}));
  EXPECT_NEAR(sketch.rms_deviation_m[0], 0.001, 1e-12);
  EXPECT_NEAR(sketch.rms_deviation_m[1], 0.2, 1e-12);
  EXPECT_TRUE(is_stationary(recording_descriptor(moving({{"A", 0.001}, {"B", 0.01}, {"C", 0}}))));
  // One marker that was taken for another is no motion; three that move are.
  EXPECT_TRUE(is_stationary(recording_descriptor(moving({{"A", 0.5}, {"B", 0.01}, {"C", 0}}))));
  EXPECT_FALSE(is_stationary(recording_descriptor(moving({{"A", 0.5}, {"B", 0.1}, {"C", 0.03}}))));
  EXPECT_FALSE(is_stationary(RecordingDescriptor{}));
}

}  // namespace
}  // namespace morphe::imports
