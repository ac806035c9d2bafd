#include "stages/check/finding_rows.hpp"

#include <algorithm>
#include <utility>

namespace morphe::check {

void FindingRows::add(const Finding& violation, int first, int last) {
  rows_[{violation.cause, violation.subject, violation.other_body}].push_back(
      {first, last, violation});
}

std::vector<Finding> FindingRows::join(const std::vector<double>& demonstration_time) const {
  std::vector<Finding> findings;
  for (auto [names, rows] : rows_) {
    std::ranges::sort(rows, {}, &Row::first);
    std::vector<Row> joined;
    for (const Row& row : rows) {
      if (joined.empty() || row.first > joined.back().last + 1) {
        joined.push_back(row);
        continue;
      }
      joined.back().last = std::max(joined.back().last, row.last);
      if (row.finding.excess > joined.back().finding.excess) joined.back().finding = row.finding;
    }
    for (Row& row : joined) {
      row.finding.begin_s = demonstration_time[row.first];
      row.finding.end_s = demonstration_time[row.last];
      findings.push_back(std::move(row.finding));
    }
  }
  std::ranges::stable_sort(findings, {}, &Finding::begin_s);
  return findings;
}

}  // namespace morphe::check
