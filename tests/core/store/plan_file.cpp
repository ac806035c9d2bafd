#include "core/store/plan_file.hpp"

#include <gmock/gmock.h>

#include "same_flags.hpp"
#include "same_scene.hpp"
#include "sample_data.hpp"

namespace morphe::store {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void expect_same(const RobotModel& a, const RobotModel& b) {
  EXPECT_SAME(name);
  EXPECT_SAME(joint_names);
  EXPECT_SAME(lower);
  EXPECT_SAME(upper);
  EXPECT_SAME(velocity);
  EXPECT_SAME(acceleration);
  EXPECT_SAME(jerk);
  EXPECT_SAME(shoulder_frame);
  EXPECT_SAME(palm_frame);
  EXPECT_EQ(a.allowed_collision_pairs, b.allowed_collision_pairs);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_SAME(frames[i].name);
    EXPECT_SAME(frames[i].parent);
    EXPECT_SAME(frames[i].transform);
    EXPECT_SAME(frames[i].axis);
    EXPECT_SAME(frames[i].joint);
    EXPECT_SAME(frames[i].ratio);
    EXPECT_SAME(frames[i].offset);
    EXPECT_SAME(frames[i].prismatic);
  }
  ASSERT_EQ(a.coupled_limits.size(), b.coupled_limits.size());
  for (std::size_t i = 0; i < a.coupled_limits.size(); ++i) {
    EXPECT_SAME(coupled_limits[i].frame);
    EXPECT_SAME(coupled_limits[i].lower);
    EXPECT_SAME(coupled_limits[i].upper);
    EXPECT_SAME(coupled_limits[i].velocity);
    EXPECT_SAME(coupled_limits[i].acceleration);
    EXPECT_SAME(coupled_limits[i].jerk);
  }
  ASSERT_EQ(a.braking_curves.size(), b.braking_curves.size());
  for (std::size_t i = 0; i < a.braking_curves.size(); ++i) {
    EXPECT_SAME(braking_curves[i].joint);
    EXPECT_SAME(braking_curves[i].twice_deceleration);
    EXPECT_SAME(braking_curves[i].velocity_offset);
    EXPECT_SAME(braking_curves[i].lower_end);
    EXPECT_SAME(braking_curves[i].upper_end);
  }
  EXPECT_SAME(unchecked_links);
  ASSERT_EQ(a.tips.size(), b.tips.size());
  for (std::size_t i = 0; i < a.tips.size(); ++i) {
    EXPECT_SAME(tips[i].name);
    EXPECT_SAME(tips[i].frame);
    EXPECT_SAME(tips[i].transform);
    EXPECT_SAME(tips[i].finger);
    EXPECT_SAME(tips[i].finger_curve_share);
  }
  ASSERT_EQ(a.joint_centres.size(), b.joint_centres.size());
  for (std::size_t i = 0; i < a.joint_centres.size(); ++i) {
    EXPECT_SAME(joint_centres[i].frame);
    EXPECT_SAME(joint_centres[i].chain);
  }
  ASSERT_EQ(a.capsules.size(), b.capsules.size());
  for (std::size_t i = 0; i < a.capsules.size(); ++i) {
    EXPECT_SAME(capsules[i].name);
    EXPECT_SAME(capsules[i].frame);
    EXPECT_SAME(capsules[i].from);
    EXPECT_SAME(capsules[i].to);
    EXPECT_SAME(capsules[i].radius);
    EXPECT_SAME(capsules[i].may_touch_target);
  }
}

void expect_same(const Goals& a, const Goals& b) {
  EXPECT_SAME(time);
  EXPECT_SAME(tip_position);
  EXPECT_SAME(tip_orientation);
  EXPECT_SAME(reachable);
  EXPECT_SAME(shoulder_position);
  EXPECT_SAME(elbow_position);
  EXPECT_SAME(wrist_position);
  EXPECT_SAME(wrist_orientation);
  EXPECT_SAME(finger_joint_position);
  EXPECT_SAME(estimated);
  EXPECT_SAME(common_base_offset);
}

void expect_same(const Trajectory& a, const Trajectory& b) {
  EXPECT_SAME(time);
  EXPECT_SAME(position);
  EXPECT_SAME(velocity);
  EXPECT_SAME(acceleration);
  EXPECT_SAME(demonstration_time);
  EXPECT_SAME(phase);
  EXPECT_SAME(origin);
  EXPECT_SAME(clearance);
}

