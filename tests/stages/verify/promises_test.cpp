#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "planar_plan.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::verify {
namespace {

using Causes = std::set<std::string>;  ///< "cause subject"

Causes causes_in(const Plan& plan, const PlanRequest* asked = nullptr) {
  Causes causes;
  for (const Violation& v : verify_plan(planar::robot(), "reach/000", plan, {}, asked))
    causes.insert(v.cause + " " + v.subject);
  return causes;
}

struct Forgery {
  const char* cause;  ///< that must be among those found
  std::function<void(Plan&)> forge;
};

SceneObject& cup_of(Plan& plan) { return plan.scene.objects[1]; }

Phase& phase_of(Plan& plan, PhaseKind kind) {
  for (Phase& phase : plan.movement.phases)
    if (phase.kind == kind) return phase;
  throw std::logic_error("no such phase");
}

TEST(VerifyPromises, TipsAreJudgedBetweenThreeSamples) {
  Plan plan = planar::plan(0.5);
  ASSERT_EQ(plan.trajectory.samples(), 3u);
  EXPECT_EQ(causes_in(plan).count("tracking index"), 0u);
  plan.trajectory.velocity.row(1).setZero();  // the samples are where they were
  plan.trajectory.acceleration.row(1).setZero();
  plan.tolerances.tracking_tolerance = plan.tolerances.tracking_tolerance_grasp = 0.02;
  EXPECT_EQ(causes_in(plan).count("tracking index"), 1u);
  double farthest = 0;
  for (const Violation& v : verify_plan(planar::robot(), "", plan))
    if (v.cause == "tracking") farthest = std::max(farthest, v.value);
  EXPECT_GT(farthest, 0.02);
}

TEST(VerifyPromises, FindsPhasesThatNoMovementHas) {
  const auto grasp = PhaseKind::grasp;
  const Forgery cases[] = {
      {"phase grasp", [&](Plan& plan) { phase_of(plan, grasp).begin_s = 2.2; }},
      {"phase hold", [&](Plan& plan) { phase_of(plan, grasp).end_s = 3.5; }},
      {"phase grasp", [&](Plan& plan) { phase_of(plan, grasp).begin_s = kUnknown; }},
      {"phase grasp", [&](Plan& plan) { phase_of(plan, grasp).confidence = 2; }},
      {"phase preshape", [](Plan& plan) { phase_of(plan, PhaseKind::preshape).begin_s = 1.5; }},
      {"phase preshape", [](Plan& plan) { phase_of(plan, PhaseKind::preshape).end_s = 2.7; }},
      {"phase grasp",
       [](Plan& plan) {
         plan.movement.phases.push_back({grasp, 2.8, 2.9, 1});
       }},
      {"phase reach",
       [](Plan& plan) {
         plan.movement.phases.push_back({PhaseKind::reach, 2.8, 2.9, 1});
       }},
      {"phase movement", [](Plan& plan) { plan.movement.end_s = 3.1; }},
      {"phase movement", [](Plan& plan) { plan.movement.begin_s = 1.9; }},
      {"phase trajectory", [](Plan& plan) { plan.trajectory.phase[50] = PhaseKind::hold; }},
  };
  for (const Forgery& c : cases) {
    Plan plan = planar::plan();
    c.forge(plan);
    EXPECT_EQ(causes_in(plan).count(c.cause), 1u) << c.cause;
  }
}

TEST(VerifyPromises, EitherSideOfABorderIsGood) {
  for (const double off : {-1e-12, 1e-12}) {
    Plan plan = planar::plan();
    phase_of(plan, PhaseKind::hold).begin_s = phase_of(plan, PhaseKind::grasp).end_s = 2.8 + off;
    plan.movement.phases.back().end_s = 2.9;
    for (std::size_t k = 75; k < 101; ++k) plan.trajectory.phase[k] = PhaseKind::grasp;
    EXPECT_EQ(causes_in(plan).count("phase trajectory"), 0u);
    plan.trajectory.phase.back() = PhaseKind::hold;
    EXPECT_EQ(causes_in(plan).count("phase trajectory"), 0u);
  }
}

TEST(VerifyPromises, FindsGoalsThatAreNotThoseOfAMovement) {
  const auto keep = [](Plan& plan, std::size_t frames) {
    Goals& goals = plan.goals;
    goals.time.resize(frames);
    goals.shoulder_position.resize(frames);
    goals.elbow_position.resize(frames);
    goals.wrist_position.resize(frames);
    goals.wrist_orientation.resize(frames);
    const auto cut = [&](auto& table) {
      table.rows = frames;
      table.values.resize(frames * table.cols);
    };
    cut(goals.tip_position);
    cut(goals.tip_orientation);
    cut(goals.reachable);
    cut(goals.finger_joint_position);
  };
  const Forgery cases[] = {
      {"goals time", [&](Plan& plan) { keep(plan, 0); }},
      {"goals time", [&](Plan& plan) { keep(plan, 3); }},
      {"goals time", [&](Plan& plan) { keep(plan, 60); }},
      {"goals time", [](Plan& plan) { plan.goals.time[40] += 0.004; }},
      {"goals time", [](Plan& plan) { plan.movement.end_s -= 0.05; }},
      {"goals tip_position",
       [](Plan& plan) {
         for (Vec3& goal : plan.goals.tip_position.values) goal = unknown_point();
       }},
      {"goals tip_position",
       [](Plan& plan) {
         for (std::size_t f = 60; f < 81; ++f) plan.goals.tip_position(f, 1) = unknown_point();
       }},
      {"goals tip_position", [](Plan& plan) { plan.goals.tip_position(9, 1).x() = kUnknown; }},
      {"goals tip_orientation",
       [](Plan& plan) { plan.goals.tip_orientation(9, 1) = Quat(2, 0, 0, 0); }},
      {"goals reachable", [](Plan& plan) { plan.goals.tip_position(9, 1) = Vec3(0.9, 0, 0.1); }},
      {"time demonstration_time",
       [](Plan& plan) { plan.trajectory.demonstration_time.back() += 0.01; }},
  };
  for (const Forgery& c : cases) {
    Plan plan = planar::plan();
    c.forge(plan);
    EXPECT_EQ(causes_in(plan).count(c.cause), 1u) << c.cause;
  }
}

TEST(VerifyPromises, FindsAPlaceThatTheSceneDoesNotHave) {
  const auto taken = [](double attach_s, double release_s, const char* frame) {
    return [=](Plan& plan) {
      cup_of(plan).attach_s = attach_s;
      cup_of(plan).release_s = release_s;
      cup_of(plan).attached_frame = frame;
    };
  };
  const auto placed = [](Plan& plan) {
    plan.reference_frames.base_from_world = Pose::Identity();
    plan.reference_frames.base_from_table = Pose::Identity();
    plan.reference_frames.base_from_table.translation().z() = 0.065;
    plan.reference_frames.base_from_target = Pose::Identity();
    plan.reference_frames.base_from_target.translation() = cup_of(plan).position[0];
  };
  Plan honest = planar::plan();
  placed(honest);
  taken(2.7, 2.8, "distal")(honest);
  EXPECT_EQ(causes_in(honest), Causes());
  const Forgery cases[] = {
      {"scene target", [](Plan& plan) { cup_of(plan).name = "mug"; }},
      {"scene cup", taken(2.7, 2.8, "no frame of this robot")},
      {"scene cup", taken(2.1, 2.8, "distal")},
      {"scene cup", taken(2.7, 2.75, "distal")},
      {"scene cup", taken(kUnknown, kUnknown, "distal")},
      {"scene bottle", [](Plan& plan) { plan.scene.objects[0].attach_s = 2.7; }},
      {"scene bottle", [](Plan& plan) { plan.scene.objects.push_back(plan.scene.objects[0]); }},
      {"scene reference_frames/table",
       [](Plan& plan) { plan.reference_frames.base_from_table.translation().z() = 0; }},
      {"scene reference_frames/target",
       [](Plan& plan) { plan.reference_frames.base_from_target = Pose::Identity(); }},
      {"scene reference_frames/recording",
       [](Plan& plan) { plan.reference_frames.base_from_world.linear() *= 1.01; }},
  };
  for (const Forgery& c : cases) {
    Plan plan = planar::plan();
    placed(plan);
    c.forge(plan);
    EXPECT_EQ(causes_in(plan).count(c.cause), 1u) << c.cause;
  }
}

TEST(VerifyPromises, FindsWhatTheMappingAndThePathDidNotDo) {
  const Forgery cases[] = {
      {"mapped tip_error", [](Plan& plan) { plan.mapped.tip_error(9, 1) = 0.001; }},
      {"mapped tip_error", [](Plan& plan) { plan.mapped.tip_error(9, 0) = 0; }},
      {"mapped tip_error", [](Plan& plan) { plan.mapped.position(9, 1) += 0.01; }},
      {"mapped tip_orientation_error",
       [](Plan& plan) { plan.mapped.tip_orientation_error(9, 1) = 0; }},
      {"mapped humanlikeness", [](Plan& plan) { plan.mapped.humanlikeness(9, 0) = 0.1; }},
      {"mapped status", [](Plan& plan) { plan.mapped.status[9] = FrameStatus::out_of_reach; }},
      {"mapped objective", [](Plan& plan) { plan.mapped.objective[9] = kUnknown; }},
      {"mapped position", [](Plan& plan) { plan.mapped = {}; }},
      {"path position", [](Plan& plan) { plan.path.position(9, 1) += 1e-6; }},
      {"path demonstration_time", [](Plan& plan) { plan.path = {}; }},
      {"path demonstration_time", [](Plan& plan) { plan.path.demonstration_time.back() = 2.79; }},
      {"path trajectory",
       [](Plan& plan) {
         plan.path.origin.assign(81, SampleOrigin::re_solved);
         plan.path.position.col(0).array() += 0.3;
       }},
      {"path origin", [](Plan& plan) { plan.trajectory.origin[9] = SampleOrigin::planned; }},
      {"clearance trajectory", [](Plan& plan) { plan.trajectory.clearance[9] = 0.0052; }},
      {"clearance trajectory", [](Plan& plan) { plan.trajectory.clearance[9] = 0.0048; }},
      {"clearance trajectory", [](Plan& plan) { plan.trajectory.clearance[9] = kUnknown; }},
      {"grasp missing", [](Plan& plan) { plan.grasp = {}; }},
      {"structure remaining_findings", [](Plan& plan) { plan.remaining_findings.emplace_back(); }},
  };
  for (const Forgery& c : cases) {
    Plan plan = planar::plan();
    c.forge(plan);
    EXPECT_EQ(causes_in(plan).count(c.cause), 1u) << c.cause;
  }
}

/// What the planar plan was asked to be, with a home where it begins.
PlanRequest asked() {
  PlanRequest asked;
  asked.robot = planar::robot();
  asked.plan_until = PhaseKind::hold;
  return asked;
}

TEST(VerifyPromises, FindsWhatWasNotAskedFor) {
  const PlanRequest wanted = asked();
  EXPECT_EQ(causes_in(planar::plan(), &wanted), Causes());
  const Forgery cases[] = {
      {"config required_clearance", [](Plan& plan) { plan.tolerances.required_clearance = 0; }},
      {"config max_penetration", [](Plan& plan) { plan.tolerances.max_penetration = 0.02; }},
      {"config tracking_tolerance", [](Plan& plan) { plan.tolerances.tracking_tolerance = 0.1; }},
      {"config tracking_tolerance_grasp",
       [](Plan& plan) { plan.tolerances.tracking_tolerance_grasp = 0.1; }},
      {"config max_unreachable_share",
       [](Plan& plan) { plan.tolerances.max_unreachable_share = 0.9; }},
      {"config max_tip_error", [](Plan& plan) { plan.tolerances.max_tip_error = kUnknown; }},
      {"config max_missing_goal_share",
       [](Plan& plan) { plan.tolerances.max_missing_goal_share = 0.9; }},
      {"config max_goal_gap_s", [](Plan& plan) { plan.tolerances.max_goal_gap_s = 9; }},
      {"config begin_s", [](Plan& plan) { plan.movement.begin_s += 0.005; }},
      {"config end_s", [](Plan& plan) { plan.movement.end_s -= 0.005; }},
      {"config approach", [](Plan& plan) { plan.approach = plan.trajectory; }},
      {"config retreat", [](Plan& plan) { plan.retreat = plan.trajectory; }},
      {"config carried_by",
       [](Plan& plan) {
         cup_of(plan).attach_s = 2.7;
         cup_of(plan).attached_frame = "distal";
       }},
  };
  for (const Forgery& c : cases) {
    Plan plan = planar::plan();
    c.forge(plan);
    EXPECT_EQ(causes_in(plan, &wanted).count(c.cause), 1u) << c.cause;
  }
  PlanRequest slower = asked();
  slower.limit_scaling = 0.4;
  const Causes found = causes_in(planar::plan(), &slower);
  EXPECT_EQ(found,
            (Causes{"config velocity_ratio", "config acceleration_ratio", "config jerk_ratio"}));
  PlanRequest finer = asked();
  finer.goal_step_s = 0.005;
  EXPECT_EQ(causes_in(planar::plan(), &finer), Causes{"config goals"});
}

TEST(VerifyPromises, FindsAFlagThatIsRefusedUnlessItIsAcceptedOrMended) {
  PlanRequest wanted = asked();
  Plan plan = planar::plan();
  plan.flags = {{.code = FlagCode::spike, .response = FlagResponse::flagged}};
  EXPECT_EQ(causes_in(plan, &wanted), Causes()) << "not refused";
  wanted.refused_flags = {FlagCode::spike};
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"flag spike"});
  for (const FlagResponse answer : {FlagResponse::mended, FlagResponse::accepted}) {
    plan.flags[0].response = answer;
    EXPECT_EQ(causes_in(plan, &wanted), Causes());
  }
}

