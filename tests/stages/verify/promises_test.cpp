#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

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
      {"scene cup", taken(kUnknown, kUnknown, "")},
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

/// What the planar plan was asked to be, with a home where it begins: sampled at 100 Hz, the base
/// turned by 0.3 rad, and the robot's shoulder beside the person's.
PlanRequest asked() {
  PlanRequest asked;
  asked.robot = planar::robot();
  asked.plan_until = PhaseKind::hold;
  asked.sample_step_s = 0.01;
  asked.placement.world_from_base = Eigen::AngleAxisd(-0.3, Vec3::UnitZ()).matrix();
  asked.placement.shoulder_offset = Vec3(0.1, 0, 0);
  return asked;
}

/// The planar plan, placed as asked.
Plan placed_plan() {
  Plan plan = planar::plan();
  WorldFrames& frames = plan.reference_frames;
  frames.base_from_world = Pose(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
  frames.base_from_table = Pose::Identity();
  frames.base_from_table.translation().z() = 0.065;
  frames.base_from_target = Pose::Identity();
  frames.base_from_target.translation() = cup_of(plan).position[0];
  plan.goals.common_base_offset = Vec3(0.1 * std::cos(0.3), 0.1 * std::sin(0.3), 0);
  frames.shoulder = Vec3(0, 0, 0.1) - plan.goals.common_base_offset;
  return plan;
}

TEST(VerifyPromises, FindsWhatWasNotAskedFor) {
  const PlanRequest wanted = asked();
  EXPECT_EQ(causes_in(placed_plan(), &wanted), Causes());
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
      {"config sample_rate_hz", [](Plan& plan) { plan.trajectory.time[9] += 1e-4; }},
      {"config common_base_offset", [](Plan& plan) { plan.goals.common_base_offset.x() += 1e-5; }},
      {"config goals/shoulder_position",
       [](Plan& plan) { plan.goals.shoulder_position[3] = Vec3(0, 0, 0.11); }},
      {"config base_offset", [](Plan& plan) { plan.goals.base_offset = Vec3::Zero(); }},
      {"config reference_frames/recording",
       [](Plan& plan) { plan.reference_frames.base_from_world = Pose::Identity(); }},
      {"config reference_frames/recording",
       [](Plan& plan) { plan.reference_frames.base_from_world = unknown_pose(); }},
      {"config reference_frames/shoulder",
       [](Plan& plan) { plan.reference_frames.shoulder.y() += 1e-5; }},
      {"config carried_by",
       [](Plan& plan) {
         cup_of(plan).attach_s = 2.7;
         cup_of(plan).attached_frame = "distal";
       }},
  };
  for (const Forgery& c : cases) {
    Plan plan = placed_plan();
    c.forge(plan);
    EXPECT_EQ(causes_in(plan, &wanted).count(c.cause), 1u) << c.cause;
  }
  PlanRequest slower = asked();
  slower.limit_scaling = 0.4;
  const Causes found = causes_in(placed_plan(), &slower);
  EXPECT_EQ(found,
            (Causes{"config velocity_ratio", "config acceleration_ratio", "config jerk_ratio"}));
  PlanRequest finer = asked();
  finer.goal_step_s = 0.005;
  EXPECT_EQ(causes_in(placed_plan(), &finer), Causes{"config goals"});
}

TEST(VerifyPromises, FindsAFlagThatIsRefusedUnlessItIsAcceptedOrMended) {
  PlanRequest wanted = asked();
  Plan plan = placed_plan();
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
  EXPECT_EQ(causes_in(placed_plan(), &wanted), Causes{"config max_link_penetration"});
  Plan plan = placed_plan();
  plan.tolerances.max_link_penetration = 0.002;
  const PlanRequest without = asked();
  EXPECT_EQ(causes_in(plan, &without), Causes{"config max_link_penetration"});
}

