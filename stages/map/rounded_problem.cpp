#include "stages/map/rounded_problem.hpp"

#include <cmath>
#include <utility>

namespace morphe::map {
namespace {

constexpr double kGridStep_m = 0x1p-13, kGridStep_rad = 0x1p-10;

void to_grid(double step, double& value) { value = step * std::round(value / step); }

void to_grid(Vec3& point) {
  for (double& part : point) to_grid(kGridStep_m, part);
}

void to_grid(Quat& rotation) {
  Eigen::Index largest = 0;
  rotation.coeffs().cwiseAbs().maxCoeff(&largest);
  if (rotation.coeffs()[largest] < 0) rotation.coeffs() *= -1;
  for (double& part : rotation.coeffs()) to_grid(kGridStep_rad, part);
  rotation.normalize();
}

template <class Values>
void all_to_grid(Values& values) {
  for (auto& value : values) to_grid(value);
}

void goal_to_grid(humanlike::FrameGoal& goal) {
  all_to_grid(goal.tip_position);
  all_to_grid(goal.tip_orientation);
  for (double& share : goal.pad_share) to_grid(kGridStep_rad, share);
  all_to_grid(goal.pad_normal);
  to_grid(goal.hand);
  for (Vec3* point : {&goal.shoulder, &goal.elbow, &goal.wrist}) to_grid(*point);
  all_to_grid(goal.finger_joint);
  all_to_grid(goal.interpolated_finger_joint);
  all_to_grid(goal.chain);
  for (double& angle : goal.angles) to_grid(kGridStep_rad, angle);
}

void object_to_grid(SceneObject& object) {
  for (double& length : object.size) to_grid(kGridStep_m, length);
  all_to_grid(object.position);
  all_to_grid(object.orientation);
}

}  // namespace

RoundedProblem::RoundedProblem(MappingProblem exact)
    : scene(*exact.world->scene), world(*exact.world), problem(std::move(exact)) {
  for (SceneObject& object : scene.objects) object_to_grid(object);
  for (humanlike::FrameGoal& goal : problem.goals) goal_to_grid(goal);
  world.scene = &scene;
  problem.world = &world;
}

}  // namespace morphe::map
