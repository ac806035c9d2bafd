#include "stages/check/finding_rows.hpp"

#include <algorithm>

namespace morphe::check {

void FindingRows::add(Cause cause, const std::string& one, const std::string& other,
                      std::size_t first, std::size_t last, double depth) {
  rows_[{cause, one, other}].push_back({first, last, depth});
}

std::vector<Finding> FindingRows::join(const std::vector<double>& demonstration_time) const {
  std::vector<Finding> findings;
  for (const auto& [names, unordered] : rows_) {
    std::vector<Row> rows = unordered;
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return a.first < b.first; });
    std::vector<Row> joined;
    for (const Row& row : rows) {
      if (joined.empty() || row.first > joined.back().last + 1) {
        joined.push_back(row);
        continue;
      }
      joined.back().last = std::max(joined.back().last, row.last);
      joined.back().depth = std::max(joined.back().depth, row.depth);
    }
    const auto& [cause, first, second] = names;
    for (const Row& row : joined) {
      findings.push_back({demonstration_time[row.first], demonstration_time[row.last], cause, first,
                          second, row.depth});
    }
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.begin_s < b.begin_s; });
  return findings;
}

}  // namespace morphe::check
