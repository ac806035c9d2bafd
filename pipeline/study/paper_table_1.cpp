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

constexpr double kMetresPerMillimetre = 1e-3;

/// The values of the paper's table 1: position [mm] and orientation [degrees].
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

struct ErrorPair {
  double position_m, orientation_rad;
};

/// Computes mean errors of solves without humanlikeness, with weights from nearly all on the
/// position to nearly all on the orientation.
std::vector<ErrorPair> pareto_front(const PaperContext& context, const robot::Robot& robot) {
  std::vector<ErrorPair> pairs;
  for (double orientation = 1e-2; orientation < 2e3; orientation *= 10) {
    const MappedPoses plain =
        map_all(context, robot, context.arms, {context.weights.tip_position, orientation, 0});
    pairs.push_back({math::mean(plain.position_m), math::mean(plain.orientation_rad)});
  }
  return pairs;
}

/// Finds the pair of errors nearest to a required one, measured as the larger of the two ratios. If
/// the result is above 1, the requirement is geometrically impossible on these motions.
double least_ratio(const std::vector<ErrorPair>& front, const ErrorPair& wanted) {
  double least = std::numeric_limits<double>::infinity();
  for (const ErrorPair& pair : front) {
    least = std::min(least, std::max(pair.position_m / wanted.position_m,
                                     pair.orientation_rad / wanted.orientation_rad));
  }
  return least;
}

}  // namespace

void run_table_1(const PaperContext& context, StudyResult& result) {
  for (const Published& cell : kPublished) {
    const robot::Robot robot(
        robot::generate_arm({.joints = cell.joints, .length = cell.scale * context.arm_length()}));
    const MappedPoses ours = map_all(context, robot, context.arms, context.weights);
    StudyWeights plain = context.weights, heavily_weighted = context.weights;
    plain.humanlike = 0;
    heavily_weighted.tip_position *= 100;
    heavily_weighted.tip_orientation *= 100;
    const std::vector<char> met = reachable_frames(map_all(context, robot, context.arms, plain));
    const MappedPoses best = map_all(context, robot, context.arms, heavily_weighted);
    const Case of = {{"table", "1"},
                     {"joints", std::to_string(cell.joints)},
                     {"length", fmt::format("{:.2f}", cell.scale)}};
    const std::size_t n = ours.q.size();
    const auto row = [&](const char* metric, const char* unit, double value) -> StudyRow& {
      result.rows.push_back(make_row(of, metric, unit, value, n));
      result.rows.back().reachable = marked_share(met);
      return result.rows.back();
    };
    const double position = math::mean(ours.position_m), turn = math::mean(ours.orientation_rad);
    // The paper's degrees may be half the angle of rotation; the full angle is then twice as large.
    const ErrorPair whole{cell.position_mm * kMetresPerMillimetre,
                          cell.orientation_deg * kRadPerDegree};
    const ErrorPair half{whole.position_m, 2 * whole.orientation_rad};
    row("position error", "m", position).published = whole.position_m;
    row("orientation error", "rad", turn).published = whole.orientation_rad;
    const auto ask = [&, first = result.rows.size() - 2](const ErrorPair& wanted) {
      result.rows[first].at_most = wanted.position_m;
      result.rows[first + 1].at_most = wanted.orientation_rad;
    };
    if (position <= whole.position_m && turn <= whole.orientation_rad) {
      ask(whole);
    } else {
      const std::vector<ErrorPair> pairs = pareto_front(context, robot);
      for (const ErrorPair& wanted : {half, whole}) {
        if (least_ratio(pairs, wanted) <= 1) ask(wanted);
      }
      row("without humanlikeness, closest pair over published", "1", least_ratio(pairs, whole));
      row("without humanlikeness, published degrees as half the angle", "1",
          least_ratio(pairs, half));
    }
    row("A, mean over centres", "m^2", math::mean(ours.humanlike_m2));
    if (marked_share(met) > 0) {
      row("A over its optimum at exact tips, reachable frames", "1",
          mean_of_marked(ours.humanlike_m2, met) / mean_of_marked(best.humanlike_m2, met))
          .at_most = 1.05;
      row("position error, reachable frames", "m", mean_of_marked(ours.position_m, met));
      row("orientation error, reachable frames", "rad", mean_of_marked(ours.orientation_rad, met));
    }
    StudyRow& time =
        row("time per frame, warm start", "s", ours.seconds / static_cast<double>(ours.solves));
    time.is_timing = true;
  }
}

}  // namespace morphe::study
