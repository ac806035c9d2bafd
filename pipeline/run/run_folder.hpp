#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "pipeline/run/journal.hpp"
#include "pipeline/run/output_folder.hpp"

namespace morphe::run {

/// The folder of a run with its journal, held by this process alone. The destructor removes the
/// files and folders that were created, unless the journal has a result or keep() was called.
class RunFolder {
 public:
  RunFolder(const std::filesystem::path& path, const std::string& software, const Shard& shard,
            bool fresh);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return folder_.path(); }
  Journal& journal() { return *journal_; }
  void keep() { kept_ = true; }
  /// Throws InputError if there is a plans.h5 that does not belong to the journal of this folder,
  /// for example one written by a merge or copied by the user, because a run would replace it.
  void expect_own_plans() const;

 private:
  bool has_finished_results() const;

  OutputFolder folder_;
  bool journal_was_there_, fresh_, kept_ = false;
  std::unique_ptr<Journal> journal_;
};

}  // namespace morphe::run
