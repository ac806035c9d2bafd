#include "pipeline/commands/verdict.hpp"

#include <fmt/format.h>

#include "core/files/sha256.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/commands/accepted_files.hpp"
#include "pipeline/planning/plan_requirements.hpp"

namespace morphe::commands {
namespace {

/// Returns the hash of a file's content, or "" for what may have no end, a pipe or a device, and is
/// refused where it is read.
std::string content_hash(const std::filesystem::path& file) {
  return std::filesystem::is_regular_file(file) ? files::sha256_of_file(file) : "";
}

}  // namespace

std::string Verdict::violation_of(const std::string& plan) const {
  for (const std::string& name : {plan, std::string()})
    if (const auto found = rejected.find(name); found != rejected.end()) return found->second;
  return "";
}

std::string Verdict::text() const {
  return accepts_file() ? ""
                        : fmt::format("is rejected by verify: {}, the first: {}",
                                      count_with_noun(violations, "violation"), first_violation);
}

verify::VerifyReport verify_and_note(const std::filesystem::path& plans, int jobs) {
  const std::string sha256 = content_hash(plans);
  verify::VerifyReport report = verify::verify_file(plans, planning::plan_requirements, jobs);
  // A file that was replaced meanwhile may not be the one that was judged.
  if (report.violations.empty() && content_hash(plans) == sha256) note_accepted(sha256);
  return report;
}

Verdict verdict_on(const std::filesystem::path& plans, int jobs) {
  Verdict verdict;
  if (is_known_accepted(content_hash(plans))) return verdict;
  const verify::VerifyReport report = verify_and_note(plans, jobs);
  verdict.violations = report.violations.size();
  for (const verify::Violation& violation : report.violations)
    verdict.rejected.emplace(violation.plan, verify::violation_text(violation));
  if (!verdict.accepts_file())
    verdict.first_violation = verify::violation_text(report.violations.front());
  return verdict;
}

std::string expect_verified(const std::filesystem::path& plans, bool unverified, int jobs) {
  if (unverified) return kNotJudged;
  const Verdict verdict = verdict_on(plans, jobs);
  if (verdict.accepts_file()) return "";
  throw InputError(
      fmt::format("{}: {}; plan again, or give --unverified to use it all "
                  "the same, marked as not verified",
                  plans.string(), verdict.text()));
}

}  // namespace morphe::commands
