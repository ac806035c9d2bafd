#include "pipeline/place/place.hpp"

#include <gtest/gtest.h>

#include "core/motion/input_error.hpp"
#include "pipeline/place/reach.hpp"
#include "pipeline/place/reach_map.hpp"
#include "pipeline/place/refine.hpp"
#include "tests/pipeline/planning/robot_demonstration.hpp"

namespace morphe::place {
namespace {

/// A person who moves as the robot does, whose shoulder is the robot's: no turn, no shift meets
/// every goal with the person's own upper arm and palm.
struct Known : test::RobotDemonstration {
  std::vector<Trial> trials;

  Known() {
    planning::Rebuilt rebuilt{motion, {}, {movement}};
    rebuilt.beside.name = "robot";
    trials.push_back(
        make_trial(planner(), std::make_shared<const planning::Rebuilt>(rebuilt), 0).value());
  }
};

PlaceOptions small() {
  PlaceOptions options;
  options.samples = 2000;
  options.candidates = 30;
  options.refined = 2;
  options.planned = 1;
  return options;
}

const Report kSilent = [](const std::string&, int, int) {};

Candidate at(const Known& known, const Stand& stand) {
  return try_stand(known.planner(), stand, {&known.trials.front()}, {10, 3, 8}, 1);
}

TEST(Place, TheKnownPlaceMeetsEverything) {
  const Known known;
  const Candidate truth = at(known, {});
  EXPECT_EQ(truth.measures.out_of_reach, 0);
  EXPECT_LT(truth.measures.tip_error_m, 1e-3);
  EXPECT_EQ(truth.measures.colliding, 0);
  EXPECT_LT(truth.measures.upper_arm, 1 * kDegree);
  EXPECT_LT(truth.measures.palm, 15 * kDegree) << "five tips ask nothing of the palm";
  const Reach reach(known.robot, 1);
  EXPECT_EQ(reach.share_outside(known.trials.front(), {}), 0);
  Stand far;
  far.shoulder_offset = {0, -3, 0};
  EXPECT_EQ(reach.share_outside(known.trials.front(), far), 1);
}

TEST(Place, ItIsFoundAgainFromBesideIt) {
  const Known known;
  Stand beside;
  beside.shoulder_offset = {0.1, -0.08, 0.06};
  beside.world_from_base = Eigen::AngleAxisd(15 * kDegree, Vec3(1, 2, 3).normalized());
  const Candidate start = at(known, beside), truth = at(known, {});
  PlaceOptions options;
  options.person_m = 0;
  const Candidate found = refine(known.planner(), beside, {}, {}, known.trials,
                                 map::robot_shoulder(known.robot), options, 1);
  EXPECT_EQ(found.measures.out_of_reach, 0);
  EXPECT_LT(found.cost, truth.cost + 3) << "three degrees of the upper arm";
  EXPECT_LT(found.cost, start.cost - 3);
}

TEST(Place, TheSameAtAnyNumberOfThreads) {
  const Known known;
  PlaceOptions options = small();
  const std::vector<Found> one = place(known.planner(), known.trials, options, kSilent);
  options.jobs = 2;
  const std::vector<Found> two = place(known.planner(), known.trials, options, kSilent);
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(two.size(), 1U);
  EXPECT_EQ(one[0].stand.world_from_base.coeffs(), two[0].stand.world_from_base.coeffs());
  EXPECT_EQ(one[0].stand.shoulder_offset, two[0].stand.shoulder_offset);
  EXPECT_EQ(cost_of(one[0].planned.measures), cost_of(two[0].planned.measures));
  EXPECT_EQ(one[0].planned.executable, 1);
  EXPECT_EQ(one[0].planned.measures.out_of_reach, 0);
  EXPECT_LT(one[0].planned.measures.upper_arm, 20 * kDegree);
}

TEST(Place, ConstraintsHoldInWhatIsFound) {
  const Known known;
  PlaceOptions options = small();
  options.mount = Mount::side;
  options.tilt_rad = 10 * kDegree;
  options.keep.z = true;
  const Found found = place(known.planner(), known.trials, options, kSilent).front();
  EXPECT_GE(std::abs(found.stand.up().x()), std::cos(10.3 * kDegree));
  EXPECT_EQ(found.stand.shoulder_offset.z(), 0);
  EXPECT_GE(std::hypot(found.base.x() + 0.2, found.base.y()), options.person_m - 0.002);
  options.person_m = 0.9;
  options.keep = {true, true, true, true};
  EXPECT_THROW(place(known.planner(), known.trials, options, kSilent), InputError);
}

TEST(Place, NoBaseStandsInOrBelowTheTable) {
  Known known;
  SceneObject table;
  table.name = "table";
  table.shape = Shape::box;
  table.size = {1, 0.8, 0.04};
  table.time = {0};
  const Trial& trial = known.trials.front();
  table.position = {trial.shoulder + Vec3(0, 0.6, -0.4)};
  table.orientation = {Quat::Identity()};
  known.trials.front().around.objects = {table};
  const auto free = [&](const Vec3& base) {
    Stand stand;
    stand.shoulder_offset = base;  // of a robot whose shoulder is its base's origin
    return base_is_free(known.trials, stand, Vec3::Zero(), Side::right, {});
  };
  EXPECT_TRUE(free({0.1, 0.5, -0.37}));
  EXPECT_FALSE(free({0.1, 0.5, -0.4}));
  EXPECT_FALSE(free({0.1, 0.5, -0.9}));
  EXPECT_TRUE(free({0.1, 0.1, -0.9})) << "before its edge";
  EXPECT_FALSE(free({-0.2, 0.1, 0.3})) << "in the person";
}

TEST(ReachMap, TellsWhereGoalsAreMetAndDrawsIt) {
  const Known known;
  Found found;
  found.stand = {};
  const ReachMap map = reach_map(known.planner(), known.trials, found, small(), kSilent);
  ASSERT_EQ(map.met.size(), 13U);
  EXPECT_EQ(map.met[8][6], 1) << "no shift";
  EXPECT_LT(map.met[12][0], 0.5) << "0.6 m left and 0.4 m in front";
  const std::string svg = svg_of(map);
  EXPECT_EQ(svg, svg_of(map));
  EXPECT_NE(svg.find("<title>robot shoulder</title>"), std::string::npos);
}

TEST(Trials, AHandAloneHasNoBaseToPlace) {
  const robot::Robot hand(
      robot::load_robot(MORPHE_SOURCE_DIR "/configs/robots/dlr_hit2.yaml").table);
  const planning::PipelineConfig config;
  EXPECT_THROW(make_trials({config, hand}, {}, {}), InputError);
}

}  // namespace
}  // namespace morphe::place
