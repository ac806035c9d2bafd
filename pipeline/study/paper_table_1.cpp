#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "core/math/statistics.hpp"
#include "core/robot/files/generate.hpp"
#include "pipeline/study/paper_cases.hpp"

namespace morphe::study {
namespace {

constexpr double kMillimetre = 1e-3;

/// Table 1 of the paper: position [mm] and orientation [degrees].
struct Published {
  int joints;
  double scale, position_mm, orientation_deg;
};
constexpr std::array<Published, 20> kPublished{{
    {6, 0.90, 0.493, 15.5959},  {6, 1.00, 0.241, 10.9367}, {6, 1.15, 0.152, 5.2978},
    {6, 1.30, 0.007, 0.4466},   {7, 0.90, 0.178, 13.5371}, {7, 1.00, 0.103, 9.1192},
    {7, 1.15, 0.042, 4.1737},   {7, 1.30, 0.013, 0.2819},  {9, 0.90, 2.430, 13.2628},
    {9, 1.00, 0.021, 0.1684},   {9, 1.15, 0.011, 0.5697},  {9, 1.30, 0.025, 1.1485},
    {18, 0.90, 2.736, 10.6899}, {18, 1.00, 0.042, 0.1792}, {18, 1.15, 0.030, 0.2309},
    {18, 1.30, 0.022, 0.0536},  {27, 0.90, 2.842, 8.9306}, {27, 1.00, 0.082, 0.6010},
    {27, 1.15, 0.063, 0.2025},  {27, 1.30, 0.052, 0.1793},
}};

struct Pair {
  double position_m, orientation_rad;
};

/// Mean errors of solves without humanlikeness, from nearly all weight on the position to nearly
/// all on the orientation.
std::vector<Pair> front(const PaperContext& context, const robot::Robot& robot) {
  std::vector<Pair> pairs;
  for (double orientation = 1e-2; orientation < 2e3; orientation *= 10) {
    const MappedPoses plain =
        map_all(context, robot, context.arms, {context.weights.tip_position, orientation, 0});
    pairs.push_back({math::mean(plain.position_m), math::mean(plain.orientation_rad)});
  }
  return pairs;
}

/// The pair that comes nearest to a wanted one, as the larger of the two ratios to it. Above 1:
/// geometry forbids what is wanted on these motions.
double nearest(const std::vector<Pair>& front, const Pair& wanted) {
  double least = std::numeric_limits<double>::infinity();
  for (const Pair& pair : front) {
    least = std::min(least, std::max(pair.position_m / wanted.position_m,
                                     pair.orientation_rad / wanted.orientation_rad));
  }
  return least;
}

}  // namespace

void table_1(const PaperContext& context, StudyResult& result) {
  for (const Published& cell : kPublished) {
    const robot::Robot robot(
        robot::generate_arm({.joints = cell.joints, .length = cell.scale * context.arm_length()}));
    const MappedPoses ours = map_all(context, robot, context.arms, context.weights);
    StudyWeights plain = context.weights, exact = context.weights;
    plain.humanlike = 0;
    exact.tip_position *= 100;
    exact.tip_orientation *= 100;
    const std::vector<char> met = reachable(map_all(context, robot, context.arms, plain));
    const MappedPoses best = map_all(context, robot, context.arms, exact);
    const Case of = {{"table", "1"},
                     {"joints", std::to_string(cell.joints)},
                     {"length", fmt::format("{:.2f}", cell.scale)}};
    const std::size_t n = ours.q.size();
    const auto row = [&](const char* metric, const char* unit, double value) -> StudyRow& {
      result.rows.push_back(row_of(of, metric, unit, value, n));
      result.rows.back().reachable = share_of(met);
      return result.rows.back();
    };
    const double position = math::mean(ours.position_m), turn = math::mean(ours.orientation_rad);
    // The paper's degrees may be half the angle of rotation: then they stand for twice as much.
    const Pair whole{cell.position_mm * kMillimetre, cell.orientation_deg * kDegree};
    const Pair half{whole.position_m, 2 * whole.orientation_rad};
    row("position error", "m", position).published = whole.position_m;
    row("orientation error", "rad", turn).published = whole.orientation_rad;
    const auto ask = [&, first = result.rows.size() - 2](const Pair& wanted) {
      result.rows[first].at_most = wanted.position_m;
      result.rows[first + 1].at_most = wanted.orientation_rad;
    };
    if (position <= whole.position_m && turn <= whole.orientation_rad) {
      ask(whole);
    } else {
      const std::vector<Pair> pairs = front(context, robot);
      for (const Pair& wanted : {half, whole}) {
        if (nearest(pairs, wanted) <= 1) ask(wanted);
      }
      row("without humanlikeness, nearest pair over published", "1", nearest(pairs, whole));
      row("the same, published degrees as half the angle", "1", nearest(pairs, half));
    }
    row("A, mean over centres", "m^2", math::mean(ours.humanlike_m2));
    if (share_of(met) > 0) {
      row("A over its optimum at exact tips, reachable frames", "1",
          mean_of(ours.humanlike_m2, met) / mean_of(best.humanlike_m2, met))
          .at_most = 1.05;
      row("position error, reachable frames", "m", mean_of(ours.position_m, met));
      row("orientation error, reachable frames", "rad", mean_of(ours.orientation_rad, met));
    }
    StudyRow& time = row("a frame, warm", "s", ours.seconds / static_cast<double>(ours.solves));
    time.timed = true;
  }
}

}  // namespace morphe::study
