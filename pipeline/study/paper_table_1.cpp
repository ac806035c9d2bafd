#include <fmt/format.h>

#include <algorithm>
#include <array>

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

/// Computes mean errors without humanlikeness, for increasing weights of the orientation.
std::vector<ErrorPair> pareto_front(const PaperContext& context, const robot::Robot& robot) {
  std::vector<ErrorPair> pairs;
  for (double orientation = 1e-2; orientation < 2e3; orientation *= 10) {
    const MappedPoses plain =
        map_all(context, robot, context.arms, {context.weights.tip_position, orientation, 0});
    pairs.push_back({math::mean(plain.position_m), math::mean(plain.orientation_rad)});
  }
  return pairs;
}

/// Returns the minimum over the pairs of max(position error / required, orientation error /
/// required). Above 1, the requirement is geometrically impossible on these motions.
double least_ratio(const std::vector<ErrorPair>& front, const ErrorPair& required) {
  double least = kInfinity;
  for (const ErrorPair& pair : front)
    least = std::min(least, std::max(pair.position_m / required.position_m,
                                     pair.orientation_rad / required.orientation_rad));
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
    const std::vector<char> reachable =
        reachable_frames(map_all(context, robot, context.arms, plain));
    const MappedPoses exact_tips = map_all(context, robot, context.arms, heavily_weighted);
    const Case condition = {{"table", "1"},
                            {"joints", std::to_string(cell.joints)},
                            {"length", fmt::format("{:.2f}", cell.scale)}};
    const ReachableRows rows{condition, ours.q.size(), reachable, result};
    const auto mean_of = [&](const std::vector<double>& values) {
      return mean_of_marked(values, reachable);
    };
    const ErrorPair error{math::mean(ours.position_m), math::mean(ours.orientation_rad)};
    // The paper's degrees may be half the angle of rotation; the full angle is then twice as large.
    const ErrorPair full_angle{cell.position_mm * kMetresPerMillimetre,
                               cell.orientation_deg * kRadPerDegree};
    const ErrorPair half_angle{full_angle.position_m, 2 * full_angle.orientation_rad};
    rows.add("position error", "m", error.position_m).published = full_angle.position_m;
    rows.add("orientation error", "rad", error.orientation_rad).published =
        full_angle.orientation_rad;
    const auto require = [&, first = result.rows.size() - 2](const ErrorPair& required) {
      result.rows[first].at_most = required.position_m;
      result.rows[first + 1].at_most = required.orientation_rad;
    };
    if (error.position_m <= full_angle.position_m &&
        error.orientation_rad <= full_angle.orientation_rad) {
      require(full_angle);
    } else {
      const std::vector<ErrorPair> front = pareto_front(context, robot);
      for (const ErrorPair& required : {half_angle, full_angle}) {
        if (least_ratio(front, required) <= 1) require(required);
      }
      rows.add("without humanlikeness, closest pair over published", "1",
               least_ratio(front, full_angle));
      rows.add("without humanlikeness, published degrees as half the angle", "1",
               least_ratio(front, half_angle));
    }
    rows.add("A, mean over centres", "m^2", math::mean(ours.humanlike_m2));
    if (std::ranges::count(reachable, 1) > 0) {
      rows.add("A over its optimum at exact tips, reachable frames", "1",
               mean_of(ours.humanlike_m2) / mean_of(exact_tips.humanlike_m2))
          .at_most = 1.05;
      rows.add("position error, reachable frames", "m", mean_of(ours.position_m));
      rows.add("orientation error, reachable frames", "rad", mean_of(ours.orientation_rad));
    }
    rows.add_solve_time(ours);
  }
}

}  // namespace morphe::study
