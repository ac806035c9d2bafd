#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/human/arm_angles.hpp"
#include "core/human/hand.hpp"
#include "pipeline/synthesize/synthesize.hpp"

namespace morphe::synthesize {
namespace {

constexpr std::uint64_t kTruthSeed = 7;

std::vector<Demonstration> truths(const SynthesizeOptions& options, std::size_t count) {
  std::vector<Demonstration> made;
  for (std::size_t i = 0; i < count; ++i) made.push_back(synthesize(options, kTruthSeed, i).truth);
  return made;
}

bool same_values(const JointRows& a, const JointRows& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.array() == b.array() || (a.array().isNaN() && b.array().isNaN())).all();
}

double opening(const HandStream& tips, std::size_t i) {
  return (tips.position(i, 0) - tips.position(i, 1)).norm();
}

/// Speed of the index tip by fourth-order differences, not those of the labels.
std::vector<double> index_speed(const HandStream& tips) {
  std::vector<double> speed(tips.time.size(), 0);
  const double step_s = tips.time[1] - tips.time[0];
  for (std::size_t i = 2; i + 2 < speed.size(); ++i) {
    const Vec3 far = tips.position(i + 2, 1) - tips.position(i - 2, 1);
    const Vec3 near = tips.position(i + 1, 1) - tips.position(i - 1, 1);
    speed[i] = (8 * near - far).norm() / (12 * step_s);
  }
  return speed;
}

double at(const std::vector<double>& time, const std::vector<double>& values, double t) {
  const auto next = std::upper_bound(time.begin(), time.end(), t);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(next - time.begin(), 1, std::ssize(time) - 1));
  const double share = (t - time[i - 1]) / (time[i] - time[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

double greatest(const std::vector<double>& time, const std::vector<double>& values, double from,
                double to) {
  double most = 0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] >= from && time[i] <= to) most = std::max(most, values[i]);
  }
  return most;
}

bool is_bout(const Label& label) {
  return label.phase == PhaseKind::reach || label.phase == PhaseKind::transport ||
         label.phase == PhaseKind::return_phase;
}

TEST(Synthesize, IsTheSameWhateverWasMadeBefore) {
  const SynthesizeOptions options;
  const SyntheticRecording first = synthesize(options, kTruthSeed, 3);
  synthesize(options, kTruthSeed, 0);
  const SyntheticRecording again = synthesize(options, kTruthSeed, 3);
  EXPECT_EQ(first.recorded.streams.sensors->position.values,
            again.recorded.streams.sensors->position.values);
  EXPECT_TRUE(
      same_values(first.recorded.streams.hand->angles, again.recorded.streams.hand->angles));
  EXPECT_TRUE(
      same_values(first.truth.streams.arm_angles->angles, again.truth.streams.arm_angles->angles));
  EXPECT_NE(first.truth.labels[0].begin_s,
            synthesize(options, kTruthSeed, 4).truth.labels[0].begin_s);
  EXPECT_NE(first.truth.labels[0].begin_s,
            synthesize(options, kTruthSeed + 1, 3).truth.labels[0].begin_s);
}

TEST(Synthesize, TheAnglesGiveThePositions) {
  for (const Demonstration& truth : truths({}, 6)) {
    const BodyStream& joints = *truth.streams.sensors;
    const JointRows& angles = truth.streams.arm_angles->angles;
    const RobotModel hand = human::human_hand({*truth.hand_length, *truth.hand_breadth});
    std::vector<Pose> frames;
    double worst_m = 0, worst_rad = 0;
    for (std::size_t i = 0; i < joints.time.size(); i += 7) {
      const auto row = static_cast<Eigen::Index>(i);
      human::ArmAngles arm;
      for (std::size_t k = 0; k < kArmAngleCount; ++k) arm[k] = angles(row, static_cast<int>(k));
      const human::ArmPose pose =
          human::arm_pose(joints.position(i, 0), {*truth.upper_arm, *truth.forearm}, arm);
      human::HandAngles fingers;
      for (std::size_t k = 0; k < kHandAngleCount; ++k) {
        fingers.joint[k] = angles(row, static_cast<int>(kArmAngleCount + k));
      }
      fingers.palm_arch = angles(row, static_cast<int>(kArmAngleCount + kHandAngleCount));
      const human::HandPoints points = human::hand_points(hand, fingers, frames);
      worst_m = std::max({worst_m, (pose.elbow - joints.position(i, 1)).norm(),
                          (pose.wrist - joints.position(i, 2)).norm()});
      worst_rad =
          std::max(worst_rad, angle_between(pose.world_from_hand, joints.orientation(i, 2)));
      for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
        const Vec3 tip = pose.wrist + pose.world_from_hand * points.tip[finger];
        worst_m = std::max(worst_m, (tip - truth.streams.hand->position(i, finger)).norm());
      }
    }
    EXPECT_LT(worst_m, 1e-9);
    EXPECT_LT(worst_rad, 1e-7);
  }
}

