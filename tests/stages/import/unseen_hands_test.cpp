#include "stages/import/trackers/unseen_hands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A hand whose joint k is at (1, k, row) in millimetres.
RecordedHand hand_of(std::size_t rows) {
  RecordedHand hand{Array2D<Vec3>(rows, kKeypointCount, unknown_point()), {}, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < kKeypointCount; ++k)
      hand.keypoints(i, k) = 1e-3 * Vec3(1, static_cast<double>(k), static_cast<double>(i));
  }
  return hand;
}

void put_all(const Vec3& point, std::size_t row, RecordedHand& hand) {
  for (std::size_t k = 0; k < kKeypointCount; ++k) hand.keypoints(row, k) = point;
}

std::size_t count_known(const RecordedHand& hand, std::size_t row) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < kKeypointCount; ++k)
    count += is_known(hand.keypoints(row, k)) ? 1 : 0;
  return count;
}

TEST(UnseenHands, JointsAtOnePointAreNoHand) {
  RecordedHand hand = hand_of(4);
  put_all(Vec3::Zero(), 1, hand);
  put_all(Vec3(-9999, -9999, -9999), 2, hand);
  std::vector<std::string> reports;
  hide_unseen_points("right hand", hand.keypoints, reports);
  EXPECT_EQ(count_known(hand, 0), 21u);
  EXPECT_EQ(count_known(hand, 1), 0u);
  EXPECT_EQ(count_known(hand, 2), 0u);
  EXPECT_THAT(reports, ElementsAre("all joints of the right hand are at one point in 2 frames; "
                                   "treated as not visible"));
}

TEST(UnseenHands, AWristThatIsSeenAloneStays) {
  RecordedHand hand = hand_of(2);
  const Vec3 wrist = hand.keypoints(1, 0);
  put_all(Vec3::Zero(), 1, hand);
  hand.keypoints(1, 0) = wrist;
  std::vector<std::string> reports;
  hide_unseen_points("right hand", hand.keypoints, reports);
  EXPECT_EQ(count_known(hand, 1), 1u);
  EXPECT_EQ(hand.keypoints(1, 0), wrist);
}

TEST(UnseenHands, OneJointAtTheOriginIsHidden) {
  RecordedHand hand = hand_of(3);
  hand.keypoints(2, 8) = Vec3::Zero();
  std::vector<std::string> reports;
  hide_unseen_points("right hand", hand.keypoints, reports);
  EXPECT_EQ(count_known(hand, 2), 20u);
  EXPECT_THAT(reports, ElementsAre("1 points of the right hand are exactly at the origin; treated "
                                   "as not visible"));
}

TEST(UnseenHands, AJointThatIsTheOriginStays) {
  RecordedHand hand = hand_of(3);
  for (std::size_t i = 0; i < 3; ++i) hand.keypoints(i, 0) = Vec3::Zero();
  EXPECT_TRUE(is_wrist_at_origin(hand));
  std::vector<std::string> reports;
  hide_unseen_points("right hand", hand.keypoints, reports);
  EXPECT_EQ(count_known(hand, 1), 21u);
  EXPECT_THAT(reports, IsEmpty());
  hand.keypoints(1, 0) = Vec3(0.1, 0, 0);
  EXPECT_FALSE(is_wrist_at_origin(hand));
}

}  // namespace
}  // namespace morphe::imports
