#include "stages/segment/objects.hpp"

#include <algorithm>

namespace morphe::segment {
namespace {

constexpr double kLookAhead_s = 0.2;

struct Track {
  std::vector<double> time;
  std::vector<Vec3> position;
};

Track seen_part(const SceneObject& object) {
  Track track;
  for (std::size_t i = 0; i < std::min(object.time.size(), object.position.size()); ++i) {
    if (!is_known(object.position[i])) continue;
    track.time.push_back(object.time[i]);
    track.position.push_back(object.position[i]);
  }
  return track;
}

/// Returns the first sample after i that is far from sample i within kLookAhead_s; i if there is no
/// such sample.
std::size_t first_departure(const Track& track, std::size_t i, double least_m) {
  for (std::size_t k = i + 1;
       k < track.time.size() && track.time[k] <= track.time[i] + kLookAhead_s; ++k) {
    if ((track.position[k] - track.position[i]).norm() > least_m) return k;
  }
  return i;
}

}  // namespace

std::vector<ObjectMotion> object_motions(const std::vector<SceneObject>& objects, double least_m) {
  std::vector<ObjectMotion> motions;
  for (const SceneObject& object : objects) {
    const Track track = seen_part(object);
    std::size_t end = 0;  // end of the current motion
    bool moving = false;
    for (std::size_t i = 0; i < track.time.size(); ++i) {
      const std::size_t far = first_departure(track, i, least_m);
      if (far == i) {
        if (moving && i >= end) moving = false;
        continue;
      }
      if (!moving) {
        motions.push_back({object.name, track.time[far], track.time[far], 0});
        moving = true;
      }
      end = far;
      motions.back().end_s = track.time[far];
    }
  }
  for (ObjectMotion& motion : motions) {
    const SceneObject* object = find_object(objects, motion.object);
    motion.displacement_m = (recorded_pose(*object, motion.end_s).translation() -
                             recorded_pose(*object, motion.begin_s - kLookAhead_s).translation())
                                .norm();
  }
  std::erase_if(motions, [&](const ObjectMotion& motion) {
    return motion.displacement_m < least_m && motion.end_s - motion.begin_s < kLookAhead_s;
  });
  std::sort(motions.begin(), motions.end(),
            [](const ObjectMotion& a, const ObjectMotion& b) { return a.begin_s < b.begin_s; });
  return motions;
}

}  // namespace morphe::segment
