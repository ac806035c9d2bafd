#include "stages/import/guess/body_cues.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/math/rotation.hpp"
#include "core/motion/side.hpp"

namespace morphe::imports {
namespace {

/// In nine trials of five people at a table a resting hand lies 8 to 26 degrees outside of straight
/// ahead of its shoulder and points inwards: forearms by 4 to 17 degrees, fingers by 7 to 28.
constexpr double kOutside = 15 * kDegree, kInwards = 12 * kDegree;
/// How far behind the breastbone's side a shoulder lies: 20 to 32 degrees in the same trials.
constexpr double kBehind = 25 * kDegree;

struct Cues {
  CueOf of = CueOf::trunk;
  std::vector<BodyCue> all;

  void add(const Vec3& recorded, const Vec3& world, double weight, const char* what,
           bool signless = false, CueFor use = CueFor::both) {
    if (seen(recorded) && recorded.norm() > 0) {
      all.push_back({recorded.normalized(), world.normalized(), weight, of, what, signless, use});
    }
  }
};

Vec3 mean_from_to(const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
  std::vector<Vec3> lines;
  for (std::size_t i = 0; i < from.size(); ++i) lines.push_back(to[i] - from[i]);
  return mean_of(lines);
}

/// The direction along which a track moves least.
Vec3 least_travel(const std::vector<Vec3>& track) {
  const Vec3 mean = mean_of(track);
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : track) {
    if (seen(point)) spread += (point - mean) * (point - mean).transpose();
  }
  if (!spread.allFinite() || spread.trace() <= 0) return unseen_point();
  return math::principal_axes(spread).axes.col(0);
}

/// How far from where it was first seen a track goes, and whether it is still there.
struct Rest {
  Vec3 first = unseen_point();
  double room = 0;

  explicit Rest(const std::vector<Vec3>& track) {
    constexpr double kRoom = 0.25;
    for (const Vec3& point : track) {
      if (!seen(point)) continue;
      if (!seen(first)) first = point;
      room = std::max(room, kRoom * (point - first).norm());
    }
  }
  bool holds(const Vec3& point) const { return (point - first).norm() <= room; }
};

/// From where a track begins to where it has left from there.
Vec3 way_out(const std::vector<Vec3>& track) {
  const Rest rest(track);
  for (const Vec3& point : track) {
    if (seen(point) && !rest.holds(point)) return point - rest.first;
  }
  return unseen_point();
}

std::vector<Vec3> halfway(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> track;
  for (std::size_t i = 0; i < a.size(); ++i) track.push_back(mean_of({a[i], b[i]}));
  return track;
}

std::vector<Vec3> seen_or(std::vector<Vec3> track, const std::vector<Vec3>& otherwise) {
  return seen(mean_of(track)) ? track : otherwise;
}

/// The joint, or the cluster on the hand.
std::vector<Vec3> wrist_track(const RecordedPoints& points, Side side) {
  const std::string name(name_of(side));
  return seen_or(mean_track(points, name + " wrist"), mean_track(points, name + " hand"));
}

void add_trunk(const RecordedPoints& points, Cues& cues) {
  const auto track = [&](const char* part) { return mean_track(points, part); };
  const auto left = track("left shoulder"), right = track("right shoulder");
  const auto left_hip = track("left hip"), right_hip = track("right hip");
  const auto shoulders = halfway(left, right);
  const auto hips = halfway(halfway(left_hip, right_hip), track("pelvis"));
  const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ();
  cues.of = CueOf::trunk;
  cues.add(mean_from_to(left, right), X, 3, "from the left shoulder to the right");
  cues.add(mean_from_to(left_hip, right_hip), X, 3, "from the left hip to the right");
  cues.add(mean_from_to(track("back"), track("chest")), Y, 2, "from the back to the chest");
  const auto chest = track("chest");
  std::vector<Vec3> middle;  // where both are seen: one alone lies beside the chest
  for (std::size_t i = 0; i < left.size(); ++i) middle.emplace_back((left[i] + right[i]) / 2);
  cues.add(mean_from_to(middle, chest), 2 * Y - Z, 1, "the chest before the shoulders");
  if (!seen(mean_of(middle))) {
    const Vec3 aside = std::cos(kBehind) * X, behind = -std::sin(kBehind) * Y;
    cues.add(mean_from_to(chest, right), behind + aside, 1, "the shoulder beside the chest");
    cues.add(mean_from_to(chest, left), behind - aside, 1, "the shoulder beside the chest");
  }
  cues.add(mean_from_to(hips, shoulders), Z, 3, "from the hips to the shoulders");
  cues.add(mean_from_to(shoulders, track("head")), Z, 2, "the head above the shoulders");
  for (const char* side : {"left", "right"}) {
    const auto ankle = track(fmt::format("{} ankle", side).c_str());
    cues.add(mean_from_to(ankle, track(fmt::format("{} toe", side).c_str())), Y, 1,
             "from ankle to toe");
    cues.add(mean_from_to(ankle, hips), Z, 1, "the hips above the feet");
  }
}

/// An arm of which the body was not recorded.
void add_arm(const RecordedPoints& points, Side side, Cues& cues) {
  const auto track = [&](const char* part) {
    return mean_track(points, fmt::format("{} {}", name_of(side), part));
  };
  const auto shoulder = track("shoulder");
  // Clusters stand for joints that were not recorded: the elbow lies between two of them.
  const auto elbow = seen_or(track("elbow"), halfway(track("upper arm"), track("forearm")));
  const auto wrist = wrist_track(points, side);
  const Vec3 out = side == Side::right ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX());
  const Vec3 up = mean_from_to(elbow, shoulder);
  cues.of = CueOf::arm;
  cues.add(up, Vec3::UnitZ(), 1, "the elbow below the shoulder");
  Vec3 reach = mean_from_to(shoulder, wrist);
  cues.add(reach, Vec3::UnitY() + std::tan(kOutside) * out, 1, "the hand in front of the shoulder",
           false, CueFor::heading);
  if (seen(up) && up.norm() > 0) reach -= up.normalized() * up.normalized().dot(reach);
  cues.add(reach, Vec3::UnitY(), 1, "the hand in front of the shoulder", false, CueFor::axes);
  cues.add(mean_from_to(halfway(shoulder, wrist), elbow), out - Vec3::UnitZ(), 0.5,
           "the elbow outside of the line from shoulder to hand", false, CueFor::axes);
  cues.add(least_travel(wrist), Vec3::UnitZ(), 0.7, "the hand travels along a table", true);
}

