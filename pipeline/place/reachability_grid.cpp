#include "pipeline/place/reachability_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/math/seed.hpp"
#include "core/robot/forward_kinematics.hpp"
#include "pipeline/place/constants.hpp"
#include "stages/map/frame_search.hpp"

namespace morphe::place {
namespace {

constexpr double kPi = std::numbers::pi;

double angle_to_z(const Vec3& v) { return std::atan2(std::hypot(v.x(), v.y()), v.z()); }

}  // namespace

ReachabilityGrid::ReachabilityGrid(const robot::Robot& robot, std::uint64_t seed)
    : tips_(std::ssize(robot.tips)), shoulder_(map::robot_shoulder(robot)) {
  std::vector<Pose> frames;
  std::mt19937_64 random(math::seed_from(seed, "reach"));
  std::vector<Vec3> points;
  double farthest = 0;
  for (int k = 0; k < kPostureCount; ++k) {
    robot::forward_kinematics(robot, map::random_start(robot, random), frames);
    for (int tip = 0; tip < tips_; ++tip) {
      points.push_back(robot::tip_pose(robot, frames, tip).translation() - shoulder_);
      farthest = std::max(farthest, points.back().norm());
    }
  }
  cell_size_m_ = std::max(1e-6, farthest / (kDistanceCells - 1));
  reachable_cells_.assign(tips_ * kDistanceCells * kAngleCells, 0);
  for (int k = 0; k < std::ssize(points); ++k) {
    const int distance = static_cast<int>(points[k].norm() / cell_size_m_);
    const int angle = static_cast<int>(angle_to_z(points[k]) / kPi * kAngleCells);
    for (int d = std::max(0, distance - 1); d <= std::min(kDistanceCells - 1, distance + 1); ++d)
      for (int a = std::max(0, angle - 1); a <= std::min(kAngleCells - 1, angle + 1); ++a)
        reachable_cells_[cell_index(k % tips_, d, a)] = 1;
  }
}

std::ptrdiff_t ReachabilityGrid::cell_index(std::ptrdiff_t tip, int distance, int angle) const {
  return (tip * kDistanceCells + distance) * kAngleCells + angle;
}

bool ReachabilityGrid::is_reachable(std::ptrdiff_t tip, const Vec3& from_shoulder) const {
  const double distance = from_shoulder.norm() / cell_size_m_;
  if (!(distance < kDistanceCells)) return false;
  const int angle = static_cast<int>(angle_to_z(from_shoulder) / kPi * kAngleCells);
  return reachable_cells_[cell_index(tip, static_cast<int>(distance),
                                     std::min(kAngleCells - 1, angle))] != 0;
}

double ReachabilityGrid::share_out_of_reach(const TrialMovement& trial,
                                            const BasePlacement& pose) const {
  const Quat base_from_world = pose.world_from_base.conjugate();
  const Vec3 shoulder = trial.shoulder + pose.shoulder_offset;
  int goals = 0, outside = 0;
  for (int k = 0; k < std::ssize(trial.goals); ++k) {
    if (!is_known(trial.goals[k])) continue;
    ++goals;
    outside += is_reachable(k % tips_, base_from_world * (trial.goals[k] - shoulder)) ? 0 : 1;
  }
  return goals > 0 ? static_cast<double>(outside) / goals : 0;
}

Vec3 base_from_human_shoulder(const BasePlacement& pose, const Vec3& shoulder) {
  return pose.shoulder_offset - pose.world_from_base * shoulder;
}

bool is_base_allowed(const std::vector<TrialMovement>& trials, const BasePlacement& pose,
                     const Vec3& shoulder, Side side, const PlaceOptions& options) {
  const Vec3 base = base_from_human_shoulder(pose, shoulder);
  const double person_x = side == Side::left ? kHalfShoulderBreadth_m : -kHalfShoulderBreadth_m;
  if (std::hypot(base.x() - person_x, base.y()) < options.person_clearance_m) return false;
  return std::ranges::none_of(trials, [&](const TrialMovement& trial) {
    const SceneObject* table = trial.table();
    if (!table) return false;
    const Vec3 from_table = trial.shoulder + base - table->position.front();
    return std::abs(from_table.x()) < table->size[0] / 2 &&
           std::abs(from_table.y()) < table->size[1] / 2 &&
           from_table.z() < table->size[2] / 2 + kTableClearance_m;
  });
}

}  // namespace morphe::place
