#include <gmock/gmock.h>

#include "stages/segment/segment.hpp"
#include "tests/stages/segment/synthetic_hand.hpp"

namespace morphe::segment {
namespace {

/// A hand that puts things from one place to another, one after the other, and goes home at last.
struct PickAndPlace {
  SyntheticHand hand;
  std::vector<SceneObject> boxes;
  std::vector<double> taken_s, put_down_s;
  Vec3 at = Vec3::Zero();  ///< where the hand is, from its start
  double now_s = 0.8;

  void stroke(const Vec3& to, double length_s) {
    hand.strokes.push_back({now_s, length_s, to - at});
    now_s += length_s;
    at = to;
  }
  /// Reaches `from`, waits, carries a thing to `to` over an arc of 0.1 m, and waits.
  void move(const Vec3& from, const Vec3& to) {
    hand.opening.emplace_back(now_s, 0.08);
    hand.opening.emplace_back(now_s + 0.5, 0.13);
    stroke(from, 0.8);
    hand.opening.emplace_back(now_s + 0.1, 0.06);
    now_s += 0.3;
    taken_s.push_back(now_s);
    hand.strokes.push_back({now_s, 0.5, {0, 0, 0.1}});
    hand.strokes.push_back({now_s + 0.4, 0.5, {0, 0, -0.1}});
    stroke(to, 0.9);
    put_down_s.push_back(now_s);
    now_s += 0.3;
    hand.opening.emplace_back(now_s, 0.06);
  }
  HumanMotion finish() {
    stroke(Vec3::Zero(), 0.8);
    hand.opening.emplace_back(now_s, 0.08);
    hand.length_s = now_s + 0.8;
    return hand.motion();
  }
  /// A box of 0.05 x 0.05 x 0.1 m that the hand moves in the given turns.
  SceneObject box(const std::string& name, const HumanMotion& motion,
                  const std::vector<std::size_t>& turns) const {
    SceneObject box;
    box.name = name;
    box.size = {0.05, 0.05, 0.1};
    for (const double time_s : motion.time) {
      double of_hand_s = taken_s[turns.front()];
      for (const std::size_t turn : turns)
        if (time_s > taken_s[turn]) of_hand_s = std::min(time_s, put_down_s[turn]);
      box.time.push_back(time_s);
      box.position.emplace_back(
          motion.tip(static_cast<std::size_t>(std::lround(100 * of_hand_s)), kIndex) -
          Vec3(0.03, 0, 0.01));
      box.orientation.push_back(Quat::Identity());
    }
    return box;
  }
};

const Vec3 kA(-0.1, 0.25, 0), kB(0.15, 0.3, 0), kA2(-0.25, 0.35, 0), kB2(0.3, 0.1, 0);

void expect_turn(const Movement& movement, const PickAndPlace& script, std::size_t turn) {
  const Phase* grasp = last_phase(movement, PhaseKind::grasp);
  const Phase* transport = last_phase(movement, PhaseKind::transport);
  ASSERT_TRUE(grasp && transport) << turn;
  EXPECT_NEAR(grasp->end_s, script.taken_s[turn], 0.12) << turn;
  EXPECT_NEAR(transport->end_s, script.put_down_s[turn], 0.12) << turn;
  EXPECT_TRUE(is_put_down(movement)) << turn;
  for (const PhaseKind kind :
       {PhaseKind::lift, PhaseKind::place, PhaseKind::release, PhaseKind::retreat})
    EXPECT_NE(last_phase(movement, kind), nullptr) << name_of(kind) << turn;
}

TEST(NextGrasp, TwoThingsAreTwoMovements) {
  PickAndPlace script;
  script.move(kA, kA2);
  script.move(kB, kB2);
  const HumanMotion motion = script.finish();
  SegmentOptions options;
  options.plan_until = PhaseKind::return_phase;
  const auto movements =
      segment(motion, options, {script.box("a", motion, {0}), script.box("b", motion, {1})});
  ASSERT_EQ(movements.size(), 2u);
  EXPECT_EQ(movements[0].target, "a");
  EXPECT_EQ(movements[1].target, "b");
  for (std::size_t turn : {0u, 1u}) expect_turn(movements[turn], script, turn);
  EXPECT_EQ(last_phase(movements[0], PhaseKind::home), nullptr) << "the hand goes on";
  EXPECT_NE(last_phase(movements[1], PhaseKind::home), nullptr);
  EXPECT_LE(movements[0].end_s, movements[1].begin_s + 1e-9);
  EXPECT_GT(movements[0].end_s, script.put_down_s[0] + 0.3) << "the hand has let go";
}

TEST(NextGrasp, ThreeThingsAreThreeMovements) {
  PickAndPlace script;
  script.move(kA, kA2);
  script.move(kB, kB2);
  script.move({0.0, 0.35, 0}, {0.1, 0.45, 0});
  const HumanMotion motion = script.finish();
  const auto movements = segment(
      motion, {},
      {script.box("a", motion, {0}), script.box("b", motion, {1}), script.box("c", motion, {2})});
  ASSERT_EQ(movements.size(), 3u);
  for (std::size_t turn : {0u, 1u, 2u}) expect_turn(movements[turn], script, turn);
  EXPECT_EQ(movements[2].target, "c");
}

TEST(NextGrasp, OneThingThatIsTakenTwiceIsTwoMovements) {
  PickAndPlace script;
  script.move(kA, kA2);
  script.stroke({0.1, 0.2, 0.1}, 0.8);  // away, but not home
  script.now_s += 0.4;
  script.move(kA2, kB);
  const HumanMotion motion = script.finish();
  const auto movements = segment(motion, {}, {script.box("a", motion, {0, 1})});
  ASSERT_EQ(movements.size(), 2u);
  for (std::size_t turn : {0u, 1u}) expect_turn(movements[turn], script, turn);
}

/// Between two visits of home the movements are as without the other thing.
TEST(NextGrasp, AHandThatGoesHomeInBetweenReturns) {
  PickAndPlace script;
  script.move(kA, kA2);
  script.stroke(Vec3::Zero(), 0.8);
  script.now_s += 0.4;
  script.move(kB, kB2);
  const HumanMotion motion = script.finish();
  const auto movements =
      segment(motion, {}, {script.box("a", motion, {0}), script.box("b", motion, {1})});
  ASSERT_EQ(movements.size(), 2u);
  for (const Movement& movement : movements)
    EXPECT_NE(last_phase(movement, PhaseKind::home), nullptr);
}

}  // namespace
}  // namespace morphe::segment
