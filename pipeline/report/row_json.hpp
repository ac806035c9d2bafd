#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/motion/assumption.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::report {

/// Returns an assumption with its kind, subject and phrase.
nlohmann::ordered_json assumption_json(const Assumption& assumption);

/// Returns the row of a plan on the overview page (page/README.md), with the exact numbers.
nlohmann::ordered_json row_json(const RobotModel& robot, const Plan& plan, const std::string& path);

/// Returns the robot in the form from which the page computes its poses.
nlohmann::ordered_json robot_json(const RobotModel& robot);

}  // namespace morphe::report
