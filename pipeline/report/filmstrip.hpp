#pragma once

#include <string>

#include "core/motion/plan.hpp"
#include "core/robot/robot.hpp"
#include "pipeline/report/plan_view.hpp"

namespace morphe::report {

/// Returns a picture of a plan for print, as SVG of 1000 px width on a white background. It shows
/// person and robot at film_instants() from in front of the person, as capsules in parallel
/// projection. Charts below them show the speed of both, and the errors of the tips with their
/// tolerances. `plan_path` is the plan's name in the title, which says `not_verified`.
std::string filmstrip(const robot::Robot& robot, const Plan& plan, const std::string& plan_path,
                      const PlanView& view, bool not_verified = false);

}  // namespace morphe::report
