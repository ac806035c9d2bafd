#include "pipeline/place/reachability_map.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/files/markup.hpp"
#include "core/math/seed.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/place/constants.hpp"
#include "pipeline/place/reachability_grid.hpp"
#include "pipeline/place/refine.hpp"
#include "pipeline/planning/place_movement.hpp"

namespace morphe::place {
namespace {

/// The dimensions of the drawing [m] and [pixels].
constexpr double kMapLeft_m = -1, kMapNear_m = -1.15, kMapSide_m = 2;
constexpr double kMapSide_px = 600, kMargin_px = 50, kTitleHeight_px = 60;

}  // namespace

ReachabilityMap reachability_map(const planning::PlanningInputs& planner,
                                 const std::vector<TrialMovement>& trials,
                                 const PlacementResult& placed, const PlaceOptions& options,
                                 const ProgressCallback& report) {
  std::vector<const TrialMovement*> few;
  for (const std::size_t k : planning::evenly_spaced_indices(trials.size(), kMapTrialCount))
    few.push_back(&trials[k]);
  ReachabilityMap map;
  map.pose = placed.base_placement;
  map.base = placed.base;
  for (int k = 0; k < kMapCellsPerSide; ++k) {
    map.right.push_back(kMinShoulderOffset_m.x() + kMapCellSize_m * k);
    map.forward.push_back(kMinShoulderOffset_m.y() + kMapCellSize_m * k);
  }
  constexpr int kSide = kMapCellsPerSide, kCells = kSide * kSide;
  map.reachable_share.assign(kSide, std::vector<double>(kSide, kUnknown));
  const Vec3 shoulder = map::robot_shoulder(planner.robot);
  int cells = 0;
  parallel::ordered_for_each<double>(
      kCells, options.jobs,
      [&](std::uint64_t cell) {
        BasePlacement pose = map.pose;
        pose.shoulder_offset.x() = map.right[cell % kSide];
        pose.shoulder_offset.y() = map.forward[cell / kSide];
        if (!is_base_allowed(trials, pose, shoulder, planner.robot.side, options)) return kUnknown;
        const Candidate evaluated = evaluate_placement(planner, pose, few, kMapEffort,
                                                       math::seed_from(options.seed, "map", cell));
        return 1 - evaluated.measures.out_of_reach;
      },
      [&](const double& share) {
        map.reachable_share[cells / kSide][cells % kSide] = share;
        report("map", ++cells, kCells);
      });
  for (const TrialMovement* trial : few)
    for (const Vec3& goal : trial->goals)
      if (is_known(goal)) map.goals.push_back(goal - trial->shoulder);
  return map;
}

std::string svg_of(const ReachabilityMap& map) {
  const double scale = kMapSide_px / kMapSide_m;
  const auto x = [&](double right) { return kMargin_px + scale * (right - kMapLeft_m); };
  const auto y = [&](double forward) {
    return kTitleHeight_px + kMapSide_px - scale * (forward - kMapNear_m);
  };
  std::string svg = files::svg_header(kMapSide_px + 2 * kMargin_px,
                                      kMapSide_px + kTitleHeight_px + kMargin_px, 12);
  svg += fmt::format(
      "<text x=\"{0:.0f}\" y=\"18\">Share of goals in reach by the position of the robot's "
      "shoulder relative to the human's (mm): red 0 %, green 100 %, white not allowed</text>\n"
      "<text x=\"{0:.0f}\" y=\"34\">Right: the person's right; up: forward; orientation as placed, "
      "{1:.0f} mm above the human's shoulder</text>\n"
      "<text x=\"{0:.0f}\" y=\"50\">Blue: the robot's shoulder; black ring: its base; blue ring: "
      "the human's shoulder; grey: fingertip goals</text>\n",
      kMargin_px, 1e3 * map.pose.shoulder_offset.z());
  for (int row = 0; row < std::ssize(map.forward); ++row) {
    for (int col = 0; col < std::ssize(map.right); ++col) {
      const double share = map.reachable_share[row][col];
      if (std::isnan(share)) continue;
      const double left = x(map.right[col] - kMapCellSize_m / 2),
                   top = y(map.forward[row] + kMapCellSize_m / 2);
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
          "fill=\"hsl({:.0f},60%,70%)\"><title>{:.0f} %</title></rect>\n",
          left, top, scale * kMapCellSize_m, scale * kMapCellSize_m, 120 * share * share,
          100 * share);
    }
  }
  for (int k = 0; k < std::ssize(map.right); k += 2) {
    svg += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{:.0f}</text>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{:.0f}</text>\n",
        x(map.right[k]), kTitleHeight_px + kMapSide_px + 18, 1e3 * map.right[k], kMargin_px - 6,
        y(map.forward[k]) + 4, 1e3 * map.forward[k]);
  }
  const auto mark = [&](const Vec3& point, double radius, const char* style, const char* name) {
    const double px = x(point.x()), py = y(point.y());
    if (px < kMargin_px || px > kMargin_px + kMapSide_px || py < kTitleHeight_px ||
        py > kTitleHeight_px + kMapSide_px)
      return;
    svg +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}><title>{}</title></circle>\n",
                    px, py, radius, style, name);
  };
  for (const Vec3& goal : map.goals) mark(goal, 2, "fill=\"#555\"", "goal");
  mark(Vec3::Zero(), 6, "fill=\"none\" stroke=\"#06c\" stroke-width=\"2\"", "human shoulder");
  mark(map.pose.shoulder_offset, 6, "fill=\"#06c\"", "robot shoulder");
  mark(map.base, 6, "fill=\"none\" stroke=\"#222\" stroke-width=\"2\"", "base");
  return svg + "</svg>\n";
}

}  // namespace morphe::place
