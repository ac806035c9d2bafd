#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "stages/import/body_guess.hpp"
#include "stages/import/conventions.hpp"

namespace morphe::imports {
namespace {

/// A recorded direction that should point along one of the world's axes.
struct Cue {
  Vec3 recorded, world;
  double weight;
  const char* what;
  bool signless = false;  ///< a line, not an arrow
};

struct Cues {
  std::vector<Cue> all;

  void add(const Vec3& recorded, const Vec3& world, double weight, const char* what,
           bool signless = false) {
    if (seen(recorded) && recorded.norm() > 0) {
      all.push_back({recorded.normalized(), world, weight, what, signless});
    }
  }
  double agreement(const Eigen::Matrix3d& world_from_recorded) const {
    double sum = 0;
    for (const Cue& cue : all) {
      const double cosine = cue.world.dot(world_from_recorded * cue.recorded);
      sum += cue.weight * (cue.signless ? std::abs(cosine) : cosine);
    }
    return sum;
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

std::vector<Vec3> halfway(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> track;
  for (std::size_t i = 0; i < a.size(); ++i) track.push_back(mean_of({a[i], b[i]}));
  return track;
}

void add_body(const RecordedPoints& points, Cues& cues) {
  const auto track = [&](const char* part) { return mean_track(points, part); };
  const auto left = track("left shoulder"), right = track("right shoulder");
  const auto left_hip = track("left hip"), right_hip = track("right hip");
  const auto shoulders = halfway(left, right);
  const auto hips = halfway(halfway(left_hip, right_hip), track("pelvis"));
  const Vec3 X = Vec3::UnitX(), Y = Vec3::UnitY(), Z = Vec3::UnitZ();
  cues.add(mean_from_to(left, right), X, 3, "from the left shoulder to the right");
  cues.add(mean_from_to(left_hip, right_hip), X, 3, "from the left hip to the right");
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
  cues.add(up, Vec3::UnitZ(), 1, "the elbow below the shoulder");
  Vec3 reach = mean_from_to(shoulder, wrist);
  if (seen(up) && up.norm() > 0) reach -= up.normalized() * up.normalized().dot(reach);
  cues.add(reach, Vec3::UnitY(), 1, "the hand in front of the shoulder");
  cues.add(mean_from_to(halfway(shoulder, wrist), elbow), (out - Vec3::UnitZ()).normalized(), 0.5,
           "the elbow outside of the line from shoulder to hand");
  cues.add(least_travel(wrist), Vec3::UnitZ(), 0.7, "the hand travels along a table", true);
}

constexpr const char* kAxisWords[] = {"x", "y", "z", "-x", "-y", "-z"};

}  // namespace

Guess guess_axes(const RecordedPoints& points) {
  Cues cues;
  add_body(points, cues);
  for (const Side side : {Side::right, Side::left}) add_arm(points, side, cues);
  if (cues.all.empty()) return {};
  struct Choice {
    std::string axes;
    double agreement;
  };
  std::vector<Choice> choices;
  double weights = 0;
  for (const Cue& cue : cues.all) weights += cue.weight;
  for (int right = 0; right < 6; ++right) {
    for (int forward = 0; forward < 6; ++forward) {
      for (int up = 0; up < 6; ++up) {
        if (right % 3 == forward % 3 || right % 3 == up % 3 || forward % 3 == up % 3) continue;
        const std::string axes =
            fmt::format("{} {} {}", kAxisWords[right], kAxisWords[forward], kAxisWords[up]);
        Eigen::Matrix3d world = Eigen::Matrix3d::Zero();
        for (const auto& [row, axis] : {std::pair(0, right), {1, forward}, {2, up}}) {
          world(row, axis % 3) = axis < 3 ? 1 : -1;
        }
        if (world.determinant() > 0) choices.push_back({axes, cues.agreement(world) / weights});
      }
    }
  }
  std::ranges::stable_sort(choices, std::ranges::greater{}, &Choice::agreement);
  const Eigen::Matrix3d world = world_from_recorded(choices[0].axes, "");
  std::vector<std::string> because;
  for (const Cue& cue : cues.all) {
    const double cosine = cue.world.dot(world * cue.recorded);
    constexpr double kAgrees = 0.7;
    const bool agrees = (cue.signless ? std::abs(cosine) : cosine) > kAgrees;
    if (agrees && std::ranges::find(because, cue.what) == because.end()) {
      because.emplace_back(cue.what);
    }
  }
  constexpr double kSure = 0.2, kLikely = 0.08, kAgreement = 0.6;
  const double ahead = choices[0].agreement - choices[1].agreement;
  const bool sure = ahead > kSure && choices[0].agreement > kAgreement;
  return {choices[0].axes,
          sure              ? Sureness::sure
          : ahead > kLikely ? Sureness::likely
                            : Sureness::guessed,
          fmt::format("{}", fmt::join(because, "; "))};
}

}  // namespace morphe::imports
