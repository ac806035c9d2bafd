#include "pipeline/run/merge.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/resource.h>

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>

#include "core/motion/counted.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"
#include "pipeline/run/config_changes.hpp"
#include "pipeline/run/journal.hpp"
#include "pipeline/run/plans_print.hpp"
#include "pipeline/run/write_plans.hpp"

namespace morphe::run {
namespace {

namespace fs = std::filesystem;

struct OpenShard {
  fs::path folder;
  std::unique_ptr<Journal> journal;
  Shard shard;
};

/// Every shard is one open file; the usual limit of a shell is 1024.
void allow_many_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

/// How a shard differs from the first, "" if it belongs to the same run.
std::string difference(const RunIdentity& first, const RunIdentity& other) {
  if (other.shard.count != first.shard.count)
    return fmt::format("is shard {} of another division, not one of {}", shard_text(other.shard),
                       first.shard.count);
  if (other.software != first.software)
    return fmt::format("was written by {}, not {}", other.software, first.software);
  if (other.program != first.program) return "was written by another build of morphe";
  if (other.header.config != first.header.config)
    return fmt::format("is of another config: {}",
                       fmt::join(config_changes(first.header.config, other.header.config), ", "));
  if (other.header.dataset_sha256 != first.header.dataset_sha256) return "is of another dataset";
  if (other.scene != first.scene) return "is of another scene";
  if (store::bytes_of(other.robot) != store::bytes_of(first.robot)) return "is of another robot";
  if (store::bytes_of(other.header) != store::bytes_of(first.header))
    return "is of configs that differ in their text";
  return "";
}

class Complaints {
 public:
  void add(const std::string& complaint) { list_.push_back(complaint); }
  void raise() const {
    if (!list_.empty()) throw InputError(fmt::format("merge: {}", fmt::join(list_, "; ")));
  }

 private:
  std::vector<std::string> list_;
};

/// Those that are there belong to `first` and are finished; none is missing or there twice.
void check(const std::vector<OpenShard>& shards, const RunIdentity& first) {
  Complaints complaints;
  std::map<int, fs::path> found;
  for (const OpenShard& shard : shards) {
    const std::string name = shard.folder.string();
    const RunIdentity identity = shard.journal->identity();
    if (identity.header.software.empty()) {
      complaints.add(fmt::format("{}: shard {} never began", name, shard_text(shard.shard)));
    } else if (const std::string wrong = difference(first, identity); !wrong.empty()) {
      complaints.add(fmt::format("{}: {}", name, wrong));
      continue;
    } else if (const std::int64_t left = shard.journal->unfinished();
               left > 0 || !shard.journal->is_complete()) {
      complaints.add(fmt::format("{}: shard {} is not finished: {} of {} are left", name,
                                 shard_text(shard.shard), left,
                                 counted(shard.journal->wanted(), "demonstration")));
    }
    shard.journal->wanted();  // or it says that some are missing
    const auto [place, is_new] = found.emplace(shard.shard.index, shard.folder);
    if (!is_new)
      complaints.add(fmt::format("{}: shard {} is there twice, in {} too", name,
                                 shard_text(shard.shard), place->second.string()));
  }
  std::vector<int> missing;
  for (int i = 1; i <= first.shard.count; ++i)
    if (!found.contains(i)) missing.push_back(i);
  if (!missing.empty())
    complaints.add(
        fmt::format("missing of {} shards: {}", first.shard.count, fmt::join(missing, ", ")));
  complaints.raise();
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

/// The demonstrations of all shards in the order of the dataset, each exactly once.
void in_order(std::vector<OpenShard>& shards, std::int64_t count,
              const std::function<void(Journal&, const std::string&)>& visit) {
  using Head = std::pair<std::int64_t, std::size_t>;  // position, shard
  std::vector<std::string> names(shards.size());
  std::priority_queue<Head, std::vector<Head>, std::greater<>> heads;
  const auto advance = [&](std::size_t i) {
    const std::optional<DatasetEntry> place = shards[i].journal->next();
    if (!place) return;
    names[i] = place->name;
    heads.emplace(place->position, i);
  };
  for (std::size_t i = 0; i < shards.size(); ++i) advance(i);
  for (std::int64_t expected = 0; expected < count; ++expected) {
    if (heads.empty() || heads.top().first != expected)
      throw InputError(fmt::format(
          "merge: demonstration {} of the dataset is in no shard, or in two", expected + 1));
    const std::size_t i = heads.top().second;
    heads.pop();
    visit(*shards[i].journal, names[i]);
    advance(i);
  }
}

}  // namespace

BatchSummary merge_shards(const std::vector<fs::path>& folders, const fs::path& plans) {
  allow_many_files();
  std::vector<OpenShard> shards = open_all(folders);
  if (shards.empty()) throw InputError("merge: no shards");
  // One that never began says nothing of the run.
  RunIdentity first;
  for (std::size_t i = 0; i < shards.size() && first.header.software.empty(); ++i)
    first = shards[i].journal->identity();
  check(shards, first);
  if (fs::exists(plans) && plans_print(plans) != plans_print(first.header))
    throw InputError(
        fmt::format("{}: is of another run, and would be replaced: move it away, or "
                    "give another --out",
                    plans.string()));
  store::PlanWriter writer(plans, first.header, first.robot);
  in_order(shards, first.demonstrations,
           [&](Journal& journal, const std::string& name) { write_plans(journal, name, writer); });
  writer.finish();
  BatchSummary summary;
  for (const OpenShard& shard : shards) add(shard.journal->summary(), summary);
  return summary;
}

}  // namespace morphe::run
