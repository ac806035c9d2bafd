// Two hands of one recording, each with movements and objects of its own.
#include <gmock/gmock.h>

#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"
#include "tests/stages/segment/synthetic_hand.hpp"

namespace morphe::segment {
namespace {

constexpr double kLater_s = 0.9;  ///< the left hand's movement

/// Knuckles of index and little finger in the world, for a hand that points forward, thumb up.
const Vec3 kIndexKnuckle(0, 0.09, 0.04), kLittleKnuckle(0, 0.08, -0.04);

/// A ball between the tips of a hand, carried as drinking_hand() carries, later by `late_s`.
SceneObject ball(const std::string& name, double side, double late_s) {
  SceneObject object;
  object.name = name;
  object.shape = Shape::sphere;
  object.size = {0.05};
  for (int i = 0; i <= 600; ++i) {
    const double t = 0.01 * i;
    const Vec3 at = Vec3(0.205, 0.35, 0.08) +
                    SyntheticHand::progress((t - late_s - 1.9) / 0.9) * Vec3(-0.1, -0.25, 0.4);
    object.time.push_back(t);
    object.position.emplace_back(side * at.x(), at.y(), at.z());
    object.orientation.push_back(Quat::Identity());
  }
  return object;
}

/// The right hand drinks; the left one does the same, mirrored, kLater_s later.
Demonstration two_hands() {
  Demonstration demonstration;
  BodyStream& body = demonstration.streams.skeleton.emplace();
  for (const char* side : {"right_", "left_"}) {
    for (const char* joint : {"wrist", "index_mcp", "little_mcp", "thumb_tip", "index_tip"}) {
      body.names.push_back(std::string(side) + joint);
    }
  }
  body.parents.assign(10, "");
  body.position = Array2D<Vec3>(601, 10, unknown_point());
  body.orientation = Array2D<Quat>(601, 10, unknown_rotation());
  SyntheticHand hand = drinking_hand();
  hand.length_s = 6;
  SyntheticHand later = hand;
  for (auto& stroke : later.strokes) stroke.begin_s += kLater_s;
  for (auto& knot : later.opening) knot.first += knot.first > 0 ? kLater_s : 0;
  const HumanMotion of_hand[2] = {hand.motion(), later.motion()};
  body.time = of_hand[0].time;
  for (std::size_t i = 0; i < 601; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const HumanMotion& motion = of_hand[k];
      const Vec3 points[] = {motion.wrist[i], motion.wrist[i] + kIndexKnuckle,
                             motion.wrist[i] + kLittleKnuckle, motion.tip(i, 0), motion.tip(i, 1)};
      for (std::size_t j = 0; j < 5; ++j) {
        body.position(i, 5 * k + j) = points[j];
        if (k == 1) body.position(i, 5 + j).x() *= -1;
      }
    }
  }
  demonstration.objects = {ball("left's", -1, kLater_s), ball("right's", 1, 0)};
  return demonstration;
}

TEST(TwoHands, EachHasItsOwnMovements) {
  Demonstration demonstration = two_hands();
  for (const Side side : {Side::right, Side::left}) {
    demonstration.hand = side;
    const HumanMotion motion = reconstruct::reconstruct(demonstration, {}, {});
    const auto movements =
        segment(motion, {}, reconstruct::objects_on_side(demonstration, Side::right));
    ASSERT_EQ(movements.size(), 1u) << name_of(side);
    EXPECT_EQ(movements[0].target, side == Side::left ? "left's" : "right's");
    EXPECT_THAT(
        kinds(movements[0]),
        testing::ElementsAre(PhaseKind::reach, PhaseKind::preshape, PhaseKind::grasp,
                             PhaseKind::transport, PhaseKind::hold, PhaseKind::return_phase));
    const double late_s = side == Side::left ? kLater_s : 0;
    EXPECT_NEAR(movements[0].begin_s, 0.85 + late_s, 0.06);
    EXPECT_NEAR(movements[0].phases[3].begin_s, 1.96 + late_s, 0.06);
  }
}

}  // namespace
}  // namespace morphe::segment
