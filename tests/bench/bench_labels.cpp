// Exchanges every two of the fourteen markers of an arm and its hand, in the whole recording and
// from a fifth, from half and from four fifths of it on, and counts those that the audit undoes
// exactly. Exchanges within a cluster of a recording without a static trial change nothing but
// names; they are counted apart if they are not reported. Also lists all reports about the
// recordings as they are.
//   bench_labels [--side R|L] [--without-static] FILE|FOLDER…
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "stages/import/audit/checks.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

struct Figures {
  int tried = 0, mended = 0, renamed = 0;
};

void exchange(MarkerStream& markers, std::size_t a, std::size_t b, std::size_t begin) {
  for (std::size_t i = begin; i < markers.time.size(); ++i)
    std::swap(markers.position(i, a), markers.position(i, b));
}

bool same(const Array2D<Vec3>& a, const Array2D<Vec3>& b) {
  return std::ranges::equal(a.values, b.values, [](const Vec3& p, const Vec3& q) {
    return is_known(p) == is_known(q) && (!is_known(p) || p == q);
  });
}

std::vector<std::size_t> arm_columns(const MarkerStream& markers, const std::string& side) {
  std::vector<std::size_t> columns;
  for (const char* part : {"UAR1", "UAR2", "UAR3", "UAR4", "LAR1", "LAR2", "LAR3", "LAR4", "HAN1",
                           "HAN2", "HAN3", "HAN4", "THUM", "FTP"}) {
    const auto name = std::ranges::find(markers.names, side + part);
    if (name != markers.names.end()) columns.push_back(name - markers.names.begin());
  }
  return columns;
}

void try_exchange(const Demonstration& truth, std::size_t a, std::size_t b, std::size_t begin,
                  Figures& figures) {
  Demonstration damaged = truth;
  exchange(*damaged.streams.markers, a, b, begin);
  const std::vector<Doubt> doubts = check_labels(damaged, {});
  for (const Doubt& doubt : doubts) {
    if (doubt.mend) doubt.mend(damaged);
  }
  ++figures.tried;
  if (same(damaged.streams.markers->position, truth.streams.markers->position)) {
    ++figures.mended;
    return;
  }
  const std::vector<std::string>& names = truth.streams.markers->names;
  if (doubts.empty() && begin == 0 && !truth.calibration.markers &&
      names[a].substr(0, 4) == names[b].substr(0, 4)) {
    ++figures.renamed;
    return;
  }
  fmt::print("  missed: {} and {} from frame {}\n", names[a], names[b], begin);
  for (const Doubt& doubt : doubts) fmt::print("    said: {}\n", doubt.flag.text);
}

void study(const Demonstration& recording, const std::string& side) {
  fmt::print("{}:\n", recording.name);
  for (const RecordingFlag& flag : recording.flags)  // of the import, which has mended them
    fmt::print("  as it is: {}\n", flag.text);
  if (!recording.streams.markers) return;
  const std::vector<std::size_t> columns = arm_columns(*recording.streams.markers, side);
  const std::size_t frames = recording.streams.markers->time.size();
  Figures whole, later;
  for (std::size_t a = 0; a < columns.size(); ++a) {
    for (std::size_t b = a + 1; b < columns.size(); ++b) {
      try_exchange(recording, columns[a], columns[b], 0, whole);
      for (const std::size_t tenths : {2, 5, 8})
        try_exchange(recording, columns[a], columns[b], frames * tenths / 10, later);
    }
  }
  fmt::print("  whole recording: {} of {} mended, {} mere names; from a time on: {} of {}\n",
             whole.mended, whole.tried, whole.renamed, later.mended, later.tried);
  std::fflush(stdout);
}

int run(int argc, char** argv) {
  CLI::App app{"exchanged labels"};
  std::string side = "R";
  bool without_static = false;
  std::vector<fs::path> paths;
  app.add_option("--side", side);
  app.add_flag("--without-static", without_static);
  app.add_option("paths", paths)->required();
  CLI11_PARSE(app, argc, argv);
  ImportRequest request;
  request.paths = paths;
  import_recordings(request, [&](Demonstration&& recording) {
    if (without_static) recording.calibration = {};
    study(recording, side);
  });
  return 0;
}

}  // namespace
}  // namespace morphe::imports

int main(int argc, char** argv) { return morphe::imports::run(argc, argv); }
