#include "pipeline/setup/clear_covers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "core/collision/distance.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/robot/forward_kinematics.hpp"

namespace morphe::setup {
namespace {

/// Distance of capsules that is sought at rest: the margin of 1 mm and half as much again; of
/// shapes that are nearer to each other than three times as much, a third of their distance.
constexpr double kSoughtClearance_m = 0.0015;
/// Standoff within which a link is fitted again: as in the first fit, but no more than this, so
/// that it is a question of few voxels which of two links a place is nearer to.
constexpr double kMaxStandoff_m = 0.008;

double sought_clearance_m(const LinkPair& pair) {
  return std::min(kSoughtClearance_m, pair.rest_gap_m / 3);
}

Pose pose_of(const std::vector<Pose>& poses, int frame) {
  return frame < 0 ? Pose::Identity() : poses[frame];
}

/// Returns the distance of the capsules of two frames [m], infinity if one has none.
double capsule_distance(const std::vector<RobotModel::Capsule>& one, const Pose& base_from_one,
                        const std::vector<RobotModel::Capsule>& other,
                        const Pose& base_from_other) {
  double least = kInfinity;
  for (const RobotModel::Capsule& a : one) {
    const collision::CapsuleBody first{base_from_one * a.from, base_from_one * a.to, a.radius};
    for (const RobotModel::Capsule& b : other) {
      const collision::CapsuleBody second{base_from_other * b.from, base_from_other * b.to,
                                          b.radius};
      least = std::min(least, collision::capsule_capsule(first, second).distance);
    }
  }
  return least;
}

LinkCapsules* link_at(std::vector<LinkCapsules>& links, int frame) {
  const auto found = std::ranges::find(links, frame, &LinkCapsules::frame);
  return found == links.end() ? nullptr : &*found;
}

/// Fits a link again beside its neighbours.
void refit(const Kinematics& robot, const std::vector<SceneObject>& shapes,
           cover::FitOptions options, LinkCapsules& link) {
  options.aim_m = link.aim_m > 0
                      ? link.aim_m
                      : std::clamp(link.figures.standoff_95_m, kPalmStandoff_m, kMaxStandoff_m);
  options.budget = std::max<int>(options.budget, static_cast<int>(link.capsules.size()));
  const cover::CapsuleFit fit = cover::fit_capsules(shapes, options, robot.link[link.frame]);
  std::vector<RobotModel::Capsule> capsules = capsules_of(fit);
  // A capsule to the tip of a finger is not one of the fit.
  capsules.insert(capsules.end(), link.capsules.end() - link.tip_capsules, link.capsules.end());
  link.capsules = std::move(capsules);
  link.figures = fit.quality;
}

}  // namespace

void clear_covers(const Kinematics& robot, const LinkShapes& shapes, const LinkBodies& bodies,
                  const std::vector<LinkPair>& pairs, int budget,
                  std::vector<LinkCapsules>& links) {
  std::map<int, cover::FitOptions> again;
  const auto keep_clear = [&](int frame, int other, const LinkPair& pair) {
    const Pose frame_from_other = robot.pose(frame).inverse() * robot.pose(other);
    cover::FitOptions& options = again[frame];
    options.budget = budget;
    options.clearance_m = std::max(options.clearance_m, sought_clearance_m(pair));
    options.gap_m =
        options.nearby.empty() ? pair.rest_gap_m : std::min(options.gap_m, pair.rest_gap_m);
    for (const cover::Triangle& t : bodies.at(other).triangles)
      options.nearby.push_back(
          {frame_from_other * t.a, frame_from_other * t.b, frame_from_other * t.c});
  };
  for (const LinkPair& pair : pairs) {
    if (pair.rest_gap_m <= 0 || pair.first < 0 || pair.excused) continue;
    const LinkCapsules &one = *link_at(links, pair.first), &other = *link_at(links, pair.second);
    if (capsule_distance(one.capsules, robot.pose(pair.first), other.capsules,
                         robot.pose(pair.second)) >= sought_clearance_m(pair))
      continue;
    keep_clear(pair.first, pair.second, pair);
    keep_clear(pair.second, pair.first, pair);
  }
  for (const auto& [frame, options] : again)
    if (!bodies.at(frame).assumed)
      refit(robot, shapes.shapes_by_frame.at(frame), options, *link_at(links, frame));
}

std::vector<std::string> pairs_to_check(const RobotModel& robot, const std::vector<LinkPair>& pairs,
                                        const std::function<std::string(int)>& name_of_frame) {
  std::map<int, std::vector<RobotModel::Capsule>> capsules;
  for (const RobotModel::Capsule& capsule : robot.capsules)
    capsules[capsule.frame].push_back(capsule);
  std::vector<Pose> poses;
  robot::forward_kinematics(robot, rest_position(robot), poses);
  std::vector<std::string> check, excused, assumed;
  std::vector<LinkPair> never_touch;
  for (const LinkPair& pair : pairs) {
    const std::string names =
        fmt::format("[{}, {}]", name_of_frame(pair.first), name_of_frame(pair.second));
    if (pair.least_gap_m > 0) {
      never_touch.push_back(pair);
    } else if (pair.excused) {
      (pair.assumed ? assumed : excused).push_back(names);
    }
    if (pair.excused) continue;
    const double distance_m = capsule_distance(capsules[pair.first], pose_of(poses, pair.first),
                                               capsules[pair.second], pose_of(poses, pair.second));
    if (distance_m > 0) continue;
    check.push_back(fmt::format(
        "{}: {} at rest, and {} capsules against {} overlap by {:.1f} mm: the pair stays checked, "
        "so that no plan passes through postures as near as at rest",
        names,
        pair.rest_gap_m > 0
            ? fmt::format("{:.1f} mm apart", 1e3 * pair.rest_gap_m)
            : fmt::format("the {} overlap by {:.1f} mm", pair.assumed ? "capsules" : "shapes",
                          1e3 * pair.rest_depth_m),
        capsules[pair.first].size(), capsules[pair.second].size(), -1e3 * distance_m));
  }
  if (!excused.empty())
    check.push_back(fmt::format("not checked, because their shapes overlap as made: {}",
                                fmt::join(excused, ", ")));
  if (!never_touch.empty()) {
    const LinkPair& nearest = *std::ranges::min_element(never_touch, {}, &LinkPair::least_gap_m);
    check.push_back(fmt::format(
        "not checked, because one joint moves the two and their shapes are proved never to touch "
        "within its limits: {}, the nearest at least {} mm apart: [{}, {}]",
        count_with_noun(never_touch.size(), "pair"), least_distance_text(nearest),
        name_of_frame(nearest.first), name_of_frame(nearest.second)));
  }
  if (!assumed.empty())
    check.push_back(
        fmt::format("not checked, because assumed capsules overlap in all postures, and the shapes "
                    "are unknown: {}",
                    fmt::join(assumed, ", ")));
  return check;
}

}  // namespace morphe::setup
