#include "stages/verify/object_travel.hpp"

#include <algorithm>

#include "stages/verify/separation.hpp"

namespace morphe::verify {

double ObjectTravel::until(double time_s) const {
  const std::vector<double>& time = object->time;
  const std::ptrdiff_t after = std::ranges::upper_bound(time, time_s) - time.begin();
  if (after == 0) return travelled.front();
  if (after == std::ssize(time)) return travelled.back();
  const double share = (time_s - time[after - 1]) / (time[after] - time[after - 1]);
  return travelled[after - 1] + share * (travelled[after] - travelled[after - 1]);
}

ObjectTravel object_travel(const SceneObject& object) {
  ObjectTravel travel{&object, {0.0}};
  if (!has_valid_shape(object)) return travel;
  const double radius = object.shape == Shape::sphere ? 0.0 : bounding_radius(object);
  for (int k = 1; k < std::ssize(object.time); ++k) {
    travel.travelled.push_back(
        travel.travelled.back() + (object.position[k] - object.position[k - 1]).norm() +
        radius * angle_between(object.orientation[k - 1], object.orientation[k]));
  }
  return travel;
}

}  // namespace morphe::verify
