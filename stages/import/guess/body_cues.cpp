#include "stages/import/guess/body_cues.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/rotation.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {
namespace {

/// In nine trials of five people at a table, a resting hand is 8 to 26 degrees outside of straight
/// ahead of its shoulder and points inwards: forearms by 4 to 17 degrees, fingers by 7 to 28.
constexpr double kRestHandAzimuth_rad = 15 * kRadPerDegree, kFingersInward_rad = 12 * kRadPerDegree;
/// Angle of a shoulder behind the breastbone's side: 20 to 32 degrees in the same trials.
constexpr double kShoulderBehind_rad = 25 * kRadPerDegree;

struct CueCollector {
  CueSource source = CueSource::trunk;
  std::vector<BodyCue> all;

  void add(const Vec3& recorded, const Vec3& world, double weight, const char* what,
           bool signless = false, CuePurpose use = CuePurpose::both) {
    if (is_known(recorded) && recorded.norm() > 0) {
      all.push_back(
          {recorded.normalized(), world.normalized(), weight, source, what, signless, use});
    }
  }
};

Vec3 mean_from_to(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  std::vector<Vec3> lines;
  for (std::size_t i = 0; i < from.size(); ++i) lines.push_back(to[i] - from[i]);
  return mean_of(lines);
}

/// Returns the direction along which a track moves least.
Vec3 least_travel(const std::vector<Vec3>& track) {
  const Vec3 mean = mean_of(track);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : track) {
    if (is_known(point)) spread += (point - mean) * (point - mean).transpose();
  }
  if (!spread.allFinite() || spread.trace() <= 0) return unknown_point();
  return math::principal_axes(spread).axes.col(0);
}

/// The region around the first seen point of a track, with a quarter of its largest distance as
/// radius.
struct RestRegion {
  Vec3 first = unknown_point();
  double radius = 0;

  explicit RestRegion(const std::vector<Vec3>& track) {
    constexpr double kRestRadiusRatio = 0.25;
    for (const Vec3& point : track) {
      if (!is_known(point)) continue;
      if (!is_known(first)) first = point;
      radius = std::max(radius, kRestRadiusRatio * (point - first).norm());
    }
  }
  bool contains(const Vec3& point) const { return (point - first).norm() <= radius; }
};

/// Returns the vector from the start of a track to the point at which it leaves that region.
Vec3 departure_direction(const std::vector<Vec3>& track) {
  const RestRegion rest(track);
  for (const Vec3& point : track) {
    if (is_known(point) && !rest.contains(point)) return point - rest.first;
  }
  return unknown_point();
}

std::vector<Vec3> midpoints(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> track;
  for (std::size_t i = 0; i < a.size(); ++i) track.push_back(mean_of({a[i], b[i]}));
  return track;
}

std::vector<Vec3> track_or_fallback(std::vector<Vec3> track, const std::vector<Vec3>& otherwise) {
  return is_known(mean_of(track)) ? track : otherwise;
}

/// Returns the track of the joint, or of the cluster on the hand.
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
  std::vector<Vec3> middle;  // both must be seen: a single one is beside the chest
  for (std::size_t i = 0; i < left.size(); ++i) middle.emplace_back((left[i] + right[i]) / 2);
  cues.add(mean_from_to(middle, chest), 2 * Y - Z, 1, "the chest is in front of the shoulders");
  if (!is_known(mean_of(middle))) {
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

/// Adds the cues of an arm, for recordings without the body.
void add_arm(const RecordedPoints& points, Side side, CueCollector& cues) {
  const auto track = [&](const char* part) {
    return mean_track(points, fmt::format("{} {}", name_of(side), part));
  };
  const auto shoulder = track("shoulder");
  // Clusters replace joints that were not recorded: the elbow is between two of them.
  const auto elbow =
      track_or_fallback(track("elbow"), midpoints(track("upper arm"), track("forearm")));
  const auto wrist = wrist_track(points, side);
  const Vec3 out = side == Side::right ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX());
  const Vec3 up = mean_from_to(elbow, shoulder);
  cues.source = CueSource::arm;
  cues.add(up, Vec3::UnitZ(), 1, "the elbow is below the shoulder");
  Vec3 reach = mean_from_to(shoulder, wrist);
  cues.add(reach, Vec3::UnitY() + std::tan(kRestHandAzimuth_rad) * out, 1,
           "the hand is in front of the shoulder", false, CuePurpose::heading);
  if (is_known(up) && up.norm() > 0) reach -= up.normalized() * up.normalized().dot(reach);
  cues.add(reach, Vec3::UnitY(), 1, "the hand is in front of the shoulder", false,
           CuePurpose::axes);
  cues.add(mean_from_to(midpoints(shoulder, wrist), elbow), out - Vec3::UnitZ(), 0.5,
           "the elbow is outside of the line from shoulder to hand", false, CuePurpose::axes);
  cues.add(least_travel(wrist), Vec3::UnitZ(), 0.7, "the hand travels along a table", true);
}

/// Adds the cues of a hand, for recordings without an arm.
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
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < wrist.size(); ++i) {
    if (rest.contains(wrist[i])) rows.push_back(i);
  }
  RecordedPoints there{points.names, points.parts, points.parents, {}, {}};
  const std::size_t columns = points.position.cols;
  there.position = Array2D<Vec3>(rows.size(), columns, unknown_point());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    there.time.push_back(points.time[rows[i]]);
    for (std::size_t k = 0; k < columns; ++k) there.position(i, k) = points.position(rows[i], k);
  }
  return there;
}

}  // namespace morphe::imports
