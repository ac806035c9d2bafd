#include "stages/repair/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace morphe::repair {
namespace {

/// Sums of depths [m or rad]: of collisions, of everything else.
std::pair<double, double> badness(const std::vector<Finding>& findings) {
  std::pair<double, double> sum{0, 0};
  for (const Finding& finding : findings) {
    (is_collision(finding.cause) ? sum.first : sum.second) += finding.depth;
  }
  return sum;
}

/// The order in which findings are spoken of: collisions, limits, jumps, tips.
int order_of(Cause cause) {
  if (is_collision(cause)) return 0;
  return cause == Cause::limit ? 1 : cause == Cause::jump ? 2 : 3;
}

/// The worst of what is left.
Refusal refusal_of(const std::vector<Finding>& remaining) {
  constexpr std::array kReasons{Reason::no_path, Reason::limit, Reason::jump, Reason::tracking};
  const Finding* worst = worst_of(remaining);
  if (!worst) return {};
  return {kReasons.at(static_cast<std::size_t>(order_of(worst->cause))), sentence(*worst)};
}

}  // namespace

bool less_bad(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  return badness(a) < badness(b);
}

const Finding* worst_of(const std::vector<Finding>& findings) {
  const auto worst = std::ranges::min_element(findings, {}, [](const Finding& finding) {
    return std::pair(order_of(finding.cause), -finding.depth);
  });
  return worst == findings.end() ? nullptr : &*worst;
}

bool nearly_free(const std::vector<Finding>& findings) {
  constexpr double kMost = 0.01;
  return std::ranges::all_of(findings, [](const Finding& f) { return f.depth <= kMost; });
}

RepairStep step_of(std::string name, const Checked& from, const Made& made, bool kept) {
  RepairStep step;
  step.name = std::move(name);
  const JointRows &before = from.path.position, &after = made.checked.path.position;
  for (Eigen::Index row = 0; row < after.rows() && after.rows() == before.rows(); ++row) {
    const double change = (after.row(row) - before.row(row)).cwiseAbs().maxCoeff();
    if (!(change > 0)) continue;
    const double time_s = from.path.demonstration_time[static_cast<std::size_t>(row)];
    if (std::isnan(step.begin_s)) step.begin_s = time_s;
    step.end_s = time_s;
    step.change = std::max(step.change, change);
  }
  const std::vector<Finding>& left = made.checked.findings;
  step.findings = static_cast<std::int32_t>(left.size());
  std::tie(step.collisions, step.others) = badness(left);
  if (const Finding* worst = worst_of(left)) step.worst = sentence(*worst);
  step.kept = kept;
  step.ended = made.refusal ? made.refusal.detail : made.ended;
  return step;
}

Made climb(const std::vector<Rung>& ladder, Checked start) {
  Made best{std::move(start)};
  std::vector<RepairStep> steps;
  for (const Rung& rung : ladder) {
    if (best.checked.findings.empty() || best.last) break;
    Made made = rung.make(best.checked);
    const bool kept = less_bad(made.checked.findings, best.checked.findings);
    steps.push_back(step_of(rung.name, best.checked, made, kept));
    for (RepairStep& attempt : made.steps) {
      attempt.level = 1;
      steps.push_back(std::move(attempt));
    }
    if (kept) {
      best = std::move(made);
    } else if (made.refusal) {
      made.checked = std::move(best.checked);
      best = std::move(made);
    }
  }
  best.steps = std::move(steps);
  best.ended.clear();
  return best;
}

Rung if_nearly_free(Rung rung) {
  return {rung.name, [make = std::move(rung.make)](const Checked& best) {
            if (nearly_free(best.findings)) return make(best);
            return Made{
                best, {}, false, "not tried: something is wrong by more than 10 mm or 0.01 rad"};
          }};
}

Outcome<RepairResult> repair_path(const std::vector<Rung>& ladder, Checked start) {
  const bool clean = start.findings.empty() || start.path.position.rows() == 0;
  Made made = clean ? Made{std::move(start)} : climb(ladder, std::move(start));
  const std::vector<Finding>& remaining = made.checked.findings;
  if (!made.refusal) made.refusal = refusal_of(remaining);
  const bool repaired = !clean && remaining.empty();
  return {{std::move(made.checked.path), repaired, std::move(made.checked.findings),
           std::move(made.steps)},
          std::move(made.refusal)};
}

std::string no_free_path(const RepairOptions& options) {
  return fmt::format("no free path in {} attempts of {} iterations", options.attempts,
                     options.iterations);
}

std::string sentence(const Finding& finding) {
  const std::string pair =
      finding.second.empty() ? finding.first : finding.first + " – " + finding.second;
  return fmt::format("{}: {} from {:.3f} s to {:.3f} s, {:.4f} {} too much", name_of(finding.cause),
                     pair, finding.begin_s, finding.end_s, finding.depth,
                     finding.cause == Cause::limit || finding.cause == Cause::jump ? "rad" : "m");
}

}  // namespace morphe::repair