TEST(Synthesize, ArmsStayWithinHumanLimitsAndMoveSmoothly) {
  const human::ArmLimits& limits = human::human_arm_limits();
  for (const Demonstration& truth : truths({}, 30)) {
    const JointRows& angles = truth.streams.arm_angles->angles;
    for (Eigen::Index k = 0; k < static_cast<Eigen::Index>(kArmAngleCount); ++k) {
      EXPECT_GT(angles.col(k).minCoeff(), limits.lower[static_cast<std::size_t>(k)]);
      EXPECT_LT(angles.col(k).maxCoeff(), limits.upper[static_cast<std::size_t>(k)]);
    }
    // A jump in acceleration of a rad/s^2 would be a third difference of 1.7e-5 rad that stays when
    // the step is halved; that of a smooth motion is an eighth.
    const auto third_difference = [&](Eigen::Index step) {
      const Eigen::Index n = angles.rows() - 3 * step;
      return (angles.middleRows(3 * step, n) - 3 * angles.middleRows(2 * step, n) +
              3 * angles.middleRows(step, n) - angles.topRows(n))
          .cwiseAbs()
          .maxCoeff();
    };
    EXPECT_LT(third_difference(1), third_difference(2) / 6);
  }
}

TEST(Synthesize, LabelsStandWhereTheIndexTipCrossesATwentiethOfItsPeak) {
  std::size_t crossings = 0, boundaries = 0;
  for (const Demonstration& truth : truths({}, 40)) {
    const std::vector<double>& time = truth.streams.hand->time;
    const std::vector<double> speed = index_speed(*truth.streams.hand);
    double last_end_s = -1;
    for (const Label& label : truth.labels) {
      if (!is_bout(label)) continue;
      const double peak = greatest(time, speed, label.begin_s, label.end_s);
      for (const double boundary_s : {label.begin_s, label.end_s}) {
        ++boundaries;
        crossings += std::abs(at(time, speed, boundary_s) / peak - 0.05) < 0.001;
      }
      // Nothing above the level between it and the bout before, but close to that bout's end.
      EXPECT_GE(label.begin_s, last_end_s);
      last_end_s = label.end_s;
    }
  }
  EXPECT_GT(boundaries, 600U);
  // The others are where a pause is too short to come to rest in.
  EXPECT_GT(static_cast<double>(crossings) / static_cast<double>(boundaries), 0.97);
}

TEST(Synthesize, PhasesFollowEachOther) {
  for (const Demonstration& truth : truths({}, 30)) {
    const double end_s = truth.streams.sensors->time.back();
    for (std::size_t k = 0; k < truth.labels.size(); ++k) {
      const Label& label = truth.labels[k];
      EXPECT_LT(label.begin_s, label.end_s);
      EXPECT_LE(label.end_s, end_s);
      if (k == 0) {
        EXPECT_EQ(label.phase, PhaseKind::reach);
        continue;
      }
      const Label& before = truth.labels[k - 1];
      if (label.phase == PhaseKind::reach) {
        EXPECT_EQ(before.phase, PhaseKind::return_phase);
        EXPECT_GT(label.begin_s, before.end_s);
      } else if (label.phase == PhaseKind::preshape) {
        EXPECT_EQ(before.phase, PhaseKind::reach);
        EXPECT_GT(label.begin_s, before.begin_s);
        EXPECT_EQ(label.end_s, before.end_s);
      } else {
        EXPECT_EQ(label.begin_s, before.end_s);
      }
    }
    EXPECT_EQ(truth.labels.back().phase, PhaseKind::return_phase);
  }
}

