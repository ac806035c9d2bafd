#include <algorithm>
#include <cmath>

#include "core/collision/continuous_check.hpp"

namespace morphe::collision {

double object_travel(const Solid& solid, double begin_s, double middle_s, double end_s) {
  const double radius_m = bounding_radius(solid);
  const SceneObject& object = solid.object;
  const auto way = [&](double from_s, double to_s) {
    Pose last = recorded_pose(object, from_s);
    double length_m = 0;
    const auto go = [&](const Pose& next) {
      const double angle = Eigen::AngleAxisd(last.linear().transpose() * next.linear()).angle();
      length_m += (next.translation() - last.translation()).norm() + radius_m * std::abs(angle);
      last = next;
    };
    const auto first = std::upper_bound(object.time.begin(), object.time.end(), from_s);
    for (auto knot = first; knot != object.time.end() && *knot < to_s; ++knot) {
      go(recorded_pose(object, *knot));
    }
    go(recorded_pose(object, to_s));
    return length_m;
  };
  return std::max(way(begin_s, middle_s), way(middle_s, end_s));
}

JointMotion straight_motion(const JointVector& from, const JointVector& to, double from_s,
                            double to_s) {
  JointMotion motion;
  motion.position = [from, to](double s, JointVector& q) { q = from + s * (to - from); };
  motion.travel = [change = JointVector((to - from).cwiseAbs())](double s0, double s1,
                                                                 JointVector& travel) {
    travel = 0.5 * (s1 - s0) * change;
  };
  motion.demonstration_time = [from_s, to_s](double s) { return from_s + s * (to_s - from_s); };
  return motion;
}

}  // namespace morphe::collision
