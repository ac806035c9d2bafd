#include "stages/repair/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// The worst of what is left: collisions first.
Refusal refusal_of(const std::vector<Finding>& remaining, const RepairOptions& options) {
  const auto worst_of = [&](const auto& counts) {
    const Finding* worst = nullptr;
    for (const Finding& finding : remaining) {
      if (counts(finding.cause) && (!worst || finding.depth > worst->depth)) worst = &finding;
    }
    return worst;
  };
  if (const Finding* worst = worst_of(is_collision)) {
    return {Reason::no_path, fmt::format("{}; no free path in {} attempts of {} iterations",
                                         sentence(*worst), options.attempts, options.iterations)};
  }
  constexpr std::array<std::pair<Cause, Reason>, 3> kOthers{{{Cause::limit, Reason::limit},
                                                             {Cause::jump, Reason::jump},
                                                             {Cause::tracking, Reason::tracking}}};
  for (const auto& [cause, reason] : kOthers) {
    if (const Finding* worst = worst_of([&, its = cause](Cause one) { return one == its; })) {
      return {reason, sentence(*worst)};
    }
  }
  return {};
}

}  // namespace

bool less_bad(const std::vector<Finding>& a, const std::vector<Finding>& b) {
  return badness(a) < badness(b);
}

bool nearly_free(const std::vector<Finding>& findings) {
  constexpr double kMost = 0.01;
  return std::ranges::all_of(findings, [](const Finding& f) { return f.depth <= kMost; });
}

Made climb(const std::vector<Rung>& ladder, Checked start) {
  Made best{std::move(start)};
  for (const Rung& rung : ladder) {
    if (best.checked.findings.empty() || best.last) break;
    Made made = rung(best.checked);
    if (less_bad(made.checked.findings, best.checked.findings)) {
      best = std::move(made);
    } else if (made.refusal) {
      made.checked = std::move(best.checked);
      best = std::move(made);
    }
  }
  return best;
}

Rung if_nearly_free(Rung rung) {
  return [rung = std::move(rung)](const Checked& best) {
    return nearly_free(best.findings) ? rung(best) : Made{best};
  };
}

Outcome<RepairResult> repair_path(const std::vector<Rung>& ladder, Checked start,
                                  const RepairOptions& options) {
  const bool clean = start.findings.empty() || start.path.position.rows() == 0;
  Made made = clean ? Made{std::move(start)} : climb(ladder, std::move(start));
  const std::vector<Finding>& remaining = made.checked.findings;
  if (!made.refusal) made.refusal = refusal_of(remaining, options);
  const bool repaired = !clean && remaining.empty();
  return {{std::move(made.checked.path), repaired, std::move(made.checked.findings)},
          std::move(made.refusal)};
}

std::string sentence(const Finding& finding) {
  const std::string pair =
      finding.second.empty() ? finding.first : finding.first + " – " + finding.second;
  return fmt::format("{}: {} from {:.3f} s to {:.3f} s, {:.4f} {} too much", name_of(finding.cause),
                     pair, finding.begin_s, finding.end_s, finding.depth,
                     finding.cause == Cause::limit || finding.cause == Cause::jump ? "rad" : "m");
}

}  // namespace morphe::repair
