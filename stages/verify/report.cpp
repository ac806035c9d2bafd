#include <fmt/format.h>

#include <cmath>

#include "core/motion/count_with_noun.hpp"
#include "stages/verify/verify.hpp"

namespace morphe::verify {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// Formats lengths in mm and all other values in their stored unit.
std::string with_unit(double value, const std::string& unit) {
  if (unit == "m") return fmt::format("{:.6g} mm", 1000 * value);
  return fmt::format("{:.6g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string assumption_json(const Assumption& assumption, const std::string& plans) {
  return fmt::format("\n  {{\"kind\": {}, \"subject\": {}, \"value\": {}, \"plans\": {}}}",
                     quoted(std::string(name_of(assumption.kind))), quoted(assumption.subject),
                     quoted(assumption.value), plans);
}

std::string assumptions_json(const VerifyReport& report) {
  std::string out;
  const auto add = [&](const Assumption& assumption, const std::string& plans) {
    out += (out.empty() ? "" : ",") + assumption_json(assumption, plans);
  };
  for (const auto& [assumption, plans] : report.plan_assumptions.counted)
    add(assumption, fmt::format("{}", plans));
  for (const Assumption& assumption : report.assumptions) add(assumption, "null");
  return out;
}

/// Returns the lines on what was compared, and with what nothing was compared.
std::string compared_lines(const LookedAt& looked_at) {
  std::string with = "the file with its format", without;
  (looked_at.inputs ? with : without) += "; robot, config and plans with /inputs";
  (looked_at.recordings ? with : without) += "; plans with their recordings";
  if (!looked_at.recordings) without += " (--dataset F.h5)";
  std::string lines = fmt::format("  {:<13} {}\n", "compared", with);
  if (!without.empty()) lines += fmt::format("  {:<13} {}\n", "not compared", without.substr(2));
  return lines;
}

}  // namespace

std::string verify_json(const VerifyReport& report) {
  std::string out = fmt::format(
      "{{\"executable\": {}, \"approximate\": {}, \"partial\": {}, \"infeasible\": {}, "
      "\"violations\": [",
      report.executable, report.approximate, report.partial, report.infeasible);
  const char* separator = "";
  for (const Violation& v : report.violations) {
    out += fmt::format(
        "{}\n  {{\"plan\": {}, \"sample\": {}, \"time_s\": {}, \"cause\": {}, \"subject\": {}, "
        "\"value\": {}, \"limit\": {}, \"unit\": {}}}",
        separator, quoted(v.plan), v.sample, json_number(v.time_s), quoted(v.cause),
        quoted(v.subject), json_number(v.value), json_number(v.limit), quoted(v.unit));
    separator = ",";
  }
  out += report.violations.empty() ? "]" : "\n]";
  return out + fmt::format(
                   ", \"assumptions\": [{}], \"looked_at\": {{\"file\": true, \"curves\": true, "
                   "\"inputs\": {}, \"recordings\": {}}}}}\n",
                   assumptions_json(report), report.looked_at.inputs, report.looked_at.recordings);
}

std::string violation_text(const Violation& v) {
  const std::string place =
      v.sample < 0 ? "plan" : fmt::format("sample {} ({:.4f} s)", v.sample, v.time_s);
  std::string text = v.plan.empty()
                         ? fmt::format("file: {} {}", v.cause, v.subject)
                         : fmt::format("{}: {}: {} {}", v.plan, place, v.cause, v.subject);
  if (!std::isnan(v.limit))
    text += fmt::format(": {}, limit {}", with_unit(v.value, v.unit), with_unit(v.limit, v.unit));
  return text;
}

std::string verify_text(const VerifyReport& report) {
  std::string out;
  for (const Violation& v : report.violations) out += violation_text(v) + '\n';
  const std::string approximate =
      report.approximate > 0 ? fmt::format("{} approximate, ", report.approximate) : "";
  const std::string partial = report.partial > 0 ? fmt::format("{} partial, ", report.partial) : "";
  const int plans = report.executable + report.approximate + report.partial;
  out += fmt::format("  {:<13} {}\n", "certified",
                     "limits, collisions and tracking of the stored curves, recomputed "
                     "(docs/certificate.md)");
  out += compared_lines(report.looked_at);
  out += subject_lines(report.assumptions, report.plan_assumptions, plans);
  return fmt::format("{}{} executable, {}{}{} infeasible, {}\n", out, report.executable,
                     approximate, partial, report.infeasible,
                     count_with_noun(report.violations.size(), "violation"));
}

}  // namespace morphe::verify
