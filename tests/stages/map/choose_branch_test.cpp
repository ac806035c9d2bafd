#include "stages/map/choose_branch.hpp"

#include <gtest/gtest.h>

#include "core/robot/spherical_flips.hpp"
#include "tests/core/robot/shipped_robots.hpp"

namespace morphe::map {
namespace {

/// A path of the PA10 of two equal frames, with a value.
CandidatePath standing(const JointVector& q, double value) {
  return {q.transpose().replicate(2, 1), value};
}

struct Branches : testing::Test {
  Branches() : robot(robot::shipped_robot("pa10_dlr_hit2")), flips(robot::possible_flips(robot)) {
    posture = JointVector::Zero(robot.lower.size());
    posture.head(7) << 0.3, 0.6, -0.2, 1.2, 0.4, 0.5, 0.1;
  }
  /// Returns the posture with the shoulder (0), elbow (1) or wrist (2) flipped.
  JointVector flipped(std::size_t part) const { return flip_of(part, posture); }
  JointVector flip_of(std::size_t part, const JointVector& q) const {
    return robot::apply_flip(flips.at(2 * part), q);  // those between are of no common centre
  }

  robot::Robot robot;
  std::vector<robot::SphericalFlip> flips;
  JointVector posture;
};

TEST_F(Branches, TheOneOfTheReferenceIsPreferredWithinTheShare) {
  const std::vector<CandidatePath> paths{standing(flipped(0), 1.0), standing(posture, 1.04)};
  EXPECT_EQ(choose_branch(robot, paths, posture, 0.05), 1u);
  EXPECT_EQ(choose_branch(robot, paths, posture, 0.03), 0u);
  EXPECT_EQ(choose_branch(robot, paths, flipped(0), 0.05), 0u);
}

TEST_F(Branches, WithoutAReferenceTheLeastValueIsChosen) {
  const std::vector<CandidatePath> paths{standing(posture, 1.01), standing(flipped(2), 1.0)};
  EXPECT_EQ(choose_branch(robot, paths, JointVector(), 0.05), 1u);
}

TEST_F(Branches, TheOneWithFewerPartsThatDifferIsPreferred) {
  const JointVector twice = flip_of(1, flipped(0));
  const std::vector<CandidatePath> paths{standing(twice, 1.0), standing(flipped(2), 1.01)};
  EXPECT_EQ(choose_branch(robot, paths, posture, 0.05), 1u);
}

TEST_F(Branches, WithinABranchTheLeastValueIsChosen) {
  JointVector near = posture;
  near[0] += 0.2;
  const std::vector<CandidatePath> paths{standing(near, 1.02), standing(posture, 1.01),
                                         standing(flipped(0), 1.0)};
  EXPECT_EQ(choose_branch(robot, paths, posture, 0.05), 1u);
}

}  // namespace
}  // namespace morphe::map
