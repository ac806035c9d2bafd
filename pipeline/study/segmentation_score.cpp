#include "pipeline/study/segmentation_score.hpp"

#include <algorithm>
#include <cmath>

namespace morphe::study {
namespace {

struct Interval {
  double begin_s, end_s;
};
using Phases = std::map<PhaseKind, std::vector<Interval>>;

/// Returns the labelled phases by kind, one element per movement.
std::vector<Phases> labelled_movements(const std::vector<Label>& labels) {
  std::vector<Phases> movements;
  for (const Label& label : labels) {
    if (label.phase == PhaseKind::rest) continue;
    if (label.phase == PhaseKind::reach) movements.emplace_back();
    if (!movements.empty()) movements.back()[label.phase].push_back({label.begin_s, label.end_s});
  }
  return movements;
}

Phases phases_of(const Movement& movement) {
  Phases phases;
  for (const Phase& phase : movement.phases)
    phases[phase.kind].push_back({phase.begin_s, phase.end_s});
  return phases;
}

double overlap_over_union(const Interval& a, const Interval& b) {
  const double overlap_s = std::min(a.end_s, b.end_s) - std::max(a.begin_s, b.begin_s);
  const double union_s = std::max(a.end_s, b.end_s) - std::min(a.begin_s, b.begin_s);
  return union_s > 0 ? std::max(0.0, overlap_s) / union_s : 0;
}

void add_boundary_errors(const Phases& labelled, const Phases& found, SegmentationScore& score) {
  for (const auto& [kind, intervals] : labelled) {
    const auto match = found.find(kind);
    const std::string name(name_of(kind));
    if (match == found.end()) continue;
    for (int k = 0; k < std::min(std::ssize(intervals), std::ssize(match->second)); ++k) {
      const Interval &a = intervals[k], &b = match->second[k];
      score.error_s[name + " begin"].push_back(std::abs(b.begin_s - a.begin_s));
      score.error_s[name + " end"].push_back(std::abs(b.end_s - a.end_s));
    }
  }
}

}  // namespace

double SegmentationScore::precision() const {
  return found == 0 ? 1 : matched / static_cast<double>(found);
}

double SegmentationScore::recall() const {
  return labelled == 0 ? 1 : matched / static_cast<double>(labelled);
}

std::vector<double> SegmentationScore::reach_errors_s() const {
  std::vector<double> errors;
  for (const char* name : {"reach begin", "reach end"}) {
    const auto part = error_s.find(name);
    if (part == error_s.end()) continue;
    errors.insert(errors.end(), part->second.begin(), part->second.end());
  }
  return errors;
}

void SegmentationScore::add(const SegmentationScore& other) {
  labelled += other.labelled;
  found += other.found;
  matched += other.matched;
  for (const auto& [name, errors] : other.error_s) {
    std::vector<double>& all = error_s[name];
    all.insert(all.end(), errors.begin(), errors.end());
  }
}

SegmentationScore score_segmentation(const std::vector<Label>& labels,
                                     const std::vector<Movement>& movements) {
  SegmentationScore score;
  std::vector<Phases> unmatched;
  for (const Movement& movement : movements) {
    unmatched.push_back(phases_of(movement));
    ++score.found;
  }
  for (const Phases& truth : labelled_movements(labels)) {
    ++score.labelled;
    const auto match = std::ranges::find_if(unmatched, [&](const Phases& found) {
      const auto reach = found.find(PhaseKind::reach);
      return reach != found.end() &&
             overlap_over_union(truth.at(PhaseKind::reach).front(), reach->second.front()) > 0.5;
    });
    if (match == unmatched.end()) continue;
    ++score.matched;
    add_boundary_errors(truth, *match, score);
    unmatched.erase(match);
  }
  return score;
}

}  // namespace morphe::study
