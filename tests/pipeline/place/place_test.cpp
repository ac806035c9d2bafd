#include "pipeline/place/place.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/input_error.hpp"
#include "pipeline/place/reachability_grid.hpp"
#include "pipeline/place/reachability_map.hpp"
#include "pipeline/place/refine.hpp"
#include "tests/pipeline/planning/robot_demonstration.hpp"

namespace morphe::place {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// A person who moves as the robot does, whose shoulder is the robot's: no turn, no shift meets
/// every goal with the person's own upper arm and palm.
struct Known : test::RobotDemonstration {
  std::vector<TrialMovement> trials;

  Known() {
    planning::Reconstruction rebuilt{motion, {}, {movement}};
    rebuilt.on_robot_side.name = "robot";
    trials.push_back(
        make_trial(planner(), std::make_shared<const planning::Reconstruction>(rebuilt), 0)
            .value());
  }
};

PlaceOptions small() {
  PlaceOptions options;
  options.samples = 2000;
  options.candidates = 30;
  options.refine = 2;
  options.plan = 1;
  return options;
}

const ProgressCallback kSilent = [](const std::string&, int, int) {};

Candidate at(const Known& known, const BasePlacement& stand) {
  return evaluate_placement(known.planner(), stand, {&known.trials.front()}, {10, 3, 24}, 1);
}

TEST(Place, TheKnownPlaceMeetsEverything) {
  const Known known;
  const Candidate truth = at(known, {});
  EXPECT_EQ(truth.measures.out_of_reach, 0);
  EXPECT_LT(truth.measures.tip_error_m, 1e-3);
  EXPECT_EQ(truth.measures.collision_share, 0);
  EXPECT_LT(truth.measures.upper_arm_error, 10 * kRadPerDegree)
      << "the cost of motion turns the elbow about the line from shoulder to wrist";
  EXPECT_LT(truth.measures.palm_error, 15 * kRadPerDegree) << "five tips ask nothing of the palm";
  const ReachabilityGrid reach(known.robot, 1);
  EXPECT_EQ(reach.share_out_of_reach(known.trials.front(), {}), 0);
  BasePlacement far;
  far.shoulder_offset = {0, -3, 0};
  EXPECT_EQ(reach.share_out_of_reach(known.trials.front(), far), 1);
}

TEST(Place, ItIsFoundAgainFromBesideIt) {
  const Known known;
  BasePlacement beside;
  beside.shoulder_offset = {0.1, -0.08, 0.06};
  beside.world_from_base = Eigen::AngleAxisd(15 * kRadPerDegree, Vec3(1, 2, 3).normalized());
  const Candidate start = at(known, beside), truth = at(known, {});
  PlaceOptions options;
  options.mount = MountDirection::any;
  options.person_clearance_m = 0;
  const Candidate found = refine(known.planner(), beside, {}, {}, known.trials,
                                 map::robot_shoulder(known.robot), options, 1);
  EXPECT_EQ(found.measures.out_of_reach, 0);
  EXPECT_LT(found.cost, truth.cost + 3) << "three degrees of the upper arm";
  EXPECT_LT(found.cost, start.cost - 3);
}

TEST(Place, TheSameAtAnyNumberOfThreads) {
  const Known known;
  PlaceOptions options = small();
  const std::vector<PlacementResult> one =
      find_placements(known.planner(), known.trials, options, kSilent);
  options.jobs = 2;
  const std::vector<PlacementResult> two =
      find_placements(known.planner(), known.trials, options, kSilent);
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(two.size(), 1U);
  EXPECT_EQ(one[0].base_placement.world_from_base.coeffs(),
            two[0].base_placement.world_from_base.coeffs());
  EXPECT_EQ(one[0].base_placement.shoulder_offset, two[0].base_placement.shoulder_offset);
  EXPECT_EQ(cost_of(one[0].plan_summary.measures), cost_of(two[0].plan_summary.measures));
  EXPECT_EQ(one[0].plan_summary.executable, 1);
  EXPECT_EQ(one[0].plan_summary.measures.out_of_reach, 0);
  EXPECT_LT(one[0].plan_summary.measures.upper_arm_error, 20 * kRadPerDegree);
}

TEST(Place, ConstraintsHoldInWhatIsFound) {
  const Known known;
  PlaceOptions options = small();
  options.mount = MountDirection::side;
  options.max_tilt_rad = 10 * kRadPerDegree;
  options.fixed.z = true;
  const PlacementResult found =
      find_placements(known.planner(), known.trials, options, kSilent).front();
  EXPECT_GE(std::abs(found.base_placement.up().x()), std::cos(10.3 * kRadPerDegree));
  EXPECT_EQ(found.base_placement.shoulder_offset.z(), 0);
  EXPECT_GE(std::hypot(found.base.x() + 0.2, found.base.y()), options.person_clearance_m - 0.002);
  options.person_clearance_m = 0.9;
  options.fixed = {true, true, true, true};
  EXPECT_THAT(
      [&] { find_placements(known.planner(), known.trials, options, kSilent); },
      ThrowsMessage<InputError>(HasSubstr("no placement of the base satisfies the constraints")));
}

TEST(Place, AMovementThatFailsBeforeItIsMappedIsInNoMean) {
  Known known;
  const PlacementResult alone =
      plan_with_placement(known.planner(), known.trials, known.config.placement, 1);
  ASSERT_EQ(alone.plan_summary.executable, 1);
  ASSERT_GT(alone.plan_summary.measures.palm_error, 0);
  EXPECT_TRUE(alone.plan_summary.failed_before_mapping.empty());
  planning::Reconstruction unseen = *known.trials.front().reconstruction;
  std::ranges::fill(unseen.motion.tip.values, unknown_point());
  known.trials.push_back(known.trials.front());
  known.trials.back().reconstruction =
      std::make_shared<const planning::Reconstruction>(std::move(unseen));
  const PlannedSummary both =
      plan_with_placement(known.planner(), known.trials, known.config.placement, 1).plan_summary;
  EXPECT_EQ(both.movements, 2);
  EXPECT_EQ(both.executable, 1);
  ASSERT_EQ(both.failed_before_mapping.size(), 1U);
  EXPECT_THAT(both.failed_before_mapping[0], HasSubstr("(no_goal: "));
  EXPECT_EQ(both.measures.palm_error, alone.plan_summary.measures.palm_error);
  EXPECT_EQ(both.upper_arm_error_max, alone.plan_summary.upper_arm_error_max);
  EXPECT_EQ(both.measures.collision_share, 0.5) << "one of two has no trajectory";
  known.trials.erase(known.trials.begin());
  const PlannedSummary failed =
      plan_with_placement(known.planner(), known.trials, known.config.placement, 1).plan_summary;
  EXPECT_GT(cost_of(failed.measures), cost_of(both.measures)) << "as bad as can be, not perfect";
  EXPECT_EQ(failed.measures.out_of_reach, 1);
}

TEST(Place, NoBaseStandsInOrBelowTheTable) {
  Known known;
  SceneObject table;
  table.name = "table";
  table.shape = Shape::box;
  table.size = {1, 0.8, 0.04};
  table.time = {0};
  const TrialMovement& trial = known.trials.front();
  table.position = {trial.shoulder + Vec3(0, 0.6, -0.4)};
  table.orientation = {Quat::Identity()};
  known.trials.front().surroundings.objects = {table};
  const auto free = [&](const Vec3& base) {
    BasePlacement stand;
    stand.shoulder_offset = base;  // of a robot whose shoulder is its base's origin
    return is_base_allowed(known.trials, stand, Vec3::Zero(), Side::right, {});
  };
  EXPECT_TRUE(free({0.1, 0.5, -0.37}));
  EXPECT_FALSE(free({0.1, 0.5, -0.4}));
  EXPECT_FALSE(free({0.1, 0.5, -0.9}));
  EXPECT_TRUE(free({0.1, 0.1, -0.9})) << "before its edge";
  EXPECT_FALSE(free({-0.2, 0.1, 0.3})) << "in the person";
}

TEST(ReachMap, TellsWhereGoalsAreMetAndDrawsIt) {
  const Known known;
  PlacementResult found;
  found.base_placement = {};
  const ReachabilityMap map =
      reachability_map(known.planner(), known.trials, found, small(), kSilent);
  ASSERT_EQ(map.reachable_share.size(), 13U);
  EXPECT_EQ(map.reachable_share[8][6], 1) << "no shift";
  EXPECT_LT(map.reachable_share[12][0], 0.5) << "0.6 m left and 0.4 m in front";
  const std::string svg = svg_of(map);
  // Green without a shift; 300 pixels a metre, the left edge 1 m and the near one 1.15 m from it.
  EXPECT_THAT(svg, HasSubstr("fill=\"hsl(120,60%,70%)\"><title>100 %</title>"));
  EXPECT_THAT(svg, HasSubstr("<circle cx=\"350.0\" cy=\"315.0\" r=\"6\" fill=\"#06c\">"
                             "<title>robot shoulder</title>"));
}

TEST(Trials, AHandAloneHasNoBaseToPlace) {
  const robot::Robot hand(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/dlr_hit2.yaml").table);
  const planning::PipelineConfig config;
  EXPECT_THAT(
      [&] {
        make_trials({config, hand}, {}, {});
      },
      ThrowsMessage<InputError>(HasSubstr("is a hand without an arm: it has no base to place")));
}

}  // namespace
}  // namespace morphe::place
