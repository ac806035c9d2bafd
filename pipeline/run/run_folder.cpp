#include "pipeline/run/run_folder.hpp"

#include <system_error>

#include "pipeline/motion/input_error.hpp"

namespace morphe::run {

namespace fs = std::filesystem;

RunFolder::RunFolder(const fs::path& path, const std::string& software, const Shard& shard,
                     bool fresh)
    : folder_(path),
      journal_was_there_(fs::exists(path / Journal::kFile)),
      journal_(Journal::write(path, software, shard, fresh)) {}

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
