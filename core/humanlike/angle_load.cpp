#include "core/humanlike/angle_load.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::humanlike {

void add_angle(int frame, const Quat& current, const Quat& goal, double weight, double smoothing,
               AngleMemory& memory, Loads& loads) {
  const Quat turn = current * goal.conjugate();
  const double sine = turn.vec().norm(), cosine = std::abs(turn.w());
  const double half = std::atan2(sine, cosine);
  const double smooth = std::sqrt(half * half + smoothing * smoothing);
  const Vec3 axis = sine > 0 ? Vec3(std::copysign(1 / sine, turn.w()) * turn.vec()) : Vec3::UnitZ();
  loads.value += weight * smooth;
  const Vec3 gradient = (0.5 * weight * half / smooth) * axis;
  if (loads.curvature == Curvature::none) {
    return loads.add_rotation(frame, gradient, Eigen::Matrix3d::Zero());
  }

  double along = 1;
  if (loads.curvature == Curvature::exact) {
    const Vec3 now = half * axis;
    if (memory.smooth > 0) {
      const double before = memory.smooth;
      const double stretch = memory.half.dot(now - memory.half) / (before * before);
      memory.dual = now / before - stretch * memory.dual;
      const double norm = memory.dual.norm();
      if (norm > 1) memory.dual /= norm;
    }
    memory.half = now;
    memory.smooth = smooth;
    along = 1 - std::max(0.0, memory.dual.dot(axis)) * half / smooth;
  }
  // half * cos / sin -> 1 at 0: there the curvature across the axis equals that along it.
  const double across = sine > 1e-6 ? half * cosine / sine : 1;
  const double scale = 0.25 * weight / smooth;
  Eigen::Matrix3d hessian = (scale * (along - across)) * (axis * axis.transpose());
  hessian.diagonal().array() += scale * across;
  loads.add_rotation(frame, gradient, hessian);
}

}  // namespace morphe::humanlike
