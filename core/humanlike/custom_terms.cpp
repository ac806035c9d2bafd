#include "core/humanlike/custom_terms.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/input_error.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::humanlike {
namespace {

class StatePosture final : public ResidualInput {
 public:
  StatePosture(const RobotState& state, const FrameGoal& goal)
      : ResidualInput(state.robot, state.q, state.base_from_frame, goal.tip_position, goal.shoulder,
                      goal.elbow, goal.wrist) {}

  Eigen::Matrix3Xd point_jacobian(int frame, const Vec3& point_in_base) const override {
    Eigen::Matrix3Xd jacobian(3, q.size());
    robot::point_jacobian(robot, base_from_frame, frame, point_in_base, jacobian);
    return jacobian;
  }
};

}  // namespace

void CustomTerms::add(const RobotState& state, const FrameGoal& goal, double share,
                      solve::Quadratic& model) const {
  const StatePosture posture(state, goal);
  JointVector r;
  JointRows jacobian;
  for (const CustomTerm& entry : entries) {
    r.resize(0);
    jacobian.resize(0, state.q.size());
    entry.term->residuals(posture, r, jacobian);
    if (jacobian.rows() != r.size() || jacobian.cols() != state.q.size() || !r.allFinite() ||
        !jacobian.allFinite()) {
      throw InputError(
          fmt::format("term '{}': {} residuals and a Jacobian [{}, {}] for {} joints; must be [k] "
                      "and [k, n], all finite",
                      entry.name, r.size(), jacobian.rows(), jacobian.cols(), state.q.size()));
    }
    const double weighted = share * entry.weight;
    model.value += weighted * r.squaredNorm();
    model.gradient += 2 * weighted * (jacobian.transpose() * r);
    model.hessian += 2 * weighted * (jacobian.transpose() * jacobian);
  }
}

std::string resolve_custom_terms(const std::vector<std::shared_ptr<const ResidualTerm>>& provided,
                                 CustomTerms& terms) {
  terms.weight = 1;
  for (CustomTerm& entry : terms.entries) {
    const auto found =
        std::ranges::find(provided, entry.name, [](const auto& term) { return term->name(); });
    if (found == provided.end()) return entry.name;
    entry.term = *found;
  }
  return "";
}

}  // namespace morphe::humanlike
