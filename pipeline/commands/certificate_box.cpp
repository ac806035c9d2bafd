#include "pipeline/commands/certificate_box.hpp"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "core/motion/count_with_noun.hpp"
#include "pipeline/commands/text_table.hpp"

namespace morphe::commands {
namespace {

/// Wraps lines that are indented by two spaces.
std::string wrapped(const std::string& lines, std::size_t width) {
  std::istringstream stream(lines);
  std::string text, line;
  while (std::getline(stream, line)) text += wrap_line(line.substr(2), width, "  ");
  return text;
}

}  // namespace

void CertificateBox::add(const PlanRow& row) {
  if (row.status == name_of(Status::infeasible) || row.status == kNotVerified) return;
  ++plans;
  tally.add(row.assumptions);
  for (const KindClearance& each : row.clearances) {
    const auto k = static_cast<std::size_t>(each.kind);
    if (each.clearance >= least[k].clearance) continue;
    least[k] = each;
    plan_of_least[k] = row.name;
  }
}

std::string CertificateBox::text(const std::vector<Assumption>& of_file, std::size_t width) const {
  if (plans == 0) return "";
  std::string clearances;
  for (int k = 0; k < kClearanceKindCount; ++k) {
    if (std::isnan(least[k].clearance)) continue;
    clearances += fmt::format(
        "{}{} {:.2f} mm ({} and {}, {} at {:.2f} s)",
        clearances.empty() ? "; least clearances: " : ", ", name_of(least[k].kind),
        1e3 * least[k].clearance, least[k].first, least[k].second,
        width == 0 ? plan_of_least[k] : shorten(plan_of_least[k], width / 3), least[k].time_s);
  }
  const std::string certified =
      fmt::format("  {:<13} limits, collisions and tracking of {}{}\n", "certified",
                  count_with_noun(static_cast<std::size_t>(plans), "plan"), clearances);
  return wrap_line(
             "certificate (docs/certificate.md; `morphe explain FILE PLAN` gives the values):",
             width, "") +
         wrapped(certified + subject_lines(of_file, tally, plans), width);
}

}  // namespace morphe::commands