void expect_same(const Certificate& a, const Certificate& b) {
  EXPECT_SAME(joint_limit_margin);
  EXPECT_SAME(velocity_ratio);
  EXPECT_SAME(acceleration_ratio);
  EXPECT_SAME(jerk_ratio);
  EXPECT_SAME(clearance);
  EXPECT_SAME(tip_error_max);
  EXPECT_SAME(tip_error_mean);
  EXPECT_SAME(tip_error_grasp);
  EXPECT_SAME(tip_orientation_error_max);
  EXPECT_SAME(upper_arm_error_mean);
  EXPECT_SAME(upper_arm_error_max);
  EXPECT_SAME(forearm_error_mean);
  EXPECT_SAME(forearm_error_max);
  EXPECT_SAME(swivel_error_mean);
  EXPECT_SAME(swivel_error_max);
  EXPECT_SAME(palm_error_mean);
  EXPECT_SAME(palm_error_max);
  EXPECT_SAME(wrist_speed_correlation);
  EXPECT_SAME(held_drift);
  EXPECT_SAME(held_turn);
  EXPECT_SAME(duration_ratio);
  EXPECT_SAME(humanlikeness_mapped);
  EXPECT_SAME(humanlikeness_final);
  EXPECT_SAME(sparc_robot);
  EXPECT_SAME(sparc_human);
  EXPECT_SAME(log_dimensionless_jerk_robot);
  EXPECT_SAME(log_dimensionless_jerk_human);
  ASSERT_EQ(a.clearance_by_kind.size(), b.clearance_by_kind.size());
  for (std::size_t i = 0; i < a.clearance_by_kind.size(); ++i) {
    EXPECT_SAME(clearance_by_kind[i].kind);
    EXPECT_SAME(clearance_by_kind[i].clearance);
    EXPECT_SAME(clearance_by_kind[i].first);
    EXPECT_SAME(clearance_by_kind[i].second);
    EXPECT_SAME(clearance_by_kind[i].time_s);
  }
}

void expect_same(const Finding& a, const Finding& b) {
  EXPECT_SAME(begin_s);
  EXPECT_SAME(end_s);
  EXPECT_SAME(cause);
  EXPECT_SAME(subject);
  EXPECT_SAME(other_body);
  EXPECT_SAME(excess);
  EXPECT_SAME(unit);
  EXPECT_SAME(limit);
}

void expect_same(const RepairStep& a, const RepairStep& b) {
  EXPECT_SAME(level);
  EXPECT_SAME(name);
  EXPECT_SAME(begin_s);
  EXPECT_SAME(end_s);
  EXPECT_SAME(max_joint_change);
  EXPECT_SAME(finding_count);
  EXPECT_SAME(collision_depth_sum);
  EXPECT_SAME(other_depth_sum);
  EXPECT_SAME(worst_finding);
  EXPECT_SAME(accepted);
  EXPECT_SAME(stop_reason);
}

