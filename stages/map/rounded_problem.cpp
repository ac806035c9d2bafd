#include "stages/map/rounded_problem.hpp"

#include <cmath>
#include <utility>

namespace morphe::map {
namespace {

constexpr double kGridStep_m = 0x1p-13, kGridStep_rad = 0x1p-10;

void to_grid(double step, double& value) { value = step * std::round(value / step); }

void to_grid(double& share_or_angle) { to_grid(kGridStep_rad, share_or_angle); }

void to_grid(Vec3& point) {
  for (double& part : point) to_grid(kGridStep_m, part);
}

void to_grid(Quat& rotation) {
  Eigen::Index largest = 0;
  rotation.coeffs().cwiseAbs().maxCoeff(&largest);
  if (rotation.coeffs()[largest] < 0) rotation.coeffs() *= -1;
  for (double& part : rotation.coeffs()) to_grid(part);
  rotation.normalize();
}

template <class Values>
void all_to_grid(Values& values) {
  for (auto& value : values) to_grid(value);
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
  for (humanlike::FrameGoal& goal : problem.goals) {
    humanlike::for_each_quantity(goal, [](auto& quantity) { to_grid(quantity); });
  }
  world.scene = &scene;
  problem.world = &world;
}

}  // namespace morphe::map
