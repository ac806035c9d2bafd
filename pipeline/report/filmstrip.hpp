#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// Draws a plan as a picture for print (SVG, 1000 wide, white background, colours of Okabe and
/// Ito): five poses of person and robot seen from the person's front and side (at equal times of
/// the motion that follows the goals, with the one nearest to the grasp or the worst instant moved
/// there), below them the speed of both and the errors of the tips with their tolerances. Robot and
/// person are drawn by their capsules, in parallel projection. Equal plans give equal bytes.
std::string filmstrip(const robot::Robot& robot, const Plan& plan, const std::string& plan_path,
                      const PlanView& view);

}  // namespace morphe::report
