#include "pipeline/explain/wrist_offset.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/humanlike/arm_headroom.hpp"
#include "core/math/statistics.hpp"
#include "core/motion/goal_interpolation.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::explain {
namespace {

/// The vectors of the sum at a sample, and the lengths of the links.
struct WristSample {
  bool is_hand_known = false;
  Vec3 placement, links, from_human;
  Vec3 tips = Vec3::Zero(), palm = Vec3::Zero(), fingers;
  double upper_arm, forearm, human_upper_arm, human_forearm;

  /// Returns the sum of the vectors that these changes leave, but for the base's shift.
  Vec3 remainder(unsigned changes) const {
    Vec3 sum = placement;
    if (!(changes & kLinksChange)) sum += links;
    if (!(changes & kFingersChange)) sum += fingers;
    if (!(changes & kPalmChange)) sum += palm;
    if (!(changes & kTipsChange)) sum += tips;
    return sum;
  }
};
using WristSamples = std::vector<WristSample>;

Vec3 mean_of(const std::vector<Vec3>& vectors) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& vector : vectors) mean += vector / static_cast<double>(vectors.size());
  return vectors.empty() ? unknown_point() : mean;
}

/// Returns the RMS distance of the vectors from a point.
double rms_about(const Vec3& point, const std::vector<Vec3>& vectors) {
  double sum = 0;
  for (const Vec3& vector : vectors) sum += (vector - point).squaredNorm();
  return vectors.empty() ? kUnknown : std::sqrt(sum / static_cast<double>(vectors.size()));
}

std::vector<Vec3> column(const WristSamples& samples, Vec3 WristSample::*vector) {
  std::vector<Vec3> all;
  for (const WristSample& sample : samples) all.push_back(sample.*vector);
  return all;
}

double mean_length(const WristSamples& samples, double WristSample::*length) {
  std::vector<double> all;
  for (const WristSample& sample : samples) all.push_back(sample.*length);
  return math::mean(all);
}

/// Takes the wrist's distance from the person's apart, if the person's hand and the goal of a tip
/// are known.
void split_distance(const robot::Robot& robot, const std::vector<Pose>& frames, const Goals& goals,
                    double time_s, const Vec3& robot_wrist, const Vec3& human_wrist,
                    WristSample& sample) {
  sample.fingers = sample.from_human;
  const Quat hand = wrist_orientation_at(goals, time_s);
  std::vector<Vec3> driven, wanted;
  for (std::size_t tip = 0; tip < robot.tips.size(); ++tip) {
    const Vec3 goal = tip_goal_at(goals, tip, time_s);
    if (robot.tips[tip].finger < 0 || !is_known(goal)) continue;
    driven.push_back(robot::tip_pose(robot, frames, static_cast<int>(tip)).translation());
    wanted.push_back(goal);
  }
  if (!is_known(hand) || driven.empty()) return;
  sample.is_hand_known = true;
  const Eigen::Matrix3d from_hand(hand), from_palm = frames[robot.palm_frame].linear();
  const Vec3 in_palm = from_palm.transpose() * (robot_wrist - mean_of(driven));
  const Vec3 in_hand = from_hand.transpose() * (human_wrist - mean_of(wanted));
  sample.tips = mean_of(driven) - mean_of(wanted);
  sample.palm = (from_palm - from_hand) * in_palm;
  sample.fingers = from_hand * (in_palm - in_hand);
}

WristSamples samples_of(const robot::Robot& robot, const Plan& plan) {
  WristSamples samples;
  std::vector<Pose> frames;
  for (int k = 0; k < std::ssize(plan.trajectory.time); ++k) {
    robot::forward_kinematics(robot, plan.trajectory.position.row(k).transpose(), frames);
    const double time_s = plan.trajectory.demonstration_time[k];
    const humanlike::ArmPoints arm = humanlike::arm_points(robot, frames);
    const humanlike::ArmPoints human = humanlike::arm_points(plan.goals, time_s);
    const Vec3 offset = humanlike::wrist_offset(human, arm);
    if (!is_known(offset)) continue;
    WristSample& sample = samples.emplace_back();
    sample.placement = human.shoulder - arm.shoulder;
    sample.from_human = arm.wrist - human.wrist;
    sample.links = offset - sample.placement - sample.from_human;
    split_distance(robot, frames, plan.goals, time_s, arm.wrist, human.wrist, sample);
    sample.upper_arm = (arm.elbow - arm.shoulder).norm();
    sample.forearm = (arm.wrist - arm.elbow).norm();
    sample.human_upper_arm = (human.elbow - human.shoulder).norm();
    sample.human_forearm = (human.wrist - human.elbow).norm();
  }
  if (std::ranges::any_of(samples, &WristSample::is_hand_known))
    std::erase_if(samples, [](const WristSample& sample) { return !sample.is_hand_known; });
  return samples;
}

}  // namespace

WristOffset wrist_offset(const robot::Robot& robot, const Plan& plan) {
  WristOffset offset;
  const WristSamples samples = samples_of(robot, plan);
  if (samples.empty()) return offset;
  for (unsigned changes = 0; changes < kWristChangeSums; ++changes) {
    std::vector<Vec3> remainders;
    for (const WristSample& sample : samples) remainders.push_back(sample.remainder(changes));
    const Vec3 shift = changes & kBaseChange ? mean_of(remainders) : Vec3::Zero();
    offset.after[changes] = rms_about(shift, remainders);
    if (changes == kBaseChange) offset.base_shift = shift;
  }
  offset.is_hand_known = samples.front().is_hand_known;
  const auto rms = [&](Vec3 WristSample::*vector) {
    return rms_about(Vec3::Zero(), column(samples, vector));
  };
  offset.from_human = rms(&WristSample::from_human);
  offset.tips = rms(&WristSample::tips);
  offset.palm = rms(&WristSample::palm);
  offset.fingers = rms(&WristSample::fingers);
  offset.upper_arm = mean_length(samples, &WristSample::upper_arm);
  offset.forearm = mean_length(samples, &WristSample::forearm);
  offset.human_upper_arm = mean_length(samples, &WristSample::human_upper_arm);
  offset.human_forearm = mean_length(samples, &WristSample::human_forearm);
  return offset;
}

}  // namespace morphe::explain
