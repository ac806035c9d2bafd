#pragma once

#include <string>
#include <string_view>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_table.hpp"

namespace morphe::store {

/// What the files of docs/formats.md hold of these, as plain bytes (bytes_layout.hpp): bit for bit,
/// and nothing that a file does not hold. Reading throws InputError for bytes that are damaged.
std::string bytes_of(const Plan& plan);
std::string bytes_of(const Demonstration& demonstration);
std::string bytes_of(const RobotTable& robot);
std::string bytes_of(const SceneObject& object);
std::string bytes_of(const PlanFileHeader& header);

Plan plan_from_bytes(std::string_view bytes);
RobotTable robot_from_bytes(std::string_view bytes);
PlanFileHeader header_from_bytes(std::string_view bytes);

}  // namespace morphe::store
