#pragma once

#include <string>

#include "core/files/sha256.hpp"
#include "core/store/bytes.hpp"

namespace morphe::store {

/// SHA-256 of all that a file holds of a plan and of the robot that it is for: what was computed
/// from a plan can tell whether it still is that plan.
inline std::string fingerprint(const RobotTable& robot, const Plan& plan) {
  return files::sha256(bytes_of(robot) + bytes_of(plan));
}

}  // namespace morphe::store
