#include "stages/segment/objects.hpp"

#include <algorithm>

#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

struct Track {
  std::vector<double> time;
  std::vector<Vec3> position;
};

Track seen_part(const SceneObject& object) {
  Track track;
  const auto samples = std::min(std::ssize(object.time), std::ssize(object.position));
  for (int i = 0; i < samples; ++i) {
    if (!is_known(object.position[i])) continue;
    track.time.push_back(object.time[i]);
    track.position.push_back(object.position[i]);
  }
  return track;
}

/// Returns the first index within kLookAhead_s after i at which the object is farther than
/// limit_m from its position at i, otherwise i.
int first_departure(const Track& track, int i, double limit_m) {
  const double until_s = track.time[i] + kLookAhead_s;
  for (int k = i + 1; k < std::ssize(track.time) && track.time[k] <= until_s; ++k) {
    if ((track.position[k] - track.position[i]).norm() > limit_m) return k;
  }
  return i;
}

}  // namespace

std::vector<ObjectMotion> object_motions(const std::vector<SceneObject>& objects, double limit_m) {
  std::vector<ObjectMotion> motions;
  for (const SceneObject& object : objects) {
    const Track track = seen_part(object);
    int end = 0;  // of the current motion
    bool moving = false;
    for (int i = 0; i < std::ssize(track.time); ++i) {
      const int departure = first_departure(track, i, limit_m);
      if (departure == i) {
        if (moving && i >= end) moving = false;
        continue;
      }
      if (!moving) {
        motions.push_back({object.name, track.time[departure], track.time[departure], 0});
        moving = true;
      }
      end = departure;
      motions.back().end_s = track.time[departure];
    }
  }
  for (ObjectMotion& motion : motions) {
    const SceneObject* object = find_object(objects, motion.object);
    motion.displacement_m = (recorded_pose(*object, motion.end_s).translation() -
                             recorded_pose(*object, motion.begin_s - kLookAhead_s).translation())
                                .norm();
  }
  std::erase_if(motions, [&](const ObjectMotion& motion) {
    return motion.displacement_m < limit_m && motion.end_s - motion.begin_s < kLookAhead_s;
  });
  std::ranges::sort(motions, {}, &ObjectMotion::begin_s);
  return motions;
}

}  // namespace morphe::segment
