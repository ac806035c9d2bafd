#include "stages/repair/other_courses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace morphe::repair {
namespace {

/// The same things wrong at the same times, and about as much.
bool alike(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  constexpr double kAsMuch = 0.2;
  return std::ranges::equal(a, b, [](const Finding& x, const Finding& y) {
    return x.cause == y.cause && x.first == y.first && x.second == y.second &&
           x.begin_s <= y.end_s && y.begin_s <= x.end_s &&
           std::abs(x.depth - y.depth) <= kAsMuch * std::max(x.depth, y.depth);
  });
}

}  // namespace

Made other_courses(const Surroundings& around, const NextCourse& next, const Checked& from) {
  constexpr int kOftenEnough = 4;  // courses that end with the same findings: no other will do
  int ended_there = 0, number = 0;
  bool nearer = true;
  Made best{from};
  std::vector<RepairStep> steps;
  while (!best.checked.findings.empty() && ended_there < kOftenEnough) {
    std::optional<JointPath> course = next(nearer);
    if (!course) break;
    ++number;
    Checked checked{std::move(*course), {}};
    checked.findings = around.check(checked.path);
    Made made = climb(around.win_back, std::move(checked));
    const bool detour_may_do =
        std::ranges::all_of(made.checked.findings, is_collision, &Finding::cause);
    if (detour_may_do) made = detour(around, made.checked);
    nearer = less_bad(made.checked.findings, best.checked.findings);
    steps.push_back(step_of(fmt::format("course {}", number), best.checked, made, nearer));
    const bool same = alike(made.checked.findings, best.checked.findings);
    if (same) ++ended_there;
    if (!nearer) continue;
    if (!same) ended_there = 0;
    best = std::move(made);
  }
  best.steps = std::move(steps);
  best.ended = best.checked.findings.empty() ? ""
               : ended_there >= kOftenEnough ? "four courses ended with the same findings"
               : number == 0                 ? "there is no other course"
                                             : "no further course";
  return best;
}

}  // namespace morphe::repair
