#pragma once

#include <string>

#include "core/files/sha256.hpp"
#include "core/store/bytes.hpp"

namespace morphe::store {

/// Returns the SHA-256 of the stored data of a plan and its robot. Results computed from a plan are
/// stored with it, to detect that the plan has changed.
inline std::string fingerprint(const RobotModel& robot, const Plan& plan) {
  return files::sha256(bytes_of(robot) + bytes_of(plan));
}

}  // namespace morphe::store
