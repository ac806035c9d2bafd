#include "core/motion/finding_text.hpp"

#include <fmt/format.h>

#include "core/motion/interval_text.hpp"

namespace morphe {
namespace {

std::string subject_of(const Finding& finding) {
  const bool joint = finding.cause == Cause::joint_limit || finding.cause == Cause::jump;
  return (joint ? "joint " : "") + finding.subject;
}

std::string excess_of(const Finding& finding) {
  const std::string excess = amount_text(finding.excess, finding.unit);
  switch (finding.cause) {
    case Cause::joint_limit:
      return excess + " beyond its limit";
    case Cause::jump:
      return excess + " beyond the largest allowed step";
    case Cause::tracking:
      return excess + " beyond its tolerance";
    case Cause::object_collision:
    case Cause::self_collision:
    case Cause::table:
      break;
  }
  return excess + (finding.limit < 0 ? " too deep in " : " too close to ") + finding.other_body;
}

}  // namespace

std::string amount_text(double amount, FindingUnit unit) {
  if (unit == FindingUnit::radian) {
    const double degrees = amount / kRadPerDegree;
    return degrees < 0.1 ? fmt::format("{:.2g} degrees", degrees)
                         : fmt::format("{:.2f} degrees", degrees);
  }
  const double mm = kMillimetresPerMetre * amount;
  return mm < 0.1 ? fmt::format("{:.2g} mm", mm) : fmt::format("{:.1f} mm", mm);
}

std::string excess_text(const Finding& finding) {
  return subject_of(finding) + " " + excess_of(finding);
}

std::string sentence(const Finding& finding) {
  return fmt::format("{} is {}, {}", subject_of(finding), excess_of(finding),
                     interval_text(finding.begin_s, finding.end_s));
}

}  // namespace morphe
