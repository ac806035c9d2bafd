#include "core/humanlike/pad_direction_term.hpp"

namespace morphe::humanlike {

void PadDirection::add(const RobotState& state, const FrameGoal& goal, double share,
                       Loads& loads) const {
  for (std::size_t i = 0; i < goal.pad_normal.size(); ++i) {
    const Vec3& normal = goal.pad_normal[i];
    const int frame = state.robot.tips[i].frame;
    if (!is_known(normal) || frame < 0) continue;
    const Vec3 middle = state.pose_of(frame).linear() * state.robot.pads[i].direction;
    const double part = share * goal.tip_to_pad_share_of(i);
    loads.value += part * (middle - normal).squaredNorm();
    const bool exact = loads.curvature == Curvature::exact;
    const Vec3& other = exact ? normal : middle;
    Eigen::Matrix3d hessian = -part * (middle * other.transpose() + other * middle.transpose());
    hessian.diagonal().array() += 2 * part * middle.dot(other);
    loads.add_rotation(frame, -2 * part * middle.cross(normal), hessian);
  }
}

}  // namespace morphe::humanlike
