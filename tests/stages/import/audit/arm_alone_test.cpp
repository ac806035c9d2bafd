// The audit of an arm without a trunk: five joints, whose names, side and vertical only the posture
// of an arm and a hand tells.
#include <gmock/gmock.h>

#include <array>

#include "tests/stages/import/audit/checks_alone.hpp"
#include "tests/stages/import/audit/recorded_arm.hpp"

namespace morphe::imports {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using ArmCheck = std::vector<Doubt> (*)(const Demonstration&, const AuditInput&);

void turn(const Eigen::Matrix3d& map, Demonstration& recording) {
  for (Vec3& point : recording.streams.skeleton->position.values) point = map * point;
}

Eigen::Matrix3d rows_of(const Vec3& x, const Vec3& y, const Vec3& z) {
  Eigen::Matrix3d map;
  map << x.transpose(), y.transpose(), z.transpose();
  return map;
}

const Vec3 kX = Vec3::UnitX(), kY = Vec3::UnitY(), kZ = Vec3::UnitZ();

/// Returns the texts of the doubts of a kind.
std::vector<std::string> texts_of(ArmCheck check, const Demonstration& recording, FlagCode code) {
  std::vector<std::string> texts;
  for (const Doubt& doubt : check(recording, {})) {
    EXPECT_EQ(doubt.flag.code, code);
    texts.push_back(doubt.flag.text);
  }
  return texts;
}

/// Exchanges two joints from a row on.
void exchange_joints(std::size_t a, std::size_t b, std::size_t begin, Demonstration& recording) {
  Array2D<Vec3>& position = recording.streams.skeleton->position;
  for (std::size_t i = begin; i < position.rows; ++i) std::swap(position(i, a), position(i, b));
}

TEST(ArmAlone, AsRecordedHasNoDoubt) {
  for (const ArmCheck check : std::initializer_list<ArmCheck>{
           check_rows, check_jumps, check_labels, check_chirality, check_vertical, check_scale,
           check_time_base, check_jitter}) {
    const std::vector<Doubt> doubts = check(recorded_arm(), {});
    EXPECT_THAT(doubts, IsEmpty()) << doubts.front().flag.text;
  }
}

TEST(ArmAlone, ItsMirrorImageIsHeldAsALeftArm) {
  for (const Eigen::Matrix3d& mirror :
       {rows_of(-kX, kY, kZ), rows_of(kX, -kY, kZ), rows_of(kY, kX, kZ)}) {
    Demonstration mirrored = recorded_arm();
    turn(mirror, mirrored);
    const auto texts = texts_of(check_chirality, mirrored, FlagCode::mirrored);
    ASSERT_THAT(texts, SizeIs(1)) << mirror;
    EXPECT_THAT(texts[0], HasSubstr("right arm is held as a left one"));
  }
  Demonstration turned = recorded_arm();
  turn(rows_of(kY, -kX, kZ), turned);
  EXPECT_THAT(check_chirality(turned, {}), IsEmpty()) << "turned about the vertical";
}

TEST(ArmAlone, AnElbowAboveItsShoulderIsUpsideDown) {
  for (const Eigen::Matrix3d& map : {rows_of(kX, kY, -kZ), rows_of(kX, -kY, -kZ)}) {
    Demonstration upside_down = recorded_arm();
    turn(map, upside_down);
    EXPECT_THAT(texts_of(check_vertical, upside_down, FlagCode::vertical), SizeIs(1)) << map;
  }
}

TEST(ArmAlone, JointsThatCarryEachOthersNamesGetTheirOwn) {
  const Demonstration truth = recorded_arm();
  for (const auto& [a, b] : {std::array<std::size_t, 2>{1, 2}, {0, 1}, {0, 2}, {3, 4}}) {
    Demonstration exchanged = truth;
    exchange_joints(a, b, 0, exchanged);
    const std::vector<Doubt> doubts = check_labels(exchanged, {});
    ASSERT_THAT(doubts, SizeIs(1)) << a << b;
    EXPECT_EQ(doubts[0].flag.code,
              a == 3 ? FlagCode::exchanged_digits : FlagCode::exchanged_markers);
    doubts[0].mend(exchanged);
    EXPECT_TRUE(exchanged.streams.skeleton->position.values ==
                truth.streams.skeleton->position.values);
  }
}

TEST(ArmAlone, TipsThatComeBackExchangedAfterAGapAreFound) {
  Demonstration recording = recorded_arm();
  constexpr std::size_t kBegin = 130, kEnd = 150;
  exchange_joints(3, 4, kEnd, recording);
  Array2D<Vec3>& position = recording.streams.skeleton->position;
  for (std::size_t i = kBegin; i < kEnd; ++i) position(i, 3) = position(i, 4) = unknown_point();
  const std::vector<Doubt> doubts = check_labels(recording, {});
  ASSERT_THAT(doubts, SizeIs(1));
  EXPECT_THAT(doubts[0].flag.text, HasSubstr("exchanged from 1.50 s"));
}

TEST(ArmAlone, ABodyThatIsAThirdTooLargeIsFlagged) {
  Demonstration large = recorded_arm();
  turn(1.35 * Eigen::Matrix3d::Identity(), large);
  const std::vector<Doubt> doubts = check_scale(large, {});
  ASSERT_THAT(doubts, SizeIs(1));
  EXPECT_EQ(doubts[0].flag.code, FlagCode::scale);
  EXPECT_FALSE(doubts[0].question) << "no unit is 1.35 times another";
}

TEST(ArmAlone, OneTipThatTremblesIsFlagged) {
  Demonstration recording = recorded_arm();
  math::RandomStream noise(3, "trembling tip");
  Array2D<Vec3>& position = recording.streams.skeleton->position;
  for (std::size_t i = 0; i < position.rows; ++i) position(i, 4) += 0.0018 * noise.normal_vector3();
  const std::vector<Doubt> doubts = check_jitter(recording, {});
  ASSERT_THAT(doubts, SizeIs(1));
  EXPECT_EQ(doubts[0].flag.subject, "right_index_tip");
  EXPECT_LT(doubts[0].flag.limit, doubts[0].flag.value);
}

}  // namespace
}  // namespace morphe::imports