/// A hand of which not even the arm was recorded.
void add_hand(const RecordedPoints& points, Side side, Cues& cues) {
  const auto wrist = wrist_track(points, side);
  const double out = side == Side::right ? 1 : -1;
  cues.of = CueOf::hand;
  cues.add(mean_from_to(wrist, mean_track(points, fmt::format("{} middle", name_of(side)))),
           Vec3(-out * std::sin(kInwards), std::cos(kInwards), 0), 1,
           "the fingers point away from the person");
  cues.of = CueOf::way;
  cues.add(way_out(wrist), Vec3::UnitY(), 1, "the hand leaves for what is in front");
}

}  // namespace

std::vector<BodyCue> body_cues(const RecordedPoints& points) {
  Cues cues;
  add_trunk(points, cues);
  for (const Side side : {Side::right, Side::left}) {
    add_arm(points, side, cues);
    add_hand(points, side, cues);
  }
  cues.of = CueOf::hand;
  cues.add(mean_from_to(wrist_track(points, Side::left), wrist_track(points, Side::right)),
           Vec3::UnitX(), 2, "from the left hand to the right");
  return cues.all;
}

RecordedPoints points_at_rest(const RecordedPoints& points, Side hand) {
  const std::vector<Vec3> wrist = wrist_track(points, hand);
  const Rest rest(wrist);
  if (!seen(rest.first)) return points;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < wrist.size(); ++i) {
    if (rest.holds(wrist[i])) rows.push_back(i);
  }
  RecordedPoints there{points.names, points.parts, points.parents, {}, {}};
  const std::size_t columns = points.position.cols;
  there.position = Table<Vec3>(rows.size(), columns, unseen_point());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    there.time.push_back(points.time[rows[i]]);
    for (std::size_t k = 0; k < columns; ++k) there.position(i, k) = points.position(rows[i], k);
  }
  return there;
}

}  // namespace morphe::imports