TEST(VerifyPromises, FindsALinkDepthThatIsNotTheConfigs) {
  PlanRequest wanted = asked();
  wanted.tolerances.max_link_penetration = 0.0;
  EXPECT_EQ(causes_in(planar::plan(), &wanted), Causes{"config max_link_penetration"});
  Plan plan = planar::plan();
  plan.tolerances.max_link_penetration = 0.002;
  const PlanRequest without = asked();
  EXPECT_EQ(causes_in(plan, &without), Causes{"config max_link_penetration"});
}

TEST(VerifyPromises, FindsAnApproachThatIsMissingOrDoesNotBeginAtHome) {
  PlanRequest wanted = asked();
  wanted.home.emplace();
  wanted.home->posture = planar::position_at(0);
  EXPECT_EQ(causes_in(planar::plan(), &wanted), (Causes{"config approach", "config retreat"}));
  // There and back again on the spot, but for what the sampled clearance says at its end.
  Plan plan = planar::plan();
  const auto stand = [&](Trajectory& motion, Eigen::Index row, double time_s) {
    motion = plan.trajectory;
    motion.position = plan.trajectory.position.row(row).replicate(101, 1);
    motion.velocity.setZero();
    motion.acceleration.setZero();
    std::ranges::fill(motion.demonstration_time, time_s);
    std::ranges::fill(motion.phase, PhaseKind::rest);
  };
  stand(plan.approach, 0, 2.0);
  stand(plan.retreat, 100, 2.8);
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"approach_retreat home"});  // the retreat's
  wanted.home->posture = planar::position_at(1);
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"approach_retreat home"});  // the approach's
  wanted.home->with_retreat = false;
  plan.retreat = {};
  wanted.home->posture = planar::position_at(0);
  EXPECT_EQ(causes_in(plan, &wanted), Causes());
  // It stands aside, by less than could pass once: neither at home nor where the trajectory begins.
  plan.approach.position.col(0).array() += 1e-5;
  EXPECT_EQ(causes_in(plan, &wanted), (Causes{"structure approach", "approach_retreat home"}));
}

