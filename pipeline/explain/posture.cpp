#include "pipeline/explain/posture.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/humanlike/arm_headroom.hpp"
#include "core/math/statistics.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::explain {
namespace {

/// Below this a figure is small: two repetitions of one person's movement differ by 6 degrees.
constexpr double kSmallError_rad = 6 * kRadPerDegree;
/// Least RMS motion of the place for the wrist at which a size can be told [m].
constexpr double kMinMotion_m = 0.01;

/// A sample at which both arms are known: the wrist's offset from its place, and that place from
/// the shoulder.
struct WristSample {
  Vec3 offset, place;
};

double rms(const std::vector<Vec3>& vectors) {
  double sum = 0;
  for (const Vec3& vector : vectors) sum += vector.squaredNorm();
  return vectors.empty() ? kUnknown : std::sqrt(sum / static_cast<double>(vectors.size()));
}

/// Returns the vectors minus their mean.
std::vector<Vec3> centred(std::vector<Vec3> vectors, Vec3& mean) {
  mean.setZero();
  for (const Vec3& vector : vectors) mean += vector / static_cast<double>(vectors.size());
  for (Vec3& vector : vectors) vector -= mean;
  return vectors;
}

/// Removes from the offset what links of another size would remove, by least squares over
///   offset = shift + (scale - 1) place,
/// of which both are given without their means.
void fit_scale(std::vector<Vec3> offset, const std::vector<Vec3>& place, WristOffset& wrist) {
  wrist.after_scale = wrist.after_shift;
  if (!(rms(place) > kMinMotion_m)) return;
  double product = 0, square = 0;
  for (std::size_t k = 0; k < offset.size(); ++k) {
    product += offset[k].dot(place[k]);
    square += place[k].squaredNorm();
  }
  const double change = product / square;
  if (change <= -1) return;  // no size of the links would help
  for (std::size_t k = 0; k < offset.size(); ++k) offset[k] -= change * place[k];
  wrist.best_scale = 1 + change;
  wrist.after_scale = rms(offset);
}

void split_offset(const std::vector<WristSample>& samples, WristOffset& wrist) {
  std::vector<Vec3> offset, place;
  for (const WristSample& sample : samples) {
    offset.push_back(sample.offset);
    place.push_back(sample.place);
  }
  wrist.rms = rms(offset);
  if (samples.empty()) return;
  Vec3 unused;
  offset = centred(std::move(offset), wrist.base_shift);
  wrist.after_shift = rms(offset);
  fit_scale(std::move(offset), centred(std::move(place), unused), wrist);
}

/// Returns what accounts for most of the wrist's offset.
FigureCause cause_of_wrist(const WristOffset& wrist) {
  const double placement = wrist.rms - wrist.after_shift;
  const double size = wrist.after_shift - wrist.after_scale, rest = wrist.after_scale;
  if (std::isnan(rest)) return FigureCause::unknown;
  if (placement >= std::max(size, rest)) return FigureCause::placement;
  return size >= rest ? FigureCause::size : FigureCause::wrist_path;
}

/// Returns `weights_or_solver` if the wrist would allow less than half of the error.
FigureCause cause_of_direction(const PostureFigure& figure, const WristOffset& wrist) {
  if (std::isnan(figure.driven)) return FigureCause::unknown;
  if (figure.driven < kSmallError_rad) return FigureCause::small;
  if (figure.driven - figure.least > figure.least) return FigureCause::weights_or_solver;
  return cause_of_wrist(wrist);
}

/// Returns what accounts for most of the palm's angle: fingers, arm, or the choice among postures.
FigureCause cause_of_palm(const PostureFigure& palm, const PalmFloor& floor) {
  if (std::isnan(palm.driven)) return FigureCause::unknown;
  if (palm.driven < kSmallError_rad) return FigureCause::small;
  if (std::isnan(floor.driven)) return FigureCause::unknown;
  const double hand = floor.hand_alone, arm = floor.whole_robot - floor.hand_alone;
  const double choice = floor.driven - floor.whole_robot;
  if (choice >= std::max(hand, arm)) return FigureCause::weights_or_solver;
  return hand >= arm ? FigureCause::robot_hand : FigureCause::placement_or_size;
}

/// Sets the least errors and the wrist's offset from all samples.
void measure_samples(const robot::Robot& robot, const Plan& plan, PostureSummary& summary) {
  std::vector<double> upper_arm, forearm, upper_arm_m, forearm_m;
  std::vector<WristSample> samples;
  std::vector<Pose> frames;
  for (int k = 0; k < std::ssize(plan.trajectory.time); ++k) {
    robot::forward_kinematics(robot, plan.trajectory.position.row(k).transpose(), frames);
    const humanlike::ArmPoints arm = humanlike::arm_points(robot, frames);
    const humanlike::ArmPoints human =
        humanlike::arm_points(plan.goals, plan.trajectory.demonstration_time[k]);
    const humanlike::LeastDirectionErrors least = humanlike::least_direction_errors(human, arm);
    upper_arm.push_back(least.upper_arm);
    forearm.push_back(least.forearm);
    const Vec3 offset = humanlike::wrist_offset(human, arm);
    if (!is_known(offset)) continue;
    samples.push_back({offset, arm.wrist - arm.shoulder - offset});
    upper_arm_m.push_back((arm.elbow - arm.shoulder).norm());
    forearm_m.push_back((arm.wrist - arm.elbow).norm());
  }
  summary.wrist.upper_arm = math::mean(upper_arm_m);
  summary.wrist.forearm = math::mean(forearm_m);
  split_offset(samples, summary.wrist);
  if (!summary.has_elbow_circle) return;
  summary.upper_arm.least = math::mean(upper_arm);
  summary.forearm.least = math::mean(forearm);
  if (!std::isnan(summary.swivel.driven)) summary.swivel.least = 0;
}

}  // namespace

PostureSummary posture_summary(const robot::Robot& robot, const Plan& plan) {
  PostureSummary summary;
  if (!plan.has_trajectory() || robot.arm_centres.empty()) return summary;
  const Certificate& certificate = plan.certificate;
  summary.has_elbow_circle = humanlike::has_elbow_circle(robot, plan.trajectory.position);
  summary.upper_arm.driven = summary.upper_arm.least = certificate.upper_arm_error_mean;
  summary.forearm.driven = summary.forearm.least = certificate.forearm_error_mean;
  summary.swivel.driven = summary.swivel.least = certificate.swivel_error_mean;
  summary.palm.driven = certificate.palm_error_mean;
  measure_samples(robot, plan, summary);
  summary.palm_floor = palm_floor(robot, plan);
  summary.palm.least = summary.palm_floor.whole_robot;
  for (PostureFigure* figure : {&summary.upper_arm, &summary.forearm, &summary.swivel})
    figure->cause = cause_of_direction(*figure, summary.wrist);
  summary.palm.cause = cause_of_palm(summary.palm, summary.palm_floor);
  return summary;
}

}  // namespace morphe::explain
