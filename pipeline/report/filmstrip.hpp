#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// A plan as a picture for paper (SVG, 1000 wide, white ground, colours of Okabe and Ito): five
/// poses of person and robot seen from the person's front and side (at equal times of the motion
/// that follows the goals, the one nearest to the grasp or the worst instant put there), below them
/// the speed of both and the tips' errors with what is allowed. Robot and person are drawn by their
/// capsules, in parallel projection. Same plan, same bytes.
std::string filmstrip(const robot::Robot& robot, const Plan& plan, const std::string& plan_path,
                      const PlanView& view);

}  // namespace morphe::report
