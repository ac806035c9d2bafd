#include "stages/verify/mapping.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"

namespace morphe::verify {
namespace {

constexpr double kMappedTolerance = 1e-6;
constexpr double kGoalMetTolerance_m = 0.001, kRoundingTolerance_m = 1e-9;

/// The largest difference in a column of values.
struct LargestDifference {
  double off = 0, stored = 0, own = 0;
  void compare(double is, double wanted) {
    if (std::isnan(is) && std::isnan(wanted)) return;
    const double apart = std::abs(is - wanted) / std::max(1.0, std::abs(wanted));
    if (apart <= off) return;
    off = std::isnan(apart) ? kInfinity : apart;
    stored = is;
    own = wanted;
  }
  void note(const char* subject, ViolationCollector& runs) const {
    if (off > kMappedTolerance) runs.note_plan("mapped", subject, stored, own);
  }
};

double rotation_angle(const Pose& pose, const Quat& goal) {
  const Eigen::Vector4d a = Quat(pose.linear()).coeffs(), b = goal.coeffs();
  return 4 * std::asin(std::min(1.0, std::min((a - b).norm(), (a + b).norm()) / 2));
}

class MappingVerifier {
 public:
  MappingVerifier(const RobotModel& robot, const Plan& plan)
      : robot_(robot), plan_(plan), pads_(pad_spheres(robot)) {}

  void judge(ViolationCollector& runs) {
    for (std::size_t f = 0; f < plan_.goals.frames(); ++f) verify_frame(f);
    position_.note("tip_error", runs);
    orientation_.note("tip_orientation_error", runs);
    likeness_.note("humanlikeness", runs);
    status_.note("status", runs);
  }

 private:
  void verify_frame(std::size_t f) {
    const Goals& goals = plan_.goals;
    const auto row = static_cast<Eigen::Index>(f);
    frame_poses(robot_, plan_.mapped.position.row(row).transpose(), poses_);
    bool any = false, met = true, nearly = true, reachable = true;
    for (std::size_t tip = 0; tip < robot_.tips.size(); ++tip) {
      const auto col = static_cast<Eigen::Index>(tip);
      orientation_.compare(plan_.mapped.tip_orientation_error(row, col),
                           tip_orientation_error(f, tip));
      const double error = tip_position_error(f, tip);
      position_.compare(plan_.mapped.tip_error(row, col), error);
      if (std::isnan(error)) continue;
      any = true;
      met = met && error < kGoalMetTolerance_m - kRoundingTolerance_m;
      nearly = nearly && error < kGoalMetTolerance_m + kRoundingTolerance_m;
      reachable = reachable && goals.reachable(f, tip) != 0;
    }
    const FrameStatus other = reachable ? FrameStatus::compromise : FrameStatus::out_of_reach;
    const FrameStatus said = plan_.mapped.status[f];
    const FrameStatus own = !any ? FrameStatus::no_goal : met ? FrameStatus::met : other;
    const bool good = said == own || (any && nearly && said == FrameStatus::met);
    if (!good) status_.compare(static_cast<double>(said), static_cast<double>(own));
    likeness_.compare(plan_.mapped.humanlikeness(row, 0), likeness(f));
  }

  double tip_position_error(std::size_t f, std::size_t tip) const {
    const Goals& goals = plan_.goals;
    const Vec3& goal = goals.tip_position(f, tip);
    if (!is_known(goal)) return kUnknown;
    const Vec3 asked = tracked_point(robot_, pads_, goals, tip, goals.time[f]);
    return (to_base_frame(poses_, robot_.tips[tip].frame, asked) - goal).norm();
  }

  double tip_orientation_error(std::size_t f, std::size_t tip) const {
    const Quat& goal = plan_.goals.tip_orientation(f, tip);
    const RobotModel::Tip& own = robot_.tips[tip];
    return is_known(goal) ? rotation_angle(poses_[own.frame] * own.transform, goal) : kUnknown;
  }

  double likeness(std::size_t f) const {
    const Vec3& elbow = plan_.goals.elbow_position[f];
    double sum = 0;
    bool any = false;
    for (const RobotModel::JointCentre& centre : robot_.joint_centres) {
      if (centre.chain != "arm") continue;
      any = true;
      sum += (to_base_frame(poses_, centre.frame, Vec3::Zero()) - elbow).squaredNorm();
    }
    return any && is_known(elbow) ? sum : kUnknown;
  }

  const RobotModel& robot_;
  const Plan& plan_;
  std::vector<PadSphere> pads_;
  std::vector<Pose> poses_;
  LargestDifference position_, orientation_, likeness_, status_;
};

}  // namespace

void verify_mapping(const RobotModel& robot, const Plan& plan, ViolationCollector& runs) {
  const MappingResult& mapped = plan.mapped;
  const auto frames = static_cast<Eigen::Index>(plan.goals.frames());
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  const bool whole = mapped.position.rows() == frames && mapped.tip_error.rows() == frames &&
                     mapped.tip_error.cols() == tips &&
                     mapped.tip_orientation_error.rows() == frames &&
                     mapped.tip_orientation_error.cols() == tips &&
                     mapped.humanlikeness.rows() == frames && mapped.humanlikeness.cols() == 3 &&
                     mapped.status.size() == plan.goals.frames() && mapped.position.allFinite();
  if (!whole) {
    runs.note_plan("mapped", "position", static_cast<double>(mapped.position.rows()),
                   static_cast<double>(frames));
    return;
  }
  if (!std::ranges::all_of(mapped.objective, [](double value) { return std::isfinite(value); }))
    runs.note_plan("mapped", "objective", kUnknown, kUnknown);
  MappingVerifier(robot, plan).judge(runs);
}

}  // namespace morphe::verify