TEST(VerifyPromises, FindsAnObstacleOfTheConfigThatIsMissingOrElsewhere) {
  Plan plan = planar::plan();
  plan.reference_frames.base_from_world = Pose(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  plan.reference_frames.base_from_table = Pose::Identity();
  plan.reference_frames.base_from_table.translation().z() = 0.065;
  plan.reference_frames.base_from_target = Pose::Identity();
  plan.reference_frames.base_from_target.translation() = cup_of(plan).position[0];
  PlanRequest wanted = asked();
  PlanRequest::Body& body = wanted.bodies.emplace_back();
  body.object = plan.scene.objects[0];
  body.relative_to = PlanRequest::ReferenceFrame::base;
  EXPECT_EQ(causes_in(plan, &wanted), Causes());
  body.relative_to = PlanRequest::ReferenceFrame::world;
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"config bottle"});
  body.object.position[0] =
      plan.reference_frames.base_from_world.inverse() * body.object.position[0];
  body.object.orientation[0] = Quat(plan.reference_frames.base_from_world.linear()).conjugate();
  EXPECT_EQ(causes_in(plan, &wanted), Causes());
  body.object.size[0] *= 2;
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"config bottle"});
  body.object.name = "shelf";
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"config shelf"});
}

}  // namespace
}  // namespace morphe::verify
