#include "pipeline/study/paper_cases.hpp"

#include <numbers>

#include "core/humanlike/arm_chain.hpp"
#include "core/math/seed.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::study {

MappedPoses map_all(const PaperContext& context, const robot::Robot& robot,
                    const std::vector<HumanPoses>& series, const StudyWeights& weights,
                    const Pose& base_from_shoulder) {
  MappedPoses all;
  for (int k = 0; k < std::ssize(series); ++k)
    all.append(map_poses(robot, goals_of(robot, series[k], base_from_shoulder), weights,
                         context.options.solver, context.options.starts,
                         math::seed_from(1, "series", k)));
  return all;
}

std::vector<char> reachable_frames(const MappedPoses& plain) {
  constexpr double kReachableTolerance_m = 1e-4,
                   kReachableTolerance_rad = 0.1 * std::numbers::pi / 180;
  std::vector<char> reachable;
  for (int f = 0; f < std::ssize(plain.q); ++f)
    reachable.push_back(!(plain.position_m[f] > kReachableTolerance_m) &&
                        !(plain.orientation_rad[f] > kReachableTolerance_rad));
  return reachable;
}

std::vector<double> marked_values(const std::vector<double>& values,
                                  const std::vector<char>& marked) {
  std::vector<double> kept;
  for (int i = 0; i < std::ssize(values); ++i) {
    if (marked[i]) kept.push_back(values[i]);
  }
  return kept;
}

double mean_of_marked(const std::vector<double>& values, const std::vector<char>& marked) {
  return math::mean(marked_values(values, marked));
}

StudyRow& ReachableRows::add(const std::string& metric, const std::string& unit,
                             double value) const {
  StudyRow& row = result.add(condition, metric, unit, value, frames);
  if (!reachable.empty())
    row.reachable = static_cast<double>(std::ranges::count(reachable, 1)) /
                    static_cast<double>(reachable.size());
  return row;
}

StudyRow& ReachableRows::add_solve_time(const MappedPoses& mapped) const {
  StudyRow& row = add("time per frame, warm start", "s", mapped.seconds / mapped.solves);
  row.is_timing = true;
  return row;
}

std::vector<Vec3> arm_chain_of(const robot::Robot& robot, const JointVector& q) {
  std::vector<Pose> frames;
  robot::forward_kinematics(robot, q, frames);
  return humanlike::arm_chain(robot, frames).joints;
}

Plot pose_plot(const std::string& title, const HumanPose& human, const NamedChains& robots) {
  Plot plot;
  plot.title = title;
  plot.x_label = "forward [m]";
  plot.y_label = "up [m]";
  plot.same_scale = true;
  const auto add = [&](const std::string& name, const std::vector<Vec3>& chain) {
    Plot::Line line{name, {}, {}};
    for (const Vec3& point : chain) {
      line.x.push_back(point.y());
      line.y.push_back(point.z());
    }
    line.dots = true;
    plot.lines.push_back(std::move(line));
  };
  add("human", {Vec3::Zero(), human.elbow, human.wrist});
  for (const auto& [name, chain] : robots) add(name, chain);
  return plot;
}

}  // namespace morphe::study
