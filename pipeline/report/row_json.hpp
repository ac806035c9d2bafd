#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::report {

/// A plan's row of the first page (page/README.md): numbers as the file has them.
nlohmann::ordered_json row_json(const RobotTable& robot, const Plan& plan, const std::string& path);

/// The robot as the page computes its poses.
nlohmann::ordered_json robot_json(const RobotTable& robot);

}  // namespace morphe::report
