#include "pipeline/study/grasp_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"

namespace morphe::study {
namespace {

constexpr double kMaxContactError_mm = 5, kMaxPadAngle_deg = 12, kMaxPadPenetration_mm = 1;
constexpr double kMaxHumanlikenessRatio = 1.1, kMaxDurationRatio = 1.1;

/// Adds the median and the 90th percentile; `at_most` is the limit of the median.
void add_median_rows(const Case& of, const std::string& metric, const char* unit,
                     const std::vector<double>& values, double at_most, StudyResult& result) {
  result.rows.push_back(
      make_row(of, metric + ", median", unit, math::quantile(values, 0.5), values.size()));
  result.rows.back().at_most = at_most;
  result.rows.push_back(
      make_row(of, metric + ", 90 %", unit, math::quantile(values, 0.9), values.size()));
}

struct Column {
  const char* metric;
  const char* unit;
  double scale;
  double ContactError::*value;
  double at_most;                 ///< limit of the median, for plans with contacts
  bool is_topo_retarget = false;  ///< true for measures of TopoRetarget
};
constexpr Column kColumns[] = {
    {"contact point error", "mm", 1e3, &ContactError::distance, kMaxContactError_mm},
    {"pad angle to the inward normal", "deg", 1 / kRadPerDegree, &ContactError::pad_angle,
     kMaxPadAngle_deg},
    {"gap between pad and surface", "mm", 1e3, &ContactError::gap, kUnknown},
    {"precision (TopoRetarget), fingertips", "mm", 1e3, &ContactError::precision, kUnknown, true},
    {"precision (TopoRetarget), pads", "mm", 1e3, &ContactError::pad_precision, kUnknown, true},
    {"alignment (TopoRetarget)", "deg", 1 / kRadPerDegree, &ContactError::alignment, kUnknown,
     true}};

void add_variant_rows(const Case& of, const std::vector<GraspComparison>& pairs,
                      GraspScore GraspComparison::*variant, bool ours, StudyResult& result) {
  std::size_t executable = 0, by_fingertips = 0, run = 0;
  double pads_m = 0, links_m = 0;
  std::vector<double> values[std::size(kColumns)];
  for (const GraspComparison& pair : pairs) {
    const GraspScore& score = pair.*variant;
    executable += score.executable ? 1 : 0;
    by_fingertips += pair.fingertips.executable ? 1 : 0;
    run += score.has_trajectory ? 1 : 0;
    pads_m = std::max(pads_m, score.penetration.pads_m);
    links_m = std::max(links_m, score.penetration.other_links_m);
    for (const ContactError& error : score.errors) {
      for (std::size_t c = 0; c < std::size(kColumns); ++c) {
        const double value = kColumns[c].scale * error.*kColumns[c].value;
        if (std::isfinite(value)) values[c].push_back(value);
      }
    }
  }
  const auto row = [&](const std::string& metric, const char* unit, double value,
                       std::size_t n) -> StudyRow& {
    result.rows.push_back(make_row(of, metric, unit, value, n));
    return result.rows.back();
  };
  const double all = static_cast<double>(pairs.size());
  StudyRow& share = row("executable", "1", static_cast<double>(executable) / all, pairs.size());
  if (ours) share.at_least = static_cast<double>(by_fingertips) / all;
  StudyRow& pads = row("penetration of pads, largest", "mm", 1e3 * pads_m, run);
  if (ours) pads.at_most = kMaxPadPenetration_mm;
  StudyRow& links = row("penetration of other links, largest", "mm", 1e3 * links_m, run);
  if (ours) links.at_most = 0;
  for (std::size_t c = 0; c < std::size(kColumns); ++c) {
    if (values[c].empty()) continue;  // the set has no known contact
    add_median_rows(of, kColumns[c].metric, kColumns[c].unit, values[c],
                    ours ? kColumns[c].at_most : kUnknown, result);
    if (!kColumns[c].is_topo_retarget) continue;  // only means are published
    row(fmt::format("{}, mean", kColumns[c].metric), kColumns[c].unit, math::mean(values[c]),
        values[c].size());
  }
}

void add_contact_rows(const Case& of, const std::vector<GraspComparison>& pairs,
                      StudyResult& result) {
  std::size_t run = 0, without = 0, known = 0, asked = 0, kept = 0, touched = 0, closed = 0,
              closed_touch = 0;
  for (const GraspComparison& pair : pairs) {
    const GraspScore& score = pair.contacts;
    if (!score.has_trajectory) continue;
    ++run;
    without += score.demonstrated + score.closed == 0 ? 1 : 0;
    known += score.errors.size();
    asked += pair.demonstrated_contacts;
    kept += std::min(score.demonstrated, pair.demonstrated_contacts);
    touched += score.touching;
    closed += score.closed;
    closed_touch += score.closed_touching;
  }
  const auto row = [&](const char* metric, std::size_t value) {
    result.rows.push_back(make_row(of, metric, "1", static_cast<double>(value), run));
  };
  row("known contacts", known);
  row("contacts demonstrated", asked);
  row("contacts dropped", asked - kept);
  row("contacts touching", touched);
  row("closed fingers", closed);
  row("closed fingers touching", closed_touch);
  row("plans without contact", without);
}

void add_ratio_rows(const Case& of, const std::vector<GraspComparison>& pairs,
                    StudyResult& result) {
  std::vector<double> humanlikeness, duration;
  for (const GraspComparison& pair : pairs) {
    if (!pair.contacts.executable || !pair.fingertips.executable) continue;
    humanlikeness.push_back(pair.contacts.humanlikeness / pair.fingertips.humanlikeness);
    duration.push_back(pair.contacts.duration_s / pair.fingertips.duration_s);
  }
  if (humanlikeness.empty()) return;
  add_median_rows(of, "A, ratio", "1", humanlikeness, kMaxHumanlikenessRatio, result);
  add_median_rows(of, "duration, ratio", "1", duration, kMaxDurationRatio, result);
}

}  // namespace

void add_grasp_rows(const GraspStudyOptions& options, const Case& of,
                    const std::vector<GraspComparison>& pairs, StudyResult& result) {
  const auto variant = [&](const std::string& name) {
    Case own = of;
    own.emplace_back("variant", name);
    return own;
  };
  const std::string &contacts = options.contacts.name, &fingertips = options.fingertips.name;
  add_variant_rows(variant(contacts), pairs, &GraspComparison::contacts, true, result);
  add_contact_rows(variant(contacts), pairs, result);
  add_variant_rows(variant(fingertips), pairs, &GraspComparison::fingertips, false, result);
  add_ratio_rows(variant(contacts + " over " + fingertips), pairs, result);
}

}  // namespace morphe::study