TEST(VerifyPromises, FindsAnApproachThatIsMissingOrDoesNotBeginAtHome) {
  PlanRequest wanted = asked();
  wanted.home.emplace();
  wanted.home->posture = planar::position_at(0);
  EXPECT_EQ(causes_in(placed_plan(), &wanted), (Causes{"config approach", "config retreat"}));
  // There and back again on the spot, but for what the sampled clearance says at its end.
  Plan plan = placed_plan();
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
  Plan plan = placed_plan();
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

TEST(VerifyPromises, ABaseIsMovedByTheOffsetThatThePlanStates) {
  PlanRequest wanted = asked();
  wanted.placement.base_offset_limit = 0.05;
  EXPECT_EQ(causes_in(placed_plan(), &wanted), Causes{"config base_offset"}) << "none";
  Plan plan = placed_plan();
  plan.goals.base_offset = Vec3(0, 0, 0.05);
  plan.goals.common_base_offset.z() += 0.05;
  plan.reference_frames.shoulder.z() -= 0.05;
  EXPECT_EQ(causes_in(plan, &wanted), Causes());
  wanted.placement.base_offset_limit = 0.04;
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"config base_offset"});
}

TEST(VerifyPromises, ATargetHasTheShapeThatTheConfigGivesIt) {
  const double radius = planar::plan().scene.objects[1].size[0];
  PlanRequest wanted = asked();
  wanted.target.body.emplace().shape = Shape::sphere;
  wanted.target.body->size = {radius};
  Plan plan = placed_plan();
  EXPECT_EQ(causes_in(plan, &wanted), Causes{"config cup/shape"}) << "its origin is not the config";
  for (SceneObject& object : plan.scene.objects)
    object.pose_origin = object.shape_origin = ObjectOrigin::recorded;
  cup_of(plan).shape_origin = ObjectOrigin::configured;
  EXPECT_EQ(causes_in(plan, &wanted).count("config cup/shape"), 0u);
  wanted.target.body->size = {2 * radius};
  EXPECT_EQ(causes_in(plan, &wanted).count("config cup/shape"), 1u);
  wanted.target.body.reset();
  cup_of(plan).pose_origin = ObjectOrigin::inferred;
  EXPECT_EQ(causes_in(plan, &wanted).count("config cup/shape_origin"), 1u);
  wanted.target.radius = radius / 2;
  EXPECT_EQ(causes_in(plan, &wanted).count("config cup/shape_origin"), 0u);
  EXPECT_EQ(causes_in(plan, &wanted).count("config cup/size"), 1u);
}

TEST(VerifyPromises, ThePersonsOtherArmHasTheRadiiOfTheConfig) {
  PlanRequest wanted = asked();
  wanted.other_arm = {{"bottle", 0.05}, {"never seen", 0.05}};
  EXPECT_EQ(causes_in(placed_plan(), &wanted), Causes{"config bottle/size"}) << "a sphere";
  Plan plan = placed_plan();
  plan.detail = "bottle was recorded as an object: used as recorded";
  EXPECT_EQ(causes_in(plan, &wanted), Causes());
}

TEST(VerifyPromises, APlanWithoutATrajectoryHasNothingElseOfOne) {
  const PlanRequest wanted = asked();
  Plan infeasible = placed_plan();
  infeasible.reason = Reason::no_path;
  infeasible.trajectory = {};
  infeasible.certificate = {};
  infeasible.grasp = {};
  EXPECT_EQ(causes_in(infeasible, &wanted), Causes());
  const Forgery cases[] = {
      {"structure grasp", [](Plan& plan) { plan.grasp = planar::plan().grasp; }},
      {"structure approach", [](Plan& plan) { plan.approach = planar::plan().trajectory; }},
      {"structure retreat", [](Plan& plan) { plan.retreat = planar::plan().trajectory; }},
      {"certificate clearance", [](Plan& plan) { plan.certificate.clearance = 0.5; }},
      {"config tracking_tolerance", [](Plan& plan) { plan.tolerances.tracking_tolerance = 1; }},
      {"config common_base_offset", [](Plan& plan) { plan.goals.common_base_offset.x() += 1e-5; }},
      {"config end_s", [](Plan& plan) { plan.movement.end_s -= 0.005; }},
  };
  for (const Forgery& c : cases) {
    Plan plan = infeasible;
    c.forge(plan);
    EXPECT_EQ(causes_in(plan, &wanted).count(c.cause), 1u) << c.cause;
  }
}

