#include "pipeline/planning/verified_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pipeline/planning/plan_movement.hpp"
#include "tests/pipeline/planning/shipped_reach.hpp"

namespace morphe::planning {
namespace {

const LoadedConfig& shipped_config() {
  static const LoadedConfig config =
      load_config(MORPHE_SOURCE_DIR "/configs/pipelines/pa10_dlr_hit2.yaml");
  return config;
}

/// The shipped drink with one hand's marker names hidden from 1.4 s to 1.6 s, in the reach.
Demonstration with_hidden(const std::vector<std::string>& markers) {
  Demonstration demonstration = shipped_reach("ADL001DR2", imports::ForwardSource::body);
  MarkerStream& recorded = *demonstration.streams.markers;
  for (std::size_t m = 0; m < recorded.names.size(); ++m) {
    if (std::ranges::find(markers, recorded.names[m]) == markers.end()) continue;
    for (std::size_t f = 140; f < 160; ++f) recorded.position(f, m) = unknown_point();
  }
  return demonstration;
}

std::vector<Plan> plan_and_verify(const Demonstration& demonstration) {
  const PlanRequirements requirements = requirements_of(shipped_config());
  return plan_demonstration(
             {shipped_config().options, shipped_config().robot, nullptr, &requirements},
             demonstration)
      .plans;
}

TEST(VerifiedPlan, IsThePlanItselfIfItKeepsWhatItPromises) {
  const std::vector<Plan> plans =
      plan_and_verify(shipped_reach("ADL001DR2", imports::ForwardSource::body));
  ASSERT_EQ(plans.size(), 1u);
  EXPECT_TRUE(plans[0].executable()) << plans[0].detail;
}

TEST(VerifiedPlan, ThatIsRejectedIsInfeasibleWithoutTrajectoryAndCertificate) {
  const PlanRequirements requirements = requirements_of(shipped_config());
  const PlanningInputs planner{shipped_config().options, shipped_config().robot, nullptr,
                               &requirements};
  std::vector<Plan> plans =
      plan_demonstration(planner, shipped_reach("ADL001DR2", imports::ForwardSource::body)).plans;
  plans.at(0).trajectory.position(20, 0) += 0.5;
  const Plan rejected = verified(planner, plans[0]);
  EXPECT_EQ(rejected.reason, Reason::rejected);
  EXPECT_THAT(rejected.detail, testing::HasSubstr("fault of Morphe"));
  EXPECT_EQ(rejected.trajectory.samples(), 0u);
  EXPECT_EQ(rejected.grasp.sample, -1);
  EXPECT_TRUE(std::isnan(rejected.certificate.velocity_ratio));
  EXPECT_EQ(verified(planner, rejected).reason, Reason::rejected) << "and that is consistent";
  EXPECT_TRUE(verified({planner.config, planner.robot}, plans[0]).executable())
      << "without requirements it is not verified";
}

TEST(VerifiedPlan, AgreesWithPlanningIfPartsOfTheArmAreHidden) {
  const std::vector<std::vector<std::string>> hidden = {
      {"RHAN1", "RHAN2", "RHAN3", "RHAN4", "RSPR", "RSPU"},
      {"RLAR1", "RLAR2", "RLAR3", "RLAR4"},
      {"RUAR1", "RUAR2", "RUAR3", "RUAR4"},
      {"RSHO1", "RSHO2", "RSHO3", "RSHO4"},
      {"RFTP"},
      {"RFTP", "RTHUM"}};
  for (const std::vector<std::string>& markers : hidden) {
    for (const Plan& plan : plan_and_verify(with_hidden(markers)))
      EXPECT_NE(plan.reason, Reason::rejected) << markers[0] << ": " << plan.detail;
  }
}

}  // namespace
}  // namespace morphe::planning
