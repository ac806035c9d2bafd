#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/humanlike/match_link_directions.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/files/description.hpp"
#include "pipeline/study/paper_cases.hpp"

namespace morphe::study {
namespace {

/// Places the base with its axis to the human's right and 15 degrees down, so that an arm whose
/// second joint cannot point straight down hangs like a human's. The robot's shoulder is at
/// `offset` from the human's [m].
Pose base_from_shoulder(const robot::Robot& robot, const Vec3& offset) {
  Pose shoulder_from_base = Pose::Identity();
  shoulder_from_base.rotate(Eigen::AngleAxisd(105 * kRadPerDegree, Vec3::UnitY()));
  shoulder_from_base.rotate(Eigen::AngleAxisd(90 * kRadPerDegree, Vec3::UnitZ()));
  const JointVector zero = JointVector::Zero(robot.joints());
  shoulder_from_base.translation() =
      offset - shoulder_from_base.linear() * arm_chain_of(robot, zero).front();
  return shoulder_from_base.inverse();
}

/// Returns the poses for a joint-to-joint mapping: those of an arm with the robot's lengths, whose
/// links point in the directions of the human's upper arm and forearm.
std::vector<HumanPoses> scaled_to_robot(const robot::Robot& robot,
                                        const std::vector<HumanPoses>& series) {
  const JointVector zero = JointVector::Zero(robot.joints());
  const std::vector<Vec3> chain = arm_chain_of(robot, zero);
  std::vector<HumanPoses> result = series;
  for (HumanPoses& poses : result) {
    for (HumanPose& pose : poses) {
      const humanlike::Chain posed =
          humanlike::match_link_directions({Vec3::Zero(), pose.elbow, pose.wrist}, chain);
      pose.elbow = posed[1] - posed[0];
      pose.wrist = posed.back() - posed[0];
    }
  }
  return result;
}

struct Metrics {
  std::vector<double> b, c;
};

Metrics metrics_of(const robot::Robot& robot, const std::vector<HumanPoses>& series,
                   const Pose& base_from_shoulder, const std::vector<JointVector>& q) {
  Metrics metrics;
  int f = 0;
  for (const HumanPoses& poses : series) {
    for (const HumanPose& pose : poses) {
      const humanlike::Chain chain = arm_chain_of(robot, q[f++]);
      const Vec3 shift = chain.front() - base_from_shoulder.translation();
      const humanlike::Chain human{chain.front(), base_from_shoulder * pose.elbow + shift,
                                   base_from_shoulder * pose.wrist + shift};
      metrics.b.push_back(humanlike::triangle_area_sum(human, chain));
      metrics.c.push_back(humanlike::hull_volume_sum(human, chain));
    }
  }
  return metrics;
}

std::vector<humanlike::FrameGoal> all_goals(const robot::Robot& robot,
                                            const std::vector<HumanPoses>& series,
                                            const Pose& base_from_shoulder) {
  std::vector<humanlike::FrameGoal> goals;
  for (const HumanPoses& poses : series)
    std::ranges::move(goals_of(robot, poses, base_from_shoulder), std::back_inserter(goals));
  return goals;
}

}  // namespace

void run_mappings(const PaperContext& context, StudyResult& result) {
  const robot::Robot robot(robot::load_robot(context.robots / "wam.yaml").table);
  const Pose base = base_from_shoulder(robot, Vec3::Zero());
  const std::vector<humanlike::FrameGoal> goals = all_goals(robot, context.arms, base);
  StudyWeights plain = context.weights, joints = context.weights;
  plain.humanlike = 0;
  joints.humanlike = context.weights.tip_position;
  struct Entry {
    const char* name;
    MappedPoses mapped;
    double published_m;
  };
  std::vector<Entry> entries;
  entries.push_back(
      {"humanlike", map_all(context, robot, context.arms, context.weights, base), kUnknown});
  entries.push_back({"joint to joint",
                     map_all(context, robot, scaled_to_robot(robot, context.arms), joints, base),
                     66.65e-3});
  entries.push_back(
      {"inverse kinematics", map_all(context, robot, context.arms, plain, base), kUnknown});
  const std::vector<char> reachable = reachable_frames(entries.back().mapped);
  const HumanPoses& first_series = context.arms.front();
  NamedChains chains;
  for (const Entry& entry : entries) {
    const MappedPoses mapped = measure_poses(robot, goals, entry.mapped.q);
    const Metrics metrics = metrics_of(robot, context.arms, base, mapped.q);
    const Case condition = {{"figure", "3"}, {"robot", "WAM"}, {"mapping", entry.name}};
    const ReachableRows rows{condition, mapped.q.size(), reachable, result};
    rows.add("position error", "m", math::mean(mapped.position_m)).published = entry.published_m;
    rows.add("orientation error", "rad", math::mean(mapped.orientation_rad));
    rows.add("A, mean over centres", "m^2", math::mean(mapped.humanlike_m2));
    rows.add("B", "m^2", math::mean(metrics.b));
    rows.add("C", "m^3", math::mean(metrics.c));
    std::vector<Vec3> chain = arm_chain_of(robot, mapped.q[first_series.size() - 1]);
    const Vec3 shoulder = base.inverse() * chain.front();
    for (Vec3& point : chain) point = base.inverse() * point - shoulder;
    chains.emplace_back(entry.name, std::move(chain));
  }
  result.plots.emplace_back(
      "figure_3", pose_plot("Fig. 3: Barrett WAM by three mappings", first_series.back(), chains));
}

void run_reference(const PaperContext& context, StudyResult& result) {
  struct Entry {
    const char *name, *file;
    double mean_m, largest_m, largest_quantile, mean_rad, largest_rad;
  };
  for (const Entry& entry :
       {Entry{"PA10", "pa10.yaml", 0.05e-3, 1e-3, 1, 0.05 * kRadPerDegree, 1 * kRadPerDegree},
        Entry{"PA10 + DLR/HIT II", "pa10_dlr_hit2.yaml", 0.2e-3, 1e-3, 0.99, kUnknown, kUnknown}}) {
    const robot::Robot robot(robot::load_robot(context.robots / entry.file).table);
    const Pose base = base_from_shoulder(robot, Vec3(0.10, -0.30, 0.30));
    StudyWeights plain = context.weights;
    plain.humanlike = 0;
    const MappedPoses without_a = map_all(context, robot, context.arms, plain, base);
    const MappedPoses ours = map_all(context, robot, context.arms, context.weights, base);
    const std::vector<char> reachable = reachable_frames(without_a);
    const Case condition = {{"section", "4.1, 4.2"}, {"robot", entry.name}};
    const ReachableRows rows{condition, ours.q.size(), reachable, result};
    const auto quantile_of = [&](const std::vector<double>& values, double share) {
      return math::quantile(marked_values(values, reachable), share);
    };
    const std::string quantile = entry.largest_quantile < 1 ? "99th percentile" : "largest";
    StudyRow& position = rows.add("position error, reachable frames", "m",
                                  mean_of_marked(ours.position_m, reachable));
    position.at_most = entry.mean_m;
    position.published = 1e-3;
    rows.add("position error, reachable frames, " + quantile, "m",
             quantile_of(ours.position_m, entry.largest_quantile))
        .at_most = entry.largest_m;
    if (!std::isnan(entry.mean_rad)) {
      StudyRow& orientation = rows.add("orientation error, reachable frames", "rad",
                                       mean_of_marked(ours.orientation_rad, reachable));
      orientation.at_most = entry.mean_rad;
      orientation.published = 1 * kRadPerDegree;
      rows.add("orientation error, reachable frames, largest", "rad",
               quantile_of(ours.orientation_rad, 1))
          .at_most = entry.largest_rad;
    }
    rows.add("A, mean over centres", "m^2", math::mean(ours.humanlike_m2));
    rows.add("A over that of plain inverse kinematics", "1",
             math::mean(ours.humanlike_m2) / math::mean(without_a.humanlike_m2));
    rows.add_solve_time(ours).published = 0.2e-3;
  }
}

}  // namespace morphe::study
