#include "pipeline/place/reach_map.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/files/markup.hpp"
#include "core/math/seed.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/reach.hpp"
#include "pipeline/place/refine.hpp"
#include "pipeline/planning/place_movement.hpp"

namespace morphe::place {
namespace {

constexpr int kCells = 13;
constexpr double kStep_m = 0.1;
/// Of the drawing [m] and [pixels].
constexpr double kLeft_m = -1, kNear_m = -1.15, kSide_m = 2;
constexpr double kSide = 600, kRoom = 50, kTitle = 60;

}  // namespace

ReachMap reach_map(const planning::Planner& planner, const std::vector<Trial>& trials,
                   const Found& found, const PlaceOptions& options, const Report& report) {
  constexpr std::size_t kTrials = 3;
  std::vector<const Trial*> few;
  for (const std::size_t k : planning::few_frames(trials.size(), kTrials))
    few.push_back(&trials[k]);
  ReachMap map;
  map.stand = found.stand;
  map.base = found.base;
  for (int k = 0; k < kCells; ++k) {
    map.right.push_back(kLeastOffset.x() + kStep_m * k);
    map.forward.push_back(kLeastOffset.y() + kStep_m * k);
  }
  const std::size_t side = map.right.size();
  map.met.assign(side, std::vector<double>(side, kNotSeen));
  const Vec3 shoulder = map::robot_shoulder(planner.robot);
  int done = 0;
  parallel::for_each<double>(
      static_cast<int>(side * side), options.jobs,
      [&](std::uint64_t cell) {
        Stand stand = map.stand;
        stand.shoulder_offset.x() = map.right[cell % side];
        stand.shoulder_offset.y() = map.forward[cell / side];
        if (!base_is_free(trials, stand, shoulder, planner.robot.side, options)) return kNotSeen;
        const Candidate tried =
            try_stand(planner, stand, few, {6, 2, 4}, math::seed_from(options.seed, "map", cell));
        return 1 - tried.measures.out_of_reach;
      },
      [&](const double& met) {
        const auto cell = static_cast<std::size_t>(done);
        map.met[cell / side][cell % side] = met;
        report("map", ++done, static_cast<int>(side * side));
      });
  for (const Trial* trial : few) {
    for (const Vec3& goal : trial->goals) {
      if (seen(goal)) map.goals.push_back(goal - trial->shoulder);
    }
  }
  return map;
}

std::string svg_of(const ReachMap& map) {
  const double scale = kSide / kSide_m;
  const auto x = [&](double right) { return kRoom + scale * (right - kLeft_m); };
  const auto y = [&](double forward) { return kTitle + kSide - scale * (forward - kNear_m); };
  std::string svg = files::svg_begin(kSide + 2 * kRoom, kSide + kTitle + kRoom, 12);
  svg += fmt::format(
      "<text x=\"{0:.0f}\" y=\"18\">Goals in reach, by where the robot's shoulder is from the "
      "human's (mm): red none, green all, white not allowed</text>\n"
      "<text x=\"{0:.0f}\" y=\"34\">Right: the person's right; up: forward; all turned as placed, "
      "{1:.0f} mm above the human's shoulder</text>\n"
      "<text x=\"{0:.0f}\" y=\"50\">Blue: the robot's shoulder; black ring: its base; blue ring: "
      "the "
      "human's shoulder; grey: fingertip goals</text>\n",
      kRoom, 1e3 * map.stand.shoulder_offset.z());
  for (std::size_t row = 0; row < map.forward.size(); ++row) {
    for (std::size_t col = 0; col < map.right.size(); ++col) {
      const double met = map.met[row][col];
      if (std::isnan(met)) continue;
      const double left = x(map.right[col] - kStep_m / 2), top = y(map.forward[row] + kStep_m / 2);
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
          "fill=\"hsl({:.0f},60%,70%)\"><title>{:.0f} %</title></rect>\n",
          left, top, scale * kStep_m, scale * kStep_m, 120 * met * met, 100 * met);
    }
  }
  for (std::size_t k = 0; k < map.right.size(); k += 2) {
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.0f}</text>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.0f}</text>\n",
        x(map.right[k]), kTitle + kSide + 18, 1e3 * map.right[k], kRoom - 6, y(map.forward[k]) + 4,
        1e3 * map.forward[k]);
  }
  const auto mark = [&](const Vec3& at, double radius, const char* style, const char* name) {
    const double px = x(at.x()), py = y(at.y());
    if (px < kRoom || px > kRoom + kSide || py < kTitle || py > kTitle + kSide) return;
    svg +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}><title>{}</title></circle>\n",
                    px, py, radius, style, name);
  };
  for (const Vec3& goal : map.goals) mark(goal, 2, "fill=\"#555\"", "goal");
  mark(Vec3::Zero(), 6, "fill=\"none\" stroke=\"#06c\" stroke-width=\"2\"", "human shoulder");
  mark(map.stand.shoulder_offset, 6, "fill=\"#06c\"", "robot shoulder");
  mark(map.base, 6, "fill=\"none\" stroke=\"#222\" stroke-width=\"2\"", "base");
  return svg + "</svg>\n";
}

}  // namespace morphe::place
