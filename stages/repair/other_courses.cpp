#include "stages/repair/other_courses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace morphe::repair {
namespace {

/// Whether the same is wrong at the same time, and about as much or more.
bool fails_there(const std::vector<Finding>& findings, const Finding& place) {
  constexpr double kAboutAsMuch = 0.8;
  return std::ranges::any_of(findings, [&](const Finding& finding) {
    return finding.cause == place.cause && finding.first == place.first &&
           finding.second == place.second && finding.begin_s <= place.end_s &&
           place.begin_s <= finding.end_s && finding.depth >= kAboutAsMuch * place.depth;
  });
}

/// Whether so many failed where this does that no other will do.
bool often_enough(const CourseEnds& ends, const std::vector<Finding>& best) {
  constexpr int kOftenEnough = 4;
  return std::ranges::count_if(ends, [&](const std::vector<Finding>& findings) {
           return fails_there(findings, *worst_of(best));
         }) >= kOftenEnough;
}

}  // namespace

Rung other_courses(std::string name, std::vector<Rung> rungs, Check check, NextCourse courses,
                   CourseEnds& ends) {
  const auto make = [rungs = std::move(rungs), check = std::move(check),
                     courses = std::move(courses), &ends](const Checked& from) {
    NextCourse next = courses;
    bool nearer = true;
    Made best{from};
    std::vector<RepairStep> steps;
    while (!best.checked.findings.empty()) {
      if (often_enough(ends, best.checked.findings)) {
        best.ended = "four courses failed at the same place";
        break;
      }
      std::optional<JointPath> course = next(nearer);
      if (!course) {
        best.ended = steps.empty() ? "there is no other course" : "no further course";
        break;
      }
      Checked checked{std::move(*course), {}};
      checked.findings = check(checked.path);
      Made made = climb(rungs, std::move(checked));
      ends.push_back(made.checked.findings);
      nearer = less_bad(made.checked.findings, best.checked.findings);
      steps.push_back(
          step_of(fmt::format("course {}", steps.size() + 1), best.checked, made, nearer));
      if (nearer) best = std::move(made);
    }
    best.steps = std::move(steps);
    return best;
  };
  return {std::move(name), make};
}

}  // namespace morphe::repair