template <class Row>
void expect_same(const std::vector<Row>& a, const std::vector<Row>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

void expect_same(const Plan& a, const Plan& b) {
  EXPECT_SAME(demonstration);
  EXPECT_SAME(subject);
  EXPECT_SAME(task);
  EXPECT_SAME(source);
  EXPECT_SAME(licence);
  EXPECT_SAME(hand);
  EXPECT_SAME(movement.index);
  EXPECT_SAME(movement.begin_s);
  EXPECT_SAME(movement.end_s);
  EXPECT_SAME(movement.target);
  ASSERT_EQ(a.movement.phases.size(), b.movement.phases.size());
  for (std::size_t i = 0; i < a.movement.phases.size(); ++i) {
    EXPECT_SAME(movement.phases[i].kind);
    EXPECT_SAME(movement.phases[i].begin_s);
    EXPECT_SAME(movement.phases[i].end_s);
    EXPECT_SAME(movement.phases[i].confidence);
  }
  EXPECT_SAME(reason);
  EXPECT_SAME(detail);
  EXPECT_SAME(tolerances.required_clearance);
  EXPECT_SAME(tolerances.max_penetration);
  EXPECT_SAME(tolerances.max_link_penetration);
  EXPECT_SAME(tolerances.tracking_tolerance_grasp);
  EXPECT_SAME(tolerances.tracking_tolerance);
  EXPECT_SAME(tolerances.max_unreachable_share);
  EXPECT_SAME(tolerances.max_tip_error);
  EXPECT_SAME(tolerances.max_missing_goal_share);
  EXPECT_SAME(tolerances.max_goal_gap_s);
  EXPECT_SAME(approximate);
  ASSERT_EQ(a.delivered.has_value(), b.delivered.has_value());
  if (a.delivered) {
    EXPECT_SAME(delivered->until);
    EXPECT_SAME(delivered->requested_end_s);
  }
  expect_same(a.goals, b.goals);
  store::expect_same(a.scene.objects, b.scene.objects);
  EXPECT_SAME(reference_frames.base_from_world);
  EXPECT_SAME(reference_frames.base_from_table);
  EXPECT_SAME(reference_frames.base_from_target);
  EXPECT_SAME(reference_frames.shoulder);
  EXPECT_SAME(mapped.position);
  EXPECT_SAME(mapped.tip_error);
  EXPECT_SAME(mapped.tip_orientation_error);
  EXPECT_SAME(mapped.objective);
  EXPECT_SAME(mapped.humanlikeness);
  EXPECT_EQ(a.branch, b.branch);
  EXPECT_SAME(mapped.status);
  EXPECT_SAME(mapped.natural_posture_error);
  EXPECT_SAME(repaired);
  store::expect_same(a.flags, b.flags);
  EXPECT_EQ(a.recording_assumptions, b.recording_assumptions);
  expect_same(a.findings, b.findings);
  expect_same(a.remaining_findings, b.remaining_findings);
  expect_same(a.repair, b.repair);
  EXPECT_SAME(path.position);
  EXPECT_SAME(path.origin);
  EXPECT_SAME(path.demonstration_time);
  EXPECT_SAME(grasp.sample);
  EXPECT_SAME(grasp.approach_direction);
  EXPECT_SAME(grasp.base_from_object);
  EXPECT_SAME(grasp.object_from_palm);
  EXPECT_SAME(grasp.tips_in_object);
  EXPECT_SAME(grasp.grasp_posture);
  EXPECT_SAME(grasp.pregrasp_posture);
  ASSERT_EQ(a.grasp.contacts.size(), b.grasp.contacts.size());
  for (std::size_t k = 0; k < a.grasp.contacts.size(); ++k) {
    EXPECT_SAME(grasp.contacts[k].tip);
    EXPECT_SAME(grasp.contacts[k].link);
    EXPECT_SAME(grasp.contacts[k].origin);
    EXPECT_SAME(grasp.contacts[k].desired_point);
    EXPECT_SAME(grasp.contacts[k].point);
    EXPECT_SAME(grasp.contacts[k].normal);
    EXPECT_SAME(grasp.contacts[k].signed_distance);
    EXPECT_SAME(grasp.contacts[k].pad_angle);
    EXPECT_SAME(grasp.contacts[k].confidence);
    EXPECT_SAME(grasp.contacts[k].normal_force);
    EXPECT_SAME(grasp.contacts[k].friction_force);
  }
  EXPECT_SAME(grasp.quality.friction_coefficient);
  EXPECT_SAME(grasp.quality.torsional_friction);
  EXPECT_SAME(grasp.quality.mass);
  EXPECT_SAME(grasp.quality.centre_of_mass);
  EXPECT_SAME(grasp.quality.characteristic_length);
  EXPECT_SAME(grasp.quality.epsilon_lower);
  EXPECT_SAME(grasp.quality.epsilon_upper);
  EXPECT_SAME(grasp.quality.required_force_worst);
  EXPECT_SAME(grasp.quality.required_force_gravity);
  EXPECT_SAME(grasp.quality.available_force);
  EXPECT_SAME(grasp.grasp_torque);
  EXPECT_SAME(grasp.servo_target);
  EXPECT_SAME(goals.tip_to_pad_share);
  EXPECT_SAME(goals.auto_closed);
  expect_same(a.trajectory, b.trajectory);
  expect_same(a.approach, b.approach);
  expect_same(a.retreat, b.retreat);
  expect_same(a.certificate, b.certificate);
}

void write_plans(const std::filesystem::path& file, const std::vector<Plan>& plans) {
  PlanWriter writer(file, plan_header(), small_robot());
  for (const Plan& plan : plans) writer.add(plan);
  writer.finish();
}

TEST(PlanFile, ReturnsEveryFieldBitForBit) {
  const auto file = fresh_file("plans.h5");
  std::vector<Plan> plans{full_plan("zz", 0), infeasible_plan("zz", 1), full_plan("aa", 0),
                          full_plan("bb", 0)};
  plans[2].approximate = true;
  plans[3].delivered = {PhaseKind::release, 3.25};
  plans[3].reason = Reason::no_path;
  write_plans(file, plans);
  const PlanReader reader(file);
  EXPECT_THAT(reader.plan_paths(), ElementsAre("zz/000", "zz/001", "aa/000", "bb/000"));
  expect_same(small_robot(), reader.robot());
  for (std::size_t i = 0; i < plans.size(); ++i) expect_same(plans[i], reader.read(i));
}

TEST(PlanFile, ReturnsTheHeader) {
  const auto file = fresh_file("plans.h5");
  write_plans(file, {});
  const PlanReader reader(file);
  const PlanFileHeader &a = plan_header(), &b = reader.header();
  EXPECT_EQ(reader.size(), 0u);
  EXPECT_SAME(config);
  EXPECT_SAME(config_sha256);
  EXPECT_SAME(built_with);
  EXPECT_SAME(dataset_sha256);
  EXPECT_SAME(software);
  EXPECT_SAME(settings);
  ASSERT_EQ(a.inputs.size(), b.inputs.size());
  for (std::size_t i = 0; i < a.inputs.size(); ++i) {
    EXPECT_SAME(inputs[i].path);
    EXPECT_SAME(inputs[i].text);
  }
  EXPECT_EQ(a.assumptions, b.assumptions);
}

TEST(PlanFile, SameCallsSameBytes) {
  const auto first = fresh_file("first.h5"), second = fresh_file("second.h5");
  for (const auto& file : {first, second})
    write_plans(file, {full_plan("b", 0), infeasible_plan("b", 1), full_plan("a", 0)});
  EXPECT_EQ(bytes_of(first), bytes_of(second));
}

TEST(PlanFile, HasNothingBesideItsContract) {
  const auto file = fresh_file("plans.h5");
  std::vector<Plan> plans{full_plan("zz", 0), infeasible_plan("zz", 1), full_plan("aa", 0)};
  plans[2].delivered = {PhaseKind::release, 3.25};
  plans[2].reason = Reason::no_path;
  write_plans(file, plans);
  const PlanReader reader(file);
  EXPECT_THAT(reader.contract_faults(), IsEmpty());
  for (std::size_t i = 0; i < plans.size(); ++i)
    EXPECT_THAT(reader.contract_faults(i, plans[i]), IsEmpty());
}

TEST(PlanFile, NamesWhatIsBesideItsContract) {
  const auto file = fresh_file("plans.h5");
  write_plans(file, {full_plan("zz", 0), infeasible_plan("zz", 1)});
  const PlanReader reader(file);
  const std::vector<std::string> faults = reader.contract_faults(0, infeasible_plan("zz", 1));
  EXPECT_THAT(faults, Contains("trajectory is not part of the format"));
  EXPECT_THAT(faults, Contains("grasp is not part of the format"));
  EXPECT_THAT(reader.contract_faults(1, full_plan("zz", 0)), Contains("trajectory is missing"));
}

TEST(PlanFile, LooksLikeTheContractToH5py) {
  const auto file = fresh_file("plans.h5");
  write_plans(file, {full_plan("zz", 0), infeasible_plan("zz", 1)});
  EXPECT_EQ(run_python("check_plans.py", file.string()), 0);
}

TEST(PlanFile, LeavesNothingWithoutFinish) {
  const auto file = fresh_file("plans.h5");
  const auto part = file.string() + ".part";
  write_bytes(file, "what was there before");
  {
    PlanWriter writer(file, plan_header(), small_robot());
    writer.add(full_plan("a", 0));
    EXPECT_TRUE(std::filesystem::exists(part));
  }
  EXPECT_FALSE(std::filesystem::exists(part));
  EXPECT_EQ(bytes_of(file), "what was there before");
}

TEST(PlanFile, RefusesToWriteWhatDoesNotFit) {
  const auto file = fresh_file("plans.h5");
  PlanWriter writer(file, plan_header(), small_robot());
  writer.add(full_plan("a", 0));
  const auto error = [&](const Plan& plan) { return input_error([&] { writer.add(plan); }); };
  EXPECT_EQ(error(full_plan("a", 0)), file.string() + ":/plans/a/000: already exists");
  EXPECT_THAT(error(full_plan("a/b", 0)), HasSubstr("'a/b' is not a valid name"));
  EXPECT_THAT(error(full_plan("", 0)), HasSubstr("'' is not a valid name"));
  Plan plan = full_plan("b", 1);
  plan.goals.tip_position = Array2D<Vec3>(4, 3, Vec3::Zero());
  EXPECT_EQ(error(plan), file.string() + ":/plans/b/001/goals/tip_position: has 3 columns, not 2");
  plan = full_plan("b", 1);
  plan.trajectory = {};
  EXPECT_THAT(error(plan), HasSubstr("/plans/b/001/trajectory: has no sample"));
}

TEST(PlanFile, RefusesAbsoluteInputPaths) {
  const auto file = fresh_file("plans.h5");
  PlanFileHeader header = plan_header();
  header.inputs = {{"/home/me/robot.yaml", ""}};
  EXPECT_THAT(input_error([&] { PlanWriter(file, header, small_robot()); }),
              HasSubstr("'/home/me/robot.yaml' is not a relative file path"));
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".part"));
}

}  // namespace
}  // namespace morphe::store