TEST(Synthesize, TheHandIsWidestAtTwoThirdsOfTheReachAndKeepsItsGrasp) {
  std::vector<double> shares;
  for (const Demonstration& truth : truths({}, 40)) {
    const HandStream& tips = *truth.streams.hand;
    std::vector<double> widths;
    for (std::size_t i = 0; i < tips.time.size(); ++i) widths.push_back(opening(tips, i));
    for (std::size_t k = 0; k + 1 < truth.labels.size(); ++k) {
      const Label& reach = truth.labels[k];
      if (truth.labels[k + 1].phase != PhaseKind::preshape) continue;
      const double widest = greatest(tips.time, widths, reach.begin_s, reach.end_s);
      const double resting = at(tips.time, widths, reach.begin_s);
      const double held = at(tips.time, widths, truth.labels[k + 2].end_s);
      EXPECT_GT(widest, resting + 0.015);
      EXPECT_GT(widest, held + 0.015);
      EXPECT_NEAR(at(tips.time, widths, truth.labels[k + 1].begin_s),
                  resting + 0.1 * (widest - resting), 0.0005);
      for (std::size_t p = k + 3;
           p < truth.labels.size() && truth.labels[p].phase != PhaseKind::return_phase; ++p)
        EXPECT_NEAR(at(tips.time, widths, truth.labels[p].begin_s), held, 1e-6);
      const auto widest_at = std::ranges::find(widths, widest) - widths.begin();
      shares.push_back((tips.time[static_cast<std::size_t>(widest_at)] - reach.begin_s) /
                       (reach.end_s - reach.begin_s));
    }
  }
  ASSERT_GT(shares.size(), 60U);
  const double mean =
      std::accumulate(shares.begin(), shares.end(), 0.0) / static_cast<double>(shares.size());
  EXPECT_GT(mean, 0.55);
  EXPECT_LT(mean, 0.8);
}

TEST(Synthesize, TremorShakesTheTruthButNotItsLabels) {
  SynthesizeOptions still, trembling;
  trembling.body.tremor_amplitude = 0.001;
  const Demonstration a = synthesize(still, kTruthSeed, 1).truth;
  const Demonstration b = synthesize(trembling, kTruthSeed, 1).truth;
  ASSERT_EQ(a.labels.size(), b.labels.size());
  for (std::size_t k = 0; k < a.labels.size(); ++k) {
    EXPECT_EQ(a.labels[k].begin_s, b.labels[k].begin_s);
  }
  const BodyStream &calm = a.streams.sensors.value(), &shaken = b.streams.sensors.value();
  double most = 0;
  for (std::size_t i = 0; i < calm.time.size(); ++i) {
    most = std::max(most, (shaken.position(i, 2) - calm.position(i, 2)).norm());
  }
  EXPECT_GT(most, 0.0007);
  EXPECT_LT(most, 0.0010001);
}

TEST(Synthesize, AnObjectIsCarriedFromLiftToRelease) {
  SynthesizeOptions options;
  options.object.tracked_object_share = 1;
  options.movements.kinds.no_grasp = 0;
  options.movements.kinds.lognormal = 0;  // whose tail is still moving at the lift
  for (std::size_t i = 0; i < 10; ++i) {
    const SyntheticRecording made = synthesize(options, kTruthSeed, i);
    ASSERT_EQ(made.truth.objects.size(), 1U);
    const SceneObject& object = made.truth.objects[0];
    const BodyStream& joints = *made.truth.streams.sensors;
    const HandStream& tips = *made.truth.streams.hand;
    ASSERT_EQ(object.time, joints.time);
    const auto held_at = [&](std::size_t k) -> Vec3 {
      return joints.orientation(k, 2).conjugate() * (object.position[k] - joints.position(k, 2));
    };
    EXPECT_EQ(object.orientation[0].vec().norm(), 0);  // upright
    for (const Label& label : made.truth.labels) {
      const auto first = static_cast<std::size_t>(std::ceil(label.begin_s * 240)) + 8;
      const auto last = static_cast<std::size_t>(label.end_s * 240) - 8;
      if (label.phase == PhaseKind::transport) {
        EXPECT_LT((held_at(first) - held_at(last)).norm(), 1e-9);
        EXPECT_GT((object.position[first] - object.position[last]).norm(), 0.05);
      } else if (label.phase == PhaseKind::reach) {
        EXPECT_EQ((object.position[first] - object.position[last]).norm(), 0);
      }
    }
    const Label& grasp = made.truth.labels[2];
    ASSERT_EQ(grasp.phase, PhaseKind::grasp);
    const auto k = static_cast<std::size_t>(grasp.end_s * 240);
    const double axis_to_surface_m = 0.5 * opening(tips, k) - object.size[0];
    EXPECT_NEAR(axis_to_surface_m, options.hand.pad_depth, 0.001);
  }
}

