#pragma once

#include <string>
#include <string_view>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"
#include "core/motion/robot_model.hpp"

namespace morphe::store {

/// Serialises a plan, as bytes_layout.hpp describes, bit for bit: the data that the files of
/// docs/formats.md store of it, its demonstration and its index.
std::string bytes_of(const Plan& plan);
/// Serialises a demonstration.
std::string bytes_of(const Demonstration& demonstration);
/// Serialises a robot.
std::string bytes_of(const RobotModel& robot);
/// Serialises an object of the scene.
std::string bytes_of(const SceneObject& object);
/// Serialises the header of a file.
std::string bytes_of(const PlanFileHeader& header);

/// Restores a plan; throws InputError if the bytes are damaged or others follow them.
Plan plan_from_bytes(std::string_view bytes);
/// Restores a robot; throws InputError likewise.
RobotModel robot_from_bytes(std::string_view bytes);
/// Restores a header; throws InputError likewise.
PlanFileHeader header_from_bytes(std::string_view bytes);

}  // namespace morphe::store
