#include "pipeline/study/grasp_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/statistics.hpp"

namespace morphe::study {
namespace {

constexpr double kMaxContactError_mm = 5, kMaxPadAngle_deg = 12, kMaxPadPenetration_mm = 1;
constexpr double kMaxHumanlikenessRatio = 1.1, kMaxDurationRatio = 1.1;

/// Adds the median and the 90th percentile; `at_most` is the requirement for the median.
void add_median_rows(const Case& condition, const std::string& metric, const char* unit,
                     const std::vector<double>& values, double at_most, StudyResult& result) {
  result.add(condition, metric + ", median", unit, math::quantile(values, 0.5), values.size())
      .at_most = at_most;
  result.add(condition, metric + ", 90 %", unit, math::quantile(values, 0.9), values.size());
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

void add_variant_rows(const Case& condition, const std::vector<GraspComparison>& pairs,
                      GraspScore GraspComparison::*variant, bool ours, StudyResult& result) {
  int executable = 0, fingertips_executable = 0, with_trajectory = 0;
  double pads_m = 0, links_m = 0;
  for (const GraspComparison& pair : pairs) {
    const GraspScore& score = pair.*variant;
    executable += score.executable ? 1 : 0;
    fingertips_executable += pair.fingertips.executable ? 1 : 0;
    with_trajectory += score.has_trajectory ? 1 : 0;
    pads_m = std::max(pads_m, score.penetration.pads_m);
    links_m = std::max(links_m, score.penetration.other_links_m);
  }
  const double all = static_cast<double>(pairs.size());
  const auto row = [&](auto... values) -> StudyRow& { return result.add(condition, values...); };
  row("executable", "1", executable / all, pairs.size()).at_least =
      ours ? fingertips_executable / all : kUnknown;
  row("penetration of pads, largest", "mm", 1e3 * pads_m, with_trajectory).at_most =
      ours ? kMaxPadPenetration_mm : kUnknown;
  row("penetration of other links, largest", "mm", 1e3 * links_m, with_trajectory).at_most =
      ours ? 0 : kUnknown;
  for (const Column& column : kColumns) {
    std::vector<double> values;
    for (const GraspComparison& pair : pairs) {
      for (const ContactError& error : (pair.*variant).errors) {
        const double value = column.scale * error.*column.value;
        if (std::isfinite(value)) values.push_back(value);
      }
    }
    if (values.empty()) continue;  // the set has no known contact
    add_median_rows(condition, column.metric, column.unit, values, ours ? column.at_most : kUnknown,
                    result);
    if (!column.is_topo_retarget) continue;  // only means are published
    result.add(condition, fmt::format("{}, mean", column.metric), column.unit, math::mean(values),
               values.size());
  }
}

void add_contact_rows(const Case& condition, const std::vector<GraspComparison>& pairs,
                      StudyResult& result) {
  int plans = 0, without_contact = 0, demonstrated = 0, kept = 0, touching = 0, closed = 0,
      closed_touching = 0;
  std::ptrdiff_t known = 0;
  for (const GraspComparison& pair : pairs) {
    const GraspScore& score = pair.contacts;
    if (!score.has_trajectory) continue;
    ++plans;
    without_contact += score.demonstrated + score.closed == 0 ? 1 : 0;
    known += std::ssize(score.errors);
    demonstrated += pair.demonstrated_contacts;
    kept += std::min(score.demonstrated, pair.demonstrated_contacts);
    touching += score.touching;
    closed += score.closed;
    closed_touching += score.closed_touching;
  }
  const auto row = [&](const char* metric, std::ptrdiff_t value) {
    result.add(condition, metric, "1", static_cast<double>(value), plans);
  };
  row("known contacts", known);
  row("contacts demonstrated", demonstrated);
  row("contacts dropped", demonstrated - kept);
  row("contacts touching", touching);
  row("closed fingers", closed);
  row("closed fingers touching", closed_touching);
  row("plans without contact", without_contact);
}

void add_ratio_rows(const Case& condition, const std::vector<GraspComparison>& pairs,
                    StudyResult& result) {
  std::vector<double> humanlikeness, duration;
  for (const GraspComparison& pair : pairs) {
    if (!pair.contacts.executable || !pair.fingertips.executable) continue;
    humanlikeness.push_back(pair.contacts.humanlikeness / pair.fingertips.humanlikeness);
    duration.push_back(pair.contacts.duration_s / pair.fingertips.duration_s);
  }
  if (humanlikeness.empty()) return;
  add_median_rows(condition, "A, ratio", "1", humanlikeness, kMaxHumanlikenessRatio, result);
  add_median_rows(condition, "duration, ratio", "1", duration, kMaxDurationRatio, result);
}

}  // namespace

void add_grasp_rows(const GraspStudyOptions& options, const Case& condition,
                    const std::vector<GraspComparison>& pairs, StudyResult& result) {
  const auto variant = [&](const std::string& name) {
    return case_with(condition, "variant", name);
  };
  const std::string &contacts = options.contacts.name, &fingertips = options.fingertips.name;
  add_variant_rows(variant(contacts), pairs, &GraspComparison::contacts, true, result);
  add_contact_rows(variant(contacts), pairs, result);
  add_variant_rows(variant(fingertips), pairs, &GraspComparison::fingertips, false, result);
  add_ratio_rows(variant(contacts + " over " + fingertips), pairs, result);
}

}  // namespace morphe::study
