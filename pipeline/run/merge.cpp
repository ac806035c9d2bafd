#include "pipeline/run/merge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <functional>
#include <map>
#include <queue>
#include <utility>

#include "core/motion/count_with_noun.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"
#include "pipeline/run/config_changes.hpp"
#include "pipeline/run/journal.hpp"
#include "pipeline/run/plans_fingerprint.hpp"
#include "pipeline/run/write_plans.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;

struct OpenShard {
  fs::path folder;
  std::unique_ptr<Journal> journal;
  Shard shard;
};

/// Raises the limit of open files, usually 1024: every shard is one.
void raise_open_file_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

/// Returns the first difference of a shard from the first one, "" if both belong to the same run.
std::string difference(const RunIdentity& first, const RunIdentity& other) {
  if (other.shard.count != first.shard.count)
    return fmt::format("is shard {}, but the run has {} shards", shard_text(other.shard),
                       first.shard.count);
  if (other.software != first.software)
    return fmt::format("was written by {}, not {}", other.software, first.software);
  if (other.program != first.program) return "was written by another build of morphe";
  if (other.header.config != first.header.config)
    return fmt::format("has another config: {}",
                       fmt::join(config_changes(first.header.config, other.header.config), ", "));
  if (other.header.dataset_sha256 != first.header.dataset_sha256) return "has another dataset";
  if (other.scene != first.scene) return "has another scene";
  if (store::bytes_of(other.robot) != store::bytes_of(first.robot)) return "has another robot";
  if (store::bytes_of(other.header) != store::bytes_of(first.header))
    return "has configs with different text";
  return "";
}

/// Checks that all shards belong to the run of `first`, are finished, and are present exactly once.
void check(const std::vector<OpenShard>& shards, const RunIdentity& first) {
  std::vector<std::string> errors;
  std::map<int, fs::path> found;
  for (const OpenShard& shard : shards) {
    const std::string name = shard.folder.string();
    const RunIdentity identity = shard.journal->identity();
    if (identity.header.software.empty()) {
      errors.push_back(
          fmt::format("{}: shard {} was never started", name, shard_text(shard.shard)));
    } else if (const std::string other_run = difference(first, identity); !other_run.empty()) {
      errors.push_back(fmt::format("{}: {}", name, other_run));
      continue;
    } else if (const std::int64_t left = shard.journal->unfinished_count();
               left > 0 || !shard.journal->is_complete()) {
      errors.push_back(
          fmt::format("{}: shard {} is not finished: {} of {} left", name, shard_text(shard.shard),
                      left, count_with_noun(shard.journal->scheduled_count(), "demonstration")));
    }
    shard.journal->scheduled_count();  // throws if entries are missing
    const auto [place, is_new] = found.emplace(shard.shard.index, shard.folder);
    if (!is_new)
      errors.push_back(fmt::format("{}: shard {} was given twice, also as {}", name,
                                   shard_text(shard.shard), place->second.string()));
  }
  std::vector<int> missing;
  for (int i = 1; i <= first.shard.count; ++i)
    if (!found.contains(i)) missing.push_back(i);
  if (!missing.empty())
    errors.push_back(
        fmt::format("missing of {} shards: {}", first.shard.count, fmt::join(missing, ", ")));
  if (!errors.empty()) throw InputError(fmt::format("merge: {}", fmt::join(errors, "; ")));
}

std::vector<OpenShard> open_all(const std::vector<fs::path>& folders) {
  std::vector<OpenShard> shards;
  for (const fs::path& folder : folders) {
    OpenShard shard{folder, Journal::read(folder), {}};
    shard.shard = shard.journal->identity().shard;
    shards.push_back(std::move(shard));
  }
  return shards;
}

/// Visits the demonstrations of all shards in the order of the dataset, each exactly once.
void visit_in_dataset_order(std::vector<OpenShard>& shards, std::int64_t count,
                            const std::function<void(Journal&, const std::string&)>& visit) {
  using Head = std::pair<std::int64_t, int>;  // position, shard
  std::vector<std::string> names(shards.size());
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads;
  const auto advance = [&](int i) {
    const std::optional<DatasetEntry> entry = shards[i].journal->next();
    if (!entry) return;
    names[i] = entry->name;
    heads.emplace(entry->position, i);
  };
  for (int i = 0; i < std::ssize(shards); ++i) advance(i);
  for (std::int64_t expected = 0; expected < count; ++expected) {
    if (heads.empty() || heads.top().first != expected)
      throw InputError(
          fmt::format("merge: demonstration {} of the dataset is in none of the shards, or in two",
                      expected + 1));
    const int i = heads.top().second;
    heads.pop();
    visit(*shards[i].journal, names[i]);
    advance(i);
  }
}

}  // namespace

BatchSummary merge_shards(const std::vector<fs::path>& folders, const fs::path& plans) {
  raise_open_file_limit();
  std::vector<OpenShard> shards = open_all(folders);
  if (shards.empty()) throw InputError("merge: no shards");
  // A shard that never began does not identify the run.
  RunIdentity first;
  for (const OpenShard& shard : shards)
    if (first.header.software.empty()) first = shard.journal->identity();
  check(shards, first);
  if (fs::exists(plans) && plans_fingerprint(plans) != plans_fingerprint(first.header))
    throw InputError(
        fmt::format("{}: belongs to another run and would be replaced: move it elsewhere, or give "
                    "another --out",
                    plans.string()));
  store::PlanWriter writer(plans, first.header, first.robot);
  visit_in_dataset_order(
      shards, first.demonstrations,
      [&](Journal& journal, const std::string& name) { write_plans(journal, name, writer); });
  writer.finish();
  BatchSummary summary;
  for (const OpenShard& shard : shards) add(shard.journal->summary(), summary);
  return summary;
}

}  // namespace morphe::run
