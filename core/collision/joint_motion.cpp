#include "core/collision/joint_motion.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::collision {

double object_travel(const Solid& solid, double begin_s, double middle_s, double end_s) {
  const double radius_m = bounding_radius(solid);
  const SceneObject& object = solid.object;
  const auto path_length = [&](double from_s, double to_s) {
    Pose previous = recorded_pose(object, from_s);
    double length_m = 0;
    const auto advance = [&](const Pose& next) {
      const double angle = Eigen::AngleAxisd(previous.linear().transpose() * next.linear()).angle();
      length_m += (next.translation() - previous.translation()).norm() + radius_m * std::abs(angle);
      previous = next;
    };
    const auto first = std::ranges::upper_bound(object.time, from_s);
    for (auto time = first; time != object.time.end() && *time < to_s; ++time)
      advance(recorded_pose(object, *time));
    advance(recorded_pose(object, to_s));
    return length_m;
  };
  return std::max(path_length(begin_s, middle_s), path_length(middle_s, end_s));
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