TEST(VerifyRecorded, NamesWhatDiffersFromTheRecording) {
  Plan expected = placed_plan();
  expected.reason = Reason::unplanned;
  EXPECT_TRUE(verify_recorded("reach/000", placed_plan(), expected).empty());
  const Forgery cases[] = {
      {"subject", [](Plan& plan) { plan.subject = "P99"; }},
      {"task", [](Plan& plan) { plan.task = "another"; }},
      {"source", [](Plan& plan) { plan.source = "another"; }},
      {"licence", [](Plan& plan) { plan.licence = "CC0"; }},
      {"hand", [](Plan& plan) { plan.hand = Side::left; }},
      {"assumptions", [](Plan& plan) { plan.recording_assumptions.emplace_back(); }},
      {"flags", [](Plan& plan) { plan.flags.emplace_back(); }},
      {"target", [](Plan& plan) { plan.movement.target = "bottle"; }},
      {"phases", [](Plan& plan) { plan.movement.phases[0].begin_s -= 1e-5; }},
      {"begin_s", [](Plan& plan) { plan.movement.begin_s -= 1e-5; }},
      {"scene/rod", [](Plan& plan) { plan.scene.objects.erase(plan.scene.objects.begin() + 2); }},
      {"scene/more",
       [](Plan& plan) { plan.scene.objects.emplace_back(cup_of(plan)).name = "more"; }},
      {"scene/cup/shape", [](Plan& plan) { cup_of(plan).size[0] *= 0.5; }},
      {"scene/cup/position", [](Plan& plan) { cup_of(plan).position[0].x() += 1e-5; }},
      {"scene/cup/time", [](Plan& plan) { cup_of(plan).time.push_back(9); }},
      {"scene/cup/pose_origin",
       [](Plan& plan) { cup_of(plan).pose_origin = ObjectOrigin::recorded; }},
      {"goals/time", [](Plan& plan) { plan.goals.time[1] += 1e-5; }},
      {"goals/tip_position", [](Plan& plan) { plan.goals.tip_position(70, 1).z() += 1e-5; }},
      {"goals/tip_position", [](Plan& plan) { plan.goals.tip_position(0, 0) = Vec3::Zero(); }},
      {"goals/elbow_position", [](Plan& plan) { plan.goals.elbow_position[0] = Vec3::Zero(); }},
      {"goals/estimated", [](Plan& plan) { plan.goals.estimated = {"elbow"}; }},
  };
  for (const Forgery& c : cases) {
    Plan plan = placed_plan();
    c.forge(plan);
    const std::vector<Violation> found = verify_recorded("reach/000", plan, expected);
    ASSERT_EQ(found.size(), 1u) << c.cause;
    EXPECT_EQ(found[0].cause, "recording");
    EXPECT_EQ(found[0].subject, c.cause);
  }
  // Contacts change the goals of tips from the preshape, or shortly before the grasp, on.
  Plan touching = placed_plan();
  touching.tolerances.max_link_penetration = 0.0;
  touching.goals.tip_position(70, 1).z() += 1e-5;
  EXPECT_TRUE(verify_recorded("reach/000", touching, expected).empty());
  touching.goals.tip_position(1, 1).z() += 1e-5;
  EXPECT_EQ(verify_recorded("reach/000", touching, expected).size(), 1u);
}

}  // namespace
}  // namespace morphe::verify
