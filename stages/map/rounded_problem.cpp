#include "stages/map/rounded_problem.hpp"

#include <cmath>
#include <utility>

#include "stages/map/constants.hpp"

namespace morphe::map {
namespace {

void to_grid(double step, double& value) { value = step * std::round(value / step); }

void to_grid(double& share_or_angle) { to_grid(kGridStep_rad, share_or_angle); }

void to_grid(Vec3& point) {
  for (double& part : point) to_grid(kGridStep_m, part);
}

void to_grid(Quat& rotation) {
  Eigen::Index largest_index = 0;
  rotation.coeffs().cwiseAbs().maxCoeff(&largest_index);  // q and -q are the same rotation
  if (rotation.coeffs()[largest_index] < 0) rotation.coeffs() *= -1;
  for (double& part : rotation.coeffs()) to_grid(part);
  rotation.normalize();
}

}  // namespace

RoundedProblem::RoundedProblem(MappingProblem exact)
    : scene(*exact.world->scene), world(*exact.world), problem(std::move(exact)) {
  for (SceneObject& object : scene.objects) {
    for (double& length : object.size) to_grid(kGridStep_m, length);
    for (Vec3& position : object.position) to_grid(position);
    for (Quat& orientation : object.orientation) to_grid(orientation);
  }
  for (humanlike::FrameGoal& goal : problem.goals) {
    humanlike::for_each_quantity(goal, [](auto& quantity) { to_grid(quantity); });
  }
  world.scene = &scene;
  problem.world = &world;
}

}  // namespace morphe::map
