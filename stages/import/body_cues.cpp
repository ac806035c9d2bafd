#include "stages/import/body_cues.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <string>

#include "pipeline/motion/side.hpp"

namespace morphe::imports {
namespace {

struct Cues {
  CueOf of = CueOf::trunk;
  std::vector<BodyCue> all;

  void add(const Vec3& recorded, const Vec3& world, double weight, const char* what,
           bool signless = false) {
    if (seen(recorded) && recorded.norm() > 0) {
      all.push_back({recorded.normalized(), world, weight, of, what, signless});
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
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

/// From where a track begins to where it is farthest from there.
Vec3 farthest_way(const std::vector<Vec3>& track) {
  Vec3 first = unseen_point(), way = unseen_point();
  for (const Vec3& point : track) {
    if (!seen(point)) continue;
    if (!seen(first)) first = point;
    if (!seen(way) || (point - first).norm() > way.norm()) way = point - first;
  }
  return way;
}

std::vector<Vec3> halfway(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> track;
  for (std::size_t i = 0; i < a.size(); ++i) track.push_back(mean_of({a[i], b[i]}));
  return track;
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
  cues.add(mean_from_to(shoulders, track("chest")), (2 * Y - Z).normalized(), 1,
           "the chest before the shoulders");
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
  const auto seen_or = [](std::vector<Vec3> joint, const std::vector<Vec3>& otherwise) {
    return seen(mean_of(joint)) ? joint : otherwise;
  };
  const auto elbow = seen_or(track("elbow"), halfway(track("upper arm"), track("forearm")));
  const auto wrist = seen_or(track("wrist"), track("hand"));
  const Vec3 out = side == Side::right ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX());
  const Vec3 up = mean_from_to(elbow, shoulder);
  cues.of = CueOf::arm;
  cues.add(up, Vec3::UnitZ(), 1, "the elbow below the shoulder");
  Vec3 reach = mean_from_to(shoulder, wrist);
  if (seen(up) && up.norm() > 0) reach -= up.normalized() * up.normalized().dot(reach);
  cues.add(reach, Vec3::UnitY(), 1, "the hand in front of the shoulder");
  cues.add(mean_from_to(halfway(shoulder, wrist), elbow), (out - Vec3::UnitZ()).normalized(), 0.5,
           "the elbow outside of the line from shoulder to hand");
  cues.add(least_travel(wrist), Vec3::UnitZ(), 0.7, "the hand travels along a table", true);
}

/// A hand of which not even the arm was recorded.
void add_hand(const RecordedPoints& points, Side side, Cues& cues) {
  const std::string prefix = std::string(name_of(side)) + " ";
  const auto wrist = mean_track(points, prefix + "wrist");
  cues.of = CueOf::hand;
  cues.add(mean_from_to(wrist, mean_track(points, prefix + "middle")), Vec3::UnitY(), 1,
           "the fingers point away from the person");
  cues.add(farthest_way(wrist), Vec3::UnitY(), 1, "the hand reaches forward");
}

}  // namespace

std::vector<BodyCue> body_cues(const RecordedPoints& points) {
  Cues cues;
  add_trunk(points, cues);
  for (const Side side : {Side::right, Side::left}) {
    add_arm(points, side, cues);
    add_hand(points, side, cues);
  }
  return cues.all;
}

}  // namespace morphe::imports
