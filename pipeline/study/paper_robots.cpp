#include <algorithm>
#include <numbers>

#include "core/humanlike/match_link_directions.hpp"
#include "core/humanlike/metrics.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/files/description.hpp"
#include "pipeline/study/paper_cases.hpp"

namespace morphe::study {
namespace {

/// Places the base with its axis to the human's right and 15 degrees down, so that an arm whose
/// second joint cannot reach straight down can hang like a human's. The robot's shoulder is
/// displaced by `offset` from the human's [m].
Pose base_from_shoulder(const robot::Robot& robot, const Vec3& offset) {
  Pose shoulder_from_base = Pose::Identity();
  shoulder_from_base.rotate(Eigen::AngleAxisd(105 * kRadPerDegree, Vec3::UnitY()));
  shoulder_from_base.rotate(Eigen::AngleAxisd(90 * kRadPerDegree, Vec3::UnitZ()));
  const JointVector zero = JointVector::Zero(robot.joints());
  shoulder_from_base.translation() =
      offset - shoulder_from_base.linear() * arm_chain_of(robot, zero).front();
  return shoulder_from_base.inverse();
}

/// Returns goals for a joint-to-joint mapping, in which upper arm, forearm and hand point in the
/// directions of the human's: the same poses for an arm of the robot's lengths, which it can meet.
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
  std::size_t f = 0;
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
  for (const HumanPoses& poses : series) {
    for (humanlike::FrameGoal& goal : goals_of(robot, poses, base_from_shoulder)) {
      goals.push_back(std::move(goal));
    }
  }
  return goals;
}

std::vector<double> marked_values(const std::vector<double>& values,
                                  const std::vector<char>& which) {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (which[i]) result.push_back(values[i]);
  }
  return result;
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
  const std::vector<char> met = reachable_frames(entries.back().mapped);
  const std::size_t last = context.arms.front().size() - 1;
  HumanPose in_base = context.arms.front().back();
  std::vector<std::pair<std::string, std::vector<Vec3>>> chains;
  for (const Entry& entry : entries) {
    const MappedPoses mapped = measure_poses(robot, goals, entry.mapped.q);
    const Metrics metrics = metrics_of(robot, context.arms, base, mapped.q);
    const Case of = {{"figure", "3"}, {"robot", "WAM"}, {"mapping", entry.name}};
    const auto row = [&](const char* metric, const char* unit, double value) -> StudyRow& {
      result.rows.push_back(make_row(of, metric, unit, value, mapped.q.size()));
      result.rows.back().reachable = marked_share(met);
      return result.rows.back();
    };
    row("position error", "m", math::mean(mapped.position_m)).published = entry.published_m;
    row("orientation error", "rad", math::mean(mapped.orientation_rad));
    row("A, mean over centres", "m^2", math::mean(mapped.humanlike_m2));
    row("B", "m^2", math::mean(metrics.b));
    row("C", "m^3", math::mean(metrics.c));
    std::vector<Vec3> chain = arm_chain_of(robot, mapped.q[last]);
    const Vec3 shoulder = base.inverse() * chain.front();
    for (Vec3& point : chain) point = base.inverse() * point - shoulder;
    chains.emplace_back(entry.name, std::move(chain));
  }
  result.plots.emplace_back("figure_3",
                            pose_plot("Fig. 3: Barrett WAM by three mappings", in_base, chains));
}

void run_reference(const PaperContext& context, StudyResult& result) {
  struct Entry {
    const char *name, *file;
    double mean_m, largest_m, share_of_largest, turn_rad, largest_rad;
  };
  for (const Entry& entry :
       {Entry{"PA10", "pa10.yaml", 0.05e-3, 1e-3, 1, 0.05 * kRadPerDegree, 1 * kRadPerDegree},
        Entry{"PA10 + DLR/HIT II", "pa10_dlr_hit2.yaml", 0.2e-3, 1e-3, 0.99, kUnknown, kUnknown}}) {
    const robot::Robot robot(robot::load_robot(context.robots / entry.file).table);
    const Pose base = base_from_shoulder(robot, Vec3(0.10, -0.30, 0.30));
    StudyWeights plain = context.weights;
    plain.humanlike = 0;
    const MappedPoses without = map_all(context, robot, context.arms, plain, base);
    const MappedPoses ours = map_all(context, robot, context.arms, context.weights, base);
    const std::vector<char> met = reachable_frames(without);
    const Case of = {{"section", "4.1, 4.2"}, {"robot", entry.name}};
    const auto row = [&](const char* metric, const char* unit, double value) -> StudyRow& {
      result.rows.push_back(make_row(of, metric, unit, value, ours.q.size()));
      result.rows.back().reachable = marked_share(met);
      return result.rows.back();
    };
    const auto quantile_of = [&](const std::vector<double>& values, double share) {
      return math::quantile(marked_values(values, met), share);
    };
    const char* part = entry.share_of_largest < 1 ? "99th percentile" : "largest";
    StudyRow& p =
        row("position error, reachable frames", "m", mean_of_marked(ours.position_m, met));
    p.at_most = entry.mean_m;
    p.published = 1e-3;
    row((std::string("position error, reachable frames, ") + part).c_str(), "m",
        quantile_of(ours.position_m, entry.share_of_largest))
        .at_most = entry.largest_m;
    if (entry.turn_rad == entry.turn_rad) {
      StudyRow& o = row("orientation error, reachable frames", "rad",
                        mean_of_marked(ours.orientation_rad, met));
      o.at_most = entry.turn_rad;
      o.published = 1 * kRadPerDegree;
      row("orientation error, reachable frames, largest", "rad",
          quantile_of(ours.orientation_rad, 1))
          .at_most = entry.largest_rad;
    }
    row("A, mean over centres", "m^2", math::mean(ours.humanlike_m2));
    row("A over that of plain inverse kinematics", "1",
        math::mean(ours.humanlike_m2) / math::mean(without.humanlike_m2));
    StudyRow& time =
        row("time per frame, warm start", "s", ours.seconds / static_cast<double>(ours.solves));
    time.is_timing = true;
    time.published = 0.2e-3;
  }
}

}  // namespace morphe::study
