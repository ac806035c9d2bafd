#include "pipeline/run/run_folder.hpp"

#include <fmt/format.h>

#include <system_error>

#include "pipeline/motion/input_error.hpp"
#include "pipeline/store/hdf5_signature.hpp"

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
  if (fresh_ || journal_was_there_ || !store::has_hdf5_signature(plans)) return;
  throw InputError(
      fmt::format("{}: is there without the journal of its run, and would be replaced: give "
                  "another --out, or --fresh to replace it",
                  plans.string()));
}

RunFolder::~RunFolder() {
  const bool keep = kept_ || something_is_finished();
  journal_.reset();
  if (keep) folder_.keep();
  std::error_code ignored;
  if (keep || journal_was_there_) return;
  fs::remove(folder_.path() / Journal::kFile, ignored);
  fs::remove(folder_.path() / (std::string(Journal::kFile) + "-wal"), ignored);
}

bool RunFolder::something_is_finished() const {
  try {
    return journal_->has_results();
  } catch (const InputError&) {
    return true;  // it cannot be told
  }
}

}  // namespace morphe::run
