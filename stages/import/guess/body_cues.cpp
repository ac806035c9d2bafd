#include "stages/import/guess/body_cues.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/rotation.hpp"
#include "stages/import/guess/constants.hpp"

namespace morphe::imports {
namespace {

struct CueCollector {
  CueSource source = CueSource::trunk;
  std::vector<BodyCue> all;

  void add(const Vec3& recorded, const Vec3& world, double weight, const char* description,
           bool undirected = false, CuePurpose purpose = CuePurpose::both) {
    if (!is_known(recorded) || !(recorded.norm() > 0)) return;
    all.push_back({recorded.normalized(), world.normalized(), weight, source, description,
                   undirected, purpose});
  }
};

Vec3 mean_from_to(const std::vector<Vec3>& origin, const std::vector<Vec3>& target) {
  std::vector<Vec3> vectors;
  for (int i = 0; i < std::ssize(origin); ++i) vectors.push_back(target[i] - origin[i]);
  return mean_of(vectors);
}

Vec3 direction_of_least_travel(const std::vector<Vec3>& track) {
  const Eigen::Matrix3d scatter = scatter_of(track);
  if (!scatter.allFinite() || scatter.trace() <= 0) return unknown_point();
  return math::principal_axes(scatter).axes.col(0);
}

/// A ball around the first seen point of a track. While the track is inside, it counts as at rest.
struct RestRegion {
  Vec3 first = unknown_point();
  double radius = 0;

