#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "stages/verify/verify.hpp"

namespace morphe::commands {

/// The verdict of `verify` on a plans.h5.
struct Verdict {
  std::map<std::string, std::string> rejected;  ///< first violation by plan; "" is the file itself
  std::string first_violation;                  ///< as one line; "" if the file is accepted
  std::size_t violations = 0;

  bool accepts_file() const { return violations == 0; }
  /// Returns the violation for which a plan cannot be trusted, which may be one of the whole file;
  /// "" if it can.
  std::string violation_of(const std::string& plan) const;
  /// Returns "is rejected by verify: N violations, the first: …", or "" if the file is accepted.
  std::string text() const;
};

/// The text for plans that are used with --unverified.
inline constexpr const char* kNotJudged = "was not verified (--unverified)";

/// Verifies a plans.h5 and notes it if it is accepted (accepted_files.hpp).
verify::VerifyReport verify_and_note(const std::filesystem::path& plans, int jobs);

/// Returns the verdict of `verify` on a plans.h5. A file that was accepted is not verified again by
/// the same program while its content is the same: the user's cache folder (accepted_files.hpp)
/// tells. Throws InputError if the file cannot be read.
Verdict verdict_on(const std::filesystem::path& plans, int jobs);

/// Returns why a plans.h5 that is handed on is not verified: "" if `verify` accepts it, kNotJudged,
/// without judging it, if `unverified`. Throws InputError "FILE: is rejected
/// by verify: …" otherwise.
std::string expect_verified(const std::filesystem::path& plans, bool unverified, int jobs);

}  // namespace morphe::commands
