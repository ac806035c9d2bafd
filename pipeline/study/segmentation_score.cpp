#include "pipeline/study/segmentation_score.hpp"

#include <fmt/format.h>

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
  for (const Phase& phase : movement.phases) {
    phases[phase.kind].push_back({phase.begin_s, phase.end_s});
  }
  return phases;
}

double overlap_over_union(const Interval& a, const Interval& b) {
  const double both = std::min(a.end_s, b.end_s) - std::max(a.begin_s, b.begin_s);
  const double either = std::max(a.end_s, b.end_s) - std::min(a.begin_s, b.begin_s);
  return either > 0 ? std::max(0.0, both) / either : 0;
}

void compare(const Phases& labelled, const Phases& found, SegmentationScore& score) {
  for (const auto& [kind, intervals] : labelled) {
    const auto match = found.find(kind);
    const std::string name(name_of(kind));
    if (match == found.end()) continue;
    const std::size_t both = std::min(intervals.size(), match->second.size());
    for (std::size_t k = 0; k < both; ++k) {
      const Interval &a = intervals[k], &b = match->second[k];
      score.error_s[name + " begin"].push_back(std::abs(b.begin_s - a.begin_s));
      score.error_s[name + " end"].push_back(std::abs(b.end_s - a.end_s));
    }
  }
}

}  // namespace

double SegmentationScore::precision() const {
  return found == 0 ? 1 : static_cast<double>(matched) / static_cast<double>(found);
}

double SegmentationScore::recall() const {
  return labelled == 0 ? 1 : static_cast<double>(matched) / static_cast<double>(labelled);
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
  const std::vector<Phases> labelled = labelled_movements(labels);
  SegmentationScore score;
  score.labelled = labelled.size();
  score.found = movements.size();
  std::vector<bool> taken(movements.size(), false);
  for (const Phases& truth : labelled) {
    for (std::size_t k = 0; k < movements.size(); ++k) {
      const Phases found = phases_of(movements[k]);
      const auto reach = found.find(PhaseKind::reach);
      if (taken[k] || reach == found.end() ||
          overlap_over_union(truth.at(PhaseKind::reach).front(), reach->second.front()) <= 0.5) {
        continue;
      }
      taken[k] = true;
      ++score.matched;
      compare(truth, found, score);
      break;
    }
  }
  return score;
}

}  // namespace morphe::study
