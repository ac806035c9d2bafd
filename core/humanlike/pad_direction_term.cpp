#include "core/humanlike/pad_direction_term.hpp"

namespace morphe::humanlike {

void PadDirection::add(const RobotState& state, const FrameGoal& goal, double share,
                       Loads& loads) const {
  for (int i = 0; i < std::ssize(goal.pad_normal); ++i) {
    const Vec3& normal = goal.pad_normal[i];
    const int frame = state.robot.tips[i].frame;
    if (!is_known(normal) || frame < 0) continue;
    const Vec3 direction = state.pose_of(frame).linear() * state.robot.pads[i].direction;
    const double weight_of_tip = share * goal.tip_to_pad_share_of(i);
    loads.value += weight_of_tip * (direction - normal).squaredNorm();
    const Vec3& other = loads.curvature == Curvature::exact ? normal : direction;
    Eigen::Matrix3d hessian =
        -weight_of_tip * (direction * other.transpose() + other * direction.transpose());
    hessian.diagonal().array() += 2 * weight_of_tip * direction.dot(other);
    loads.add_rotation(frame, -2 * weight_of_tip * direction.cross(normal), hessian);
  }
}

}  // namespace morphe::humanlike
