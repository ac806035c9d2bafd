#include "core/motion/stream_report.hpp"
#include "stages/import/folders/read_recording.hpp"
#include "stages/import/folders/recording_formats.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "targets.hpp"

namespace morphe::fuzz {
namespace {

/// Longer ones are worked on as well, but take their time.
constexpr double kLongest_s = 20;

Target target_of(const std::string& format) {
  return {"import-" + format,
          [format](std::string_view bytes) {
            imports::ManifestEntry entry;
            entry.file = as_file(bytes, "recording").string();
            entry.format = format;
            entry.name = "a";
            entry.conventions.axes = "x y z";
            entry.conventions.unit = "m";
            entry.conventions.rate_hz = 100;
            const Demonstration read = imports::read_recording(entry);
            const double length_s = longest_duration_s(report_streams(read.streams));
            if (length_s < kLongest_s &&
                longest_duration_s(report_streams(read.calibration)) < kLongest_s)
              reconstruct::reconstruct(read, {}, {});
          },
          format == "egodex-hdf5"};
}

}  // namespace

std::vector<Target> recording_targets() {
  std::vector<Target> targets;
  for (const imports::RecordingFormat& format : imports::recording_formats())
    targets.push_back(target_of(format.name));
  return targets;
}

}  // namespace morphe::fuzz