  explicit RestRegion(const std::vector<Vec3>& track) {
    for (const Vec3& point : track) {
      if (!is_known(point)) continue;
      if (!is_known(first)) first = point;
      radius = std::max(radius, kRestRadiusRatio * (point - first).norm());
    }
  }
  bool contains(const Vec3& point) const { return (point - first).norm() <= radius; }
};

/// Returns the vector from the start of a track to the point at which it leaves its rest region.
Vec3 departure_direction(const std::vector<Vec3>& track) {
  const RestRegion rest(track);
  for (const Vec3& point : track) {
    if (is_known(point) && !rest.contains(point)) return point - rest.first;
  }
  return unknown_point();
}

std::vector<Vec3> midpoints(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> track;
  for (int i = 0; i < std::ssize(a); ++i) track.push_back(mean_of({a[i], b[i]}));
  return track;
}

std::vector<Vec3> track_or_fallback(std::vector<Vec3> track, const std::vector<Vec3>& fallback) {
  return is_known(mean_of(track)) ? track : fallback;
}

/// Returns the track of the wrist or, if it was never seen, of the cluster on the hand.
std::vector<Vec3> wrist_track(const RecordedPoints& points, Side side) {
  const std::string name(name_of(side));
  return track_or_fallback(mean_track(points, name + " wrist"), mean_track(points, name + " hand"));
}

void add_trunk(const RecordedPoints& points, CueCollector& cues) {
  const auto track = [&](const char* part) { return mean_track(points, part); };
  const auto left = track("left shoulder"), right = track("right shoulder");
  const auto left_hip = track("left hip"), right_hip = track("right hip");
  const auto shoulders = midpoints(left, right);
  const auto hips = midpoints(midpoints(left_hip, right_hip), track("pelvis"));
  const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ();
  cues.source = CueSource::trunk;
  cues.add(mean_from_to(left, right), X, 3, "from the left shoulder to the right");
  cues.add(mean_from_to(left_hip, right_hip), X, 3, "from the left hip to the right");
  cues.add(mean_from_to(track("back"), track("chest")), Y, 2, "from the back to the chest");
  const auto chest = track("chest");
  std::vector<Vec3> midway;  // known only if both shoulders are: a single one is beside the chest
  for (int i = 0; i < std::ssize(left); ++i) midway.emplace_back((left[i] + right[i]) / 2);
  cues.add(mean_from_to(midway, chest), 2 * Y - Z, 1, "the chest is in front of the shoulders");
  if (!is_known(mean_of(midway))) {
    const Vec3 aside = std::cos(kShoulderBehind_rad) * X,
               behind = -std::sin(kShoulderBehind_rad) * Y;
    cues.add(mean_from_to(chest, right), behind + aside, 1, "the shoulder is beside the chest");
    cues.add(mean_from_to(chest, left), behind - aside, 1, "the shoulder is beside the chest");
  }
  cues.add(mean_from_to(hips, shoulders), Z, 3, "from the hips to the shoulders");
  cues.add(mean_from_to(shoulders, track("head")), Z, 2, "the head is above the shoulders");
  for (const char* side : {"left", "right"}) {
    const auto ankle = track(fmt::format("{} ankle", side).c_str());
    cues.add(mean_from_to(ankle, track(fmt::format("{} toe", side).c_str())), Y, 1,
             "from ankle to toe");
    cues.add(mean_from_to(ankle, hips), Z, 1, "the hips are above the feet");
  }
}

/// Adds the cues of an arm, which matter most if the trunk was not recorded.
void add_arm(const RecordedPoints& points, Side side, CueCollector& cues) {
  const auto track = [&](const char* part) {
    return mean_track(points, fmt::format("{} {}", name_of(side), part));
  };
  const auto shoulder = track("shoulder");
  // An elbow that was not recorded is between the clusters on upper arm and forearm.
  const auto elbow =
      track_or_fallback(track("elbow"), midpoints(track("upper arm"), track("forearm")));
  const auto wrist = wrist_track(points, side);
  const Vec3 out = side == Side::right ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX());
  const Vec3 up = mean_from_to(elbow, shoulder);
  cues.source = CueSource::arm;
  cues.add(up, Vec3::UnitZ(), 1, "the elbow is below the shoulder");
  Vec3 to_wrist = mean_from_to(shoulder, wrist);
  cues.add(to_wrist, Vec3::UnitY() + std::tan(kRestHandAzimuth_rad) * out, 1,
           "the hand is in front of the shoulder", false, CuePurpose::heading);
  if (is_known(up) && up.norm() > 0) to_wrist -= up.normalized() * up.normalized().dot(to_wrist);
  cues.add(to_wrist, Vec3::UnitY(), 1, "the hand is in front of the shoulder", false,
           CuePurpose::axes);
  cues.add(mean_from_to(midpoints(shoulder, wrist), elbow), out - Vec3::UnitZ(), 0.5,
           "the elbow is outside of the line from shoulder to hand", false, CuePurpose::axes);
  cues.add(direction_of_least_travel(wrist), Vec3::UnitZ(), 0.7, "the hand travels along a table",
           true);
}

/// Adds the cues of a hand, which matter most if its arm was not recorded.
void add_hand(const RecordedPoints& points, Side side, CueCollector& cues) {
  const auto wrist = wrist_track(points, side);
  const double out = side == Side::right ? 1 : -1;
  cues.source = CueSource::hand;
  cues.add(mean_from_to(wrist, mean_track(points, fmt::format("{} middle", name_of(side)))),
           Vec3(-out * std::sin(kFingersInward_rad), std::cos(kFingersInward_rad), 0), 1,
           "the fingers point away from the person");
  cues.source = CueSource::reach;
  cues.add(departure_direction(wrist), Vec3::UnitY(), 1, "the hand starts to move forward");
}

}  // namespace

std::vector<BodyCue> body_cues(const RecordedPoints& points) {
  CueCollector cues;
  add_trunk(points, cues);
  for (const Side side : {Side::right, Side::left}) {
    add_arm(points, side, cues);
    add_hand(points, side, cues);
  }
  cues.source = CueSource::hand;
  cues.add(mean_from_to(wrist_track(points, Side::left), wrist_track(points, Side::right)),
           Vec3::UnitX(), 2, "from the left hand to the right");
  return cues.all;
}

RecordedPoints frames_at_rest(const RecordedPoints& points, Side hand) {
  const std::vector<Vec3> wrist = wrist_track(points, hand);
  const RestRegion rest(wrist);
  if (!is_known(rest.first)) return points;
  RecordedPoints at_rest{points.names, points.parts, points.parents, {}, {}};
  at_rest.position.cols = points.position.cols;
  for (int i = 0; i < std::ssize(wrist); ++i) {
    if (!rest.contains(wrist[i])) continue;
    at_rest.time.push_back(points.time[i]);
    ++at_rest.position.rows;
    for (std::size_t k = 0; k < points.position.cols; ++k)
      at_rest.position.values.push_back(points.position(i, k));
  }
  return at_rest;
}

}  // namespace morphe::imports
