#include "core/motion/scene.hpp"

#include <algorithm>

namespace morphe {

const SceneObject* find_object(const std::vector<SceneObject>& objects, const std::string& name) {
  const auto found = std::ranges::find(objects, name, &SceneObject::name);
  return found == objects.end() ? nullptr : &*found;
}

SceneObject* find_object(std::vector<SceneObject>& objects, const std::string& name) {
  const auto found = std::ranges::find(objects, name, &SceneObject::name);
  return found == objects.end() ? nullptr : &*found;
}

Pose recorded_pose(const SceneObject& object, double time_s) {
  const auto upper = std::upper_bound(object.time.begin(), object.time.end(), time_s);
  const auto after = static_cast<std::size_t>(upper - object.time.begin());
  if (after == 0 || object.time.size() == 1) {
    return make_pose(object.position.front(), object.orientation.front());
  }
  if (after == object.time.size())
    return make_pose(object.position.back(), object.orientation.back());
  const std::size_t before = after - 1;
  const double span_s = object.time[after] - object.time[before];
  const double share = (time_s - object.time[before]) / span_s;
  return make_pose((1 - share) * object.position[before] + share * object.position[after],
                   object.orientation[before].slerp(share, object.orientation[after]));
}

}  // namespace morphe
