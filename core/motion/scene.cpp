#include "core/motion/scene.hpp"

#include <algorithm>
#include <utility>

namespace morphe {

const SceneObject* find_object(const std::vector<SceneObject>& objects, const std::string& name) {
  const auto found = std::ranges::find(objects, name, &SceneObject::name);
  return found == objects.end() ? nullptr : &*found;
}

SceneObject* find_object(std::vector<SceneObject>& objects, const std::string& name) {
  return const_cast<SceneObject*>(find_object(std::as_const(objects), name));
}

Pose recorded_pose(const SceneObject& object, double time_s) {
  const auto after = std::ranges::upper_bound(object.time, time_s) - object.time.begin();
  const auto pose = [&](auto k) { return make_pose(object.position[k], object.orientation[k]); };
  if (after == 0 || object.time.size() == 1) return pose(0);
  if (after == std::ssize(object.time)) return pose(after - 1);
  const auto before = after - 1;
  const double span_s = object.time[after] - object.time[before];
  const double share = (time_s - object.time[before]) / span_s;
  return make_pose((1 - share) * object.position[before] + share * object.position[after],
                   object.orientation[before].slerp(share, object.orientation[after]));
}

}  // namespace morphe