TEST(Synthesize, RecordingsMayBeginAndEndInsideAMovement) {
  SynthesizeOptions options;
  options.movements.truncated_start_share = options.movements.truncated_end_share = 1;
  std::size_t headless = 0;
  for (const Demonstration& truth : truths(options, 30)) {
    ASSERT_FALSE(truth.labels.empty());
    const double end_s = truth.streams.sensors->time.back();
    EXPECT_GE(truth.labels.front().begin_s, 0);
    EXPECT_LE(truth.labels.back().end_s, end_s + 1e-12);
    headless += truth.labels.front().phase != PhaseKind::reach;
    const std::vector<double> speed = index_speed(*truth.streams.hand);
    for (const Label& label : truth.labels) {
      if (label.phase != PhaseKind::reach) continue;  // its peak was recorded
      const std::vector<double>& time = truth.streams.hand->time;
      const double before = at(time, speed, std::max(label.begin_s, time[2]));
      const double after = at(time, speed, std::min(label.end_s, time[time.size() - 3]));
      EXPECT_GT(greatest(time, speed, label.begin_s, label.end_s), std::max(before, after));
    }
  }
  EXPECT_GT(headless, 5U);
}

TEST(Synthesize, KindsWithoutWeightNeverCome) {
  SynthesizeOptions options;
  options.movements.kinds = {0, 0, 0, 0, 0, 0, 1};
  for (const Demonstration& truth : truths(options, 5)) {
    for (const Label& label : truth.labels) {
      EXPECT_THAT(label.phase,
                  testing::AnyOf(PhaseKind::reach, PhaseKind::hold, PhaseKind::return_phase));
    }
  }
}

TEST(Synthesize, TheTaskIsThatOfItsMovements) {
  SynthesizeOptions options;
  options.movements.kinds = {0, 0, 0, 0, 0, 0, 1};
  for (const Demonstration& truth : truths(options, 3)) EXPECT_EQ(truth.task, "reach");
  options.movements.kinds = {1, 1, 1, 1, 1, 1, 0};
  for (const Demonstration& truth : truths(options, 3)) EXPECT_EQ(truth.task, "reach to grasp");
}

TEST(Synthesize, PeopleAreAsTallAsAsked) {
  SynthesizeOptions options;
  options.subject.male_share = 0;
  options.subject.percentiles = {50, 50};
  const Demonstration woman = synthesize(options, kTruthSeed, 0).truth;
  EXPECT_NEAR(*woman.upper_arm, 0.311, 1e-6);
  EXPECT_NEAR(*woman.hand_length, 0.181, 1e-6);
  options.subject = {};
  double sum = 0, squares = 0;
  constexpr std::size_t kPeople = 200;
  for (std::size_t i = 0; i < kPeople; ++i) {
    options.movements.movements_per_recording = {1, 1};
    const double length = *synthesize(options, kTruthSeed, i).truth.upper_arm;
    EXPECT_GT(length, 0.311 - 1.645 * 0.017 - 1e-6);
    EXPECT_LT(length, 0.335 + 1.645 * 0.018 + 1e-6);
    sum += length;
    squares += length * length;
  }
  EXPECT_NEAR(sum / kPeople, 0.323, 0.004);
  EXPECT_GT(std::sqrt(squares / kPeople - sum * sum / kPeople / kPeople), 0.012);
}

}  // namespace
}  // namespace morphe::synthesize
