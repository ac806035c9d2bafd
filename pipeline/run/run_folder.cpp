#include "pipeline/run/run_folder.hpp"

#include <fmt/format.h>

#include <system_error>

#include "core/motion/input_error.hpp"
#include "pipeline/run/plans_fingerprint.hpp"

namespace morphe::run {

namespace fs = std::filesystem;

RunFolder::RunFolder(const fs::path& path, const std::string& software, const Shard& shard,
                     bool fresh)
    : folder_(path),
      journal_was_there_(fs::exists(path / Journal::kFile)),
      fresh_(fresh),
      journal_(Journal::write(path, software, shard, fresh)) {}

void RunFolder::expect_own_plans() const {
  const fs::path plans = folder_.path() / "plans.h5";
  if (fresh_ || !fs::exists(plans)) return;
  if (journal_was_there_ && journal_->owns_plans(plans_fingerprint(plans))) return;
  throw InputError(
      fmt::format("{}: was not written by the run of this folder and would be replaced: move it "
                  "elsewhere, give another --out, or --fresh to replace it",
                  plans.string()));
}

RunFolder::~RunFolder() {
  const bool keep = kept_ || has_finished_results();
  std::error_code ignored;
  // The files are removed while the lock is held, so no other process has opened them.
  if (!keep && !journal_was_there_) {
    fs::remove(folder_.path() / Journal::kFile, ignored);
    fs::remove(folder_.path() / (std::string(Journal::kFile) + "-wal"), ignored);
  }
  journal_.reset();
  if (keep) folder_.keep();
}

bool RunFolder::has_finished_results() const {
  try {
    return journal_->has_results();
  } catch (const InputError&) {
    return true;  // unknown, so the folder is kept
  }
}

}  // namespace morphe::run
