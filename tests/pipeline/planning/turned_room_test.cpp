#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "pipeline/planning/pipeline_config.hpp"
#include "pipeline/planning/plan_movement.hpp"
#include "stages/import/guess/heading.hpp"
#include "stages/import/guess/rotate_demonstration.hpp"
#include "tests/pipeline/planning/shipped_reach.hpp"

namespace morphe::planning {
namespace {

/// As a file with six decimals of a millimetre has it.
void round_to_nanometres(Demonstration& demonstration) {
  for (Streams* streams : {&demonstration.streams, &demonstration.calibration}) {
    for (Vec3& point : streams->markers->position.values) {
      for (double& part : point) part = std::round(part * 1e9) * 1e-9;
    }
  }
}

// Before the search was on a grid, the two paths lay 0.19 rad apart, in neighbouring minima.
TEST(TurnedRoom, APersonWhoSitsTheOtherWayGetsTheSamePlan) {
  const LoadedConfig loaded = load_config(std::filesystem::path(MORPHE_SOURCE_DIR) /
                                          "configs/pipelines/pa10_dlr_hit2.yaml");
  const PlanningInputs planner{loaded.options, loaded.robot};
  Demonstration as_is = shipped_reach("ADL001FR1", imports::ForwardSource::recorded),
                turned = as_is;
  imports::align_heading({}, as_is);
  imports::rotate_about_vertical(turned, 33.3 * kRadPerDegree);
  round_to_nanometres(turned);
  imports::align_heading({}, turned);

  const std::vector<Plan> one = plan_demonstration(planner, as_is).plans,
                          other = plan_demonstration(planner, turned).plans;
  ASSERT_EQ(one.size(), 1U);
  ASSERT_EQ(other.size(), 1U);
  ASSERT_TRUE(one[0].executable());
  EXPECT_EQ(other[0].status(), one[0].status());
  ASSERT_EQ(other[0].path.position.rows(), one[0].path.position.rows());
  const double apart = (other[0].path.position - one[0].path.position).cwiseAbs().maxCoeff();
  EXPECT_GT(apart, 0) << "the numbers do differ";
  EXPECT_LT(apart, 3e-3) << "[rad], within the tolerance of the last solve";
}

}  // namespace
}  // namespace morphe::planning
