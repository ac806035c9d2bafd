#include <fmt/format.h>

#include <cmath>

#include "core/math/statistics.hpp"
#include "core/robot/files/generate.hpp"
#include "pipeline/study/paper_cases.hpp"

namespace morphe::study {
namespace {

struct MappedRobot {
  robot::Robot robot;
  MappedPoses ours;
  std::vector<char> reachable;
};

MappedRobot map_and_judge(const PaperContext& context, RobotModel robot,
                          const std::vector<HumanPoses>& series) {
  StudyWeights plain = context.weights;
  plain.humanlike = 0;
  MappedRobot result{robot::Robot(std::move(robot)), {}, {}};
  result.reachable = reachable_frames(map_all(context, result.robot, series, plain));
  result.ours = map_all(context, result.robot, series, context.weights);
  return result;
}

void add_rows(const Case& condition, const MappedRobot& mapping, double position_limit_m,
              double orientation_limit_rad, StudyResult& result) {
  const MappedPoses& ours = mapping.ours;
  const ReachableRows rows{condition, ours.q.size(), mapping.reachable, result};
  rows.add("position error, all frames", "m", math::mean(ours.position_m));
  rows.add("position error, reachable frames", "m",
           mean_of_marked(ours.position_m, mapping.reachable))
      .at_most = position_limit_m;
  const double orientation_rad = math::mean(ours.orientation_rad);
  if (!std::isnan(orientation_rad)) {
    rows.add("orientation error, all frames", "rad", orientation_rad);
    rows.add("orientation error, reachable frames", "rad",
             mean_of_marked(ours.orientation_rad, mapping.reachable))
        .at_most = orientation_limit_rad;
  }
  const double humanlike_m2 = math::mean(ours.humanlike_m2);
  if (!std::isnan(humanlike_m2)) rows.add("A, mean over centres", "m^2", humanlike_m2);
  rows.add_solve_time(ours);
}

/// Plots the last pose of the first movement.
void add_plot(const std::string& file, const std::string& title, const MappedRobot& mapping,
              const std::vector<HumanPoses>& series, StudyResult& result) {
  const JointVector& q = mapping.ours.q[series.front().size() - 1];
  result.plots.emplace_back(
      file, pose_plot(title, series.front().back(), {{"robot", arm_chain_of(mapping.robot, q)}}));
}

}  // namespace

void run_tracking(const PaperContext& context, StudyResult& result) {
  struct Entry {
    const char *figure, *name;
    int joints;
    bool hand;
    double position_m, orientation_deg;  // requirement; published are 0.2 mm and 0.10 degrees
  };
  for (const Entry& entry : {Entry{"5", "arm 18", 18, false, kUnknown, kUnknown},
                             Entry{"5", "arm 44 with hand", 44, true, 1e-3, kUnknown},
                             Entry{"6", "arm 20", 20, false, 0.2e-3, 0.10},
                             Entry{"6", "arm 23 with hand", 23, true, 1e-3, kUnknown}}) {
    const robot::ArmSpec arm{.joints = entry.joints, .length = context.arm_length()};
    const human::HandSize hand = context.robot_hand();
    const auto& series = entry.hand ? context.tips : context.arms;
    const MappedRobot mapping = map_and_judge(
        context,
        entry.hand ? robot::generate_arm_hand(arm, {.length = hand.length, .breadth = hand.breadth})
                   : robot::generate_arm(arm),
        series);
    const Case condition = {{"figure", entry.figure}, {"robot", entry.name}};
    add_rows(condition, mapping, entry.position_m, entry.orientation_deg * kRadPerDegree, result);
    add_plot(fmt::format("figure_{}_{}{}", entry.figure, entry.joints, entry.hand ? "_hand" : ""),
             fmt::format("Fig. {}: {}", entry.figure, entry.name), mapping, series, result);
  }
}

void run_fingers(const PaperContext& context, StudyResult& result) {
  for (int m = 3; m <= 6; ++m) {
    const human::HandSize size = context.robot_hand();
    const MappedRobot mapping = map_and_judge(
        context,
        robot::generate_hand({.fingers = m, .length = size.length, .breadth = size.breadth}),
        context.hands);
    add_rows({{"figure", "4"}, {"fingers", std::to_string(m)}}, mapping, 1e-3, kUnknown, result);
  }
}

void run_scales(const PaperContext& context, StudyResult& result) {
  NamedChains chains;
  for (const double scale : {0.8, 0.9, 1.0, 1.1, 1.2}) {
    const MappedRobot mapping = map_and_judge(
        context, robot::generate_arm({.joints = 21, .length = scale * context.arm_length()}),
        context.arms);
    const std::string name = fmt::format("{:.0f} %", 100 * scale);
    add_rows({{"figure", "7"}, {"length", name}}, mapping, kUnknown, kUnknown, result);
    chains.emplace_back(
        name, arm_chain_of(mapping.robot, mapping.ours.q[context.arms.front().size() - 1]));
  }
  result.plots.emplace_back("figure_7", pose_plot("Fig. 7: 21 joints, five lengths",
                                                  context.arms.front().back(), chains));
}

void run_terms(const PaperContext& context, StudyResult& result) {
  struct Entry {
    const char* name;
    double position, orientation, humanlike;
  };
  const robot::Robot robot(robot::generate_arm({.joints = 21, .length = context.arm_length()}));
  NamedChains chains;
  for (const Entry& entry :
       {Entry{"all terms", 1, 1, 1}, Entry{"position and orientation", 1, 1, 0},
        Entry{"position", 1, 0, 0}, Entry{"orientation", 0, 1, 0}, Entry{"humanlike", 0, 0, 1}}) {
    const StudyWeights weights{entry.position * context.weights.tip_position,
                               entry.orientation * context.weights.tip_orientation,
                               entry.humanlike * context.weights.humanlike};
    const MappedPoses ours = map_all(context, robot, context.arms, weights);
    const Case condition = {{"figure", "8"}, {"terms", entry.name}};
    const std::ptrdiff_t n = std::ssize(ours.q);
    result.add(condition, "position error", "m", math::mean(ours.position_m), n);
    result.add(condition, "orientation error", "rad", math::mean(ours.orientation_rad), n);
    result.add(condition, "A, mean over centres", "m^2", math::mean(ours.humanlike_m2), n);
    chains.emplace_back(entry.name, arm_chain_of(robot, ours.q[context.arms.front().size() - 1]));
  }
  result.plots.emplace_back(
      "figure_8", pose_plot("Fig. 8: effect of each term", context.arms.front().back(), chains));
}

}  // namespace morphe::study
