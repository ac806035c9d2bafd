#include "core/robot/files/generated_specs.hpp"

namespace morphe::robot {
namespace {

template <class Spec>
std::string common_error(const Spec& shape) {
  if (!(shape.radius >= 0)) return "radius must not be negative";
  return shape.velocity > 0 && shape.acceleration > 0 && shape.jerk > 0
             ? ""
             : "velocity, acceleration and jerk must be above 0";
}

}  // namespace

std::string validation_error(const ArmSpec& shape) {
  if (shape.joints < 6 || shape.joints > 60) return "joints must be 6 … 60";
  if (!(shape.length > 0)) return "length must be above 0";
  if (!(shape.limit > 0)) return "limit must be above 0";
  return common_error(shape);
}

std::string validation_error(const HandSpec& shape) {
  if (shape.fingers < 3 || shape.fingers > 12) return "fingers must be 3 … 12";
  if (!(shape.length > 0) || !(shape.breadth > 0)) return "length and breadth must be above 0";
  return common_error(shape);
}

}  // namespace morphe::robot
