#include "stages/verify/mapped.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/frame_poses.hpp"
#include "stages/verify/pad.hpp"

namespace morphe::verify {
namespace {

constexpr double kMappedTolerance = 1e-6;
constexpr double kMet_m = 0.001, kRounded_m = 1e-9;

/// The worst difference of a column of figures.
struct Worst {
  double off = 0, stored = 0, own = 0;
  void compare(double is, double wanted) {
    if (std::isnan(is) && std::isnan(wanted)) return;
    const double apart = std::abs(is - wanted) / std::max(1.0, std::abs(wanted));
    if (apart <= off) return;
    off = std::isnan(apart) ? kInfinity : apart;
    stored = is;
    own = wanted;
  }
  void note(const char* subject, ViolationRuns& runs) const {
    if (off > kMappedTolerance) runs.note_plan("mapped", subject, stored, own);
  }
};

double turned_from(const Pose& pose, const Quat& goal) {
  const Eigen::Vector4d a = Quat(pose.linear()).coeffs(), b = goal.coeffs();
  return 4 * std::asin(std::min(1.0, std::min((a - b).norm(), (a + b).norm()) / 2));
}

class MappedJudge {
 public:
  MappedJudge(const RobotTable& robot, const Plan& plan)
      : robot_(robot), plan_(plan), pads_(pad_balls(robot)) {}

  void judge(ViolationRuns& runs) {
    for (std::size_t f = 0; f < plan_.goals.frames(); ++f) judge_frame(f);
    position_.note("position_error", runs);
    orientation_.note("orientation_error", runs);
    likeness_.note("humanlikeness", runs);
    status_.note("status", runs);
  }

 private:
  void judge_frame(std::size_t f) {
    const Goals& goals = plan_.goals;
    const auto row = static_cast<Eigen::Index>(f);
    frame_poses(robot_, plan_.mapped.position.row(row).transpose(), poses_);
    bool any = false, met = true, nearly = true, reachable = true;
    for (std::size_t tip = 0; tip < robot_.tips.size(); ++tip) {
      const auto col = static_cast<Eigen::Index>(tip);
      orientation_.compare(plan_.mapped.orientation_error(row, col), turned(f, tip));
      const double error = away(f, tip);
      position_.compare(plan_.mapped.position_error(row, col), error);
      if (std::isnan(error)) continue;
      any = true;
      met = met && error < kMet_m - kRounded_m;
      nearly = nearly && error < kMet_m + kRounded_m;
      reachable = reachable && goals.reachable(f, tip) != 0;
    }
    const FrameStatus other = reachable ? FrameStatus::compromise : FrameStatus::out_of_reach;
    const FrameStatus said = plan_.mapped.status[f];
    const FrameStatus own = !any ? FrameStatus::no_goal : met ? FrameStatus::met : other;
    const bool good = said == own || (any && nearly && said == FrameStatus::met);
    if (!good) status_.compare(static_cast<double>(said), static_cast<double>(own));
    likeness_.compare(plan_.mapped.humanlikeness(row, 0), likeness(f));
  }

  double away(std::size_t f, std::size_t tip) const {
    const Goals& goals = plan_.goals;
    const Vec3& goal = goals.tip_position(f, tip);
    if (!seen(goal)) return kNotSeen;
    const Vec3 asked = asked_point(robot_, pads_, goals, tip, goals.time[f]);
    return (in_base(poses_, robot_.tips[tip].frame, asked) - goal).norm();
  }

  double turned(std::size_t f, std::size_t tip) const {
    const Quat& goal = plan_.goals.tip_orientation(f, tip);
    const RobotTable::Tip& own = robot_.tips[tip];
    return seen(goal)
               ? turned_from(poses_[static_cast<std::size_t>(own.frame)] * own.transform, goal)
               : kNotSeen;
  }

  double likeness(std::size_t f) const {
    const Vec3& elbow = plan_.goals.elbow_position[f];
    double sum = 0;
    bool any = false;
    for (const RobotTable::Centre& centre : robot_.centres) {
      if (centre.chain != "arm") continue;
      any = true;
      sum += (in_base(poses_, centre.frame, Vec3::Zero()) - elbow).squaredNorm();
    }
    return any && seen(elbow) ? sum : kNotSeen;
  }

  const RobotTable& robot_;
  const Plan& plan_;
  std::vector<PadBall> pads_;
  std::vector<Pose> poses_;
  Worst position_, orientation_, likeness_, status_;
};

}  // namespace

void judge_mapped(const RobotTable& robot, const Plan& plan, ViolationRuns& runs) {
  const Mapped& mapped = plan.mapped;
  const auto frames = static_cast<Eigen::Index>(plan.goals.frames());
  const auto tips = static_cast<Eigen::Index>(robot.tips.size());
  const bool whole = mapped.position.rows() == frames && mapped.position_error.rows() == frames &&
                     mapped.position_error.cols() == tips &&
                     mapped.orientation_error.rows() == frames &&
                     mapped.orientation_error.cols() == tips &&
                     mapped.humanlikeness.rows() == frames && mapped.humanlikeness.cols() == 3 &&
                     mapped.status.size() == plan.goals.frames() && mapped.position.allFinite();
  if (!whole) {
    runs.note_plan("mapped", "position", static_cast<double>(mapped.position.rows()),
                   static_cast<double>(frames));
    return;
  }
  if (!std::ranges::all_of(mapped.objective, [](double value) { return std::isfinite(value); }))
    runs.note_plan("mapped", "objective", kNotSeen, kNotSeen);
  MappedJudge(robot, plan).judge(runs);
}

}  // namespace morphe::verify
