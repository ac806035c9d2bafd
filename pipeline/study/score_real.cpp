#include <fmt/format.h>

#include <algorithm>

#include "core/math/statistics.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/stream_report.hpp"
#include "pipeline/study/angle_files.hpp"
#include "pipeline/study/measure_seconds.hpp"
#include "pipeline/study/score_recordings.hpp"
#include "pipeline/study/segmentation_score.hpp"
#include "stages/import/import.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::study {
namespace {

/// Plots the speed of the index tip with the phases found, for visual inspection.
Plot speed_plot(const std::string& name, const HumanMotion& motion,
                const std::vector<Movement>& movements) {
  Plot plot;
  plot.title = name;
  plot.x_label = "time [s]";
  plot.y_label = "speed [m/s]";
  Plot::Line tip{"index tip", {}, {}}, wrist{"wrist", {}, {}};
  for (std::size_t i = 1; i < motion.time.size(); ++i) {
    const double step_s = motion.time[i] - motion.time[i - 1];
    tip.x.push_back(motion.time[i]);
    tip.y.push_back((motion.tip(i, kIndex) - motion.tip(i - 1, kIndex)).norm() / step_s);
    wrist.x.push_back(motion.time[i]);
    wrist.y.push_back((motion.wrist[i] - motion.wrist[i - 1]).norm() / step_s);
  }
  plot.lines = {std::move(tip), std::move(wrist)};
  for (const Movement& movement : movements) {
    for (const Phase& phase : movement.phases) {
      if (phase.kind != PhaseKind::preshape)
        plot.bands.push_back({std::string(name_of(phase.kind)), phase.begin_s, phase.end_s});
    }
  }
  return plot;
}

bool overlaps_reach(const Label& label, const std::vector<Movement>& movements) {
  return std::ranges::any_of(movements, [&](const Movement& movement) {
    return std::ranges::any_of(movement.phases, [&](const Phase& phase) {
      return phase.kind == PhaseKind::reach && phase.begin_s < label.end_s &&
             phase.end_s > label.begin_s;
    });
  });
}

}  // namespace

void score_real(const ScoreOptions& options, const RealSet& set, const StudyRun& run,
                StudyResult& result) {
  imports::ImportRequest request;
  request.paths = {options.folder / set.manifest};
  // Angle files of other software refer to the axes of their laboratory.
  if (!set.reference_angles.empty()) request.conventions.forward = imports::ForwardSource::recorded;
  SegmentationScore all;
  std::size_t labelled = 0, overlapped = 0, recordings = 0;
  double recorded_s = 0, rebuild_s = 0;
  const double total_s = measure_seconds([&] {
    imports::import_recordings(request, [&](Demonstration&& demonstration) {
      ++recordings;
      recorded_s += longest_duration_s(report_streams(demonstration.streams));
      HumanMotion motion;
      std::vector<Movement> movements;
      rebuild_s += measure_seconds([&] {
        motion = reconstruct::reconstruct(demonstration, options.reconstruct, options.human);
        movements = segment::segment(motion, options.segment,
                                     reconstruct::objects_on_side(demonstration, Side::right));
      });
      const Case of = {{"set", set.name}, {"recording", demonstration.name}};
      for (const StreamReport& stream : report_streams(demonstration.streams)) {
        const auto row = [&](const char* what, const char* unit, double value) {
          result.rows.push_back(
              make_row(of, fmt::format("{}, {}", stream.name, what), unit, value, stream.columns));
        };
        row("duration", "s", stream.duration_s);
        row("rate", "Hz", stream.rate_hz);
        row("valid share", "1", stream.valid_share);
      }
      StudyRow found =
          make_row(of, "detected movements", "1", static_cast<double>(movements.size()), 1);
      const SegmentationScore score = score_segmentation(demonstration.labels, movements);
      if (score.labelled > 0) {
        found.at_least = found.at_most = static_cast<double>(score.labelled);
      }
      result.rows.push_back(found);
      for (const Label& label : demonstration.labels) {
        if (label.phase != PhaseKind::reach) continue;
        ++labelled;
        overlapped += overlaps_reach(label, movements) ? 1 : 0;
      }
      all.add(score);
      for (const AngleFile& file : set.reference_angles) {
        if (file.recording != demonstration.name) continue;
        for (const AngleAgreement& angle : compare_with_angle_file(
                 demonstration, motion, options.reconstruct, options.folder / file.file)) {
          StudyRow correlation =
              make_row(of, angle.angle + ", correlation", "1", angle.correlation, angle.n);
          StudyRow rms =
              make_row(of, angle.angle + ", rms without offset", "rad", angle.rms_rad, angle.n);
          if (angle.angle == "elbow flexion") {
            correlation.at_least = 0.99;
            rms.at_most = 0.0698;  // 4 degrees
          }
          result.rows.push_back(correlation);
          result.rows.push_back(rms);
        }
      }
      result.plots.emplace_back(demonstration.name,
                                speed_plot(demonstration.name, motion, movements));
    });
  });
  const Case of = {{"set", set.name}};
  if (labelled > 0) {
    StudyRow row =
        make_row(of, "labelled reaches detected", "1", static_cast<double>(overlapped), labelled);
    row.at_least = static_cast<double>(labelled);
    result.rows.push_back(row);
  }
  if (set.same_boundaries) {
    std::vector<double> errors;
    for (const char* which : {"reach begin", "reach end"}) {
      const std::vector<double>& part = all.error_s[which];
      errors.insert(errors.end(), part.begin(), part.end());
      result.rows.push_back(make_row(of, fmt::format("{}, largest error", which), "s",
                                     math::quantile(part, 1), part.size()));
      result.rows.back().at_most = 0.1;
    }
    result.rows.push_back(make_row(of, "reach boundaries, median error", "s",
                                   math::quantile(errors, 0.5), errors.size()));
    result.rows.back().at_most = 0.04;
  }
  StudyRow import =
      make_row(of, "import, times real time", "1", recorded_s / (total_s - rebuild_s), recordings);
  StudyRow rebuild = make_row(of, "reconstruction and segmentation, times real time", "1",
                              recorded_s / rebuild_s, recordings);
  import.is_timing = rebuild.is_timing = true;
  result.rows.push_back(import);
  result.rows.push_back(rebuild);
  run.progress(fmt::format("{}: {}", set.name, count_with_noun(recordings, "recording")));
}

}  // namespace morphe::study
