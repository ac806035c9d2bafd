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
  for (int i = 1; i < std::ssize(motion.time); ++i) {
    const double step_s = motion.time[i] - motion.time[i - 1];
    tip.x.push_back(motion.time[i]);
    tip.y.push_back((motion.tip(i, kIndex) - motion.tip(i - 1, kIndex)).norm() / step_s);
    wrist.x.push_back(motion.time[i]);
    wrist.y.push_back((motion.wrist[i] - motion.wrist[i - 1]).norm() / step_s);
  }
  plot.lines = {std::move(tip), std::move(wrist)};
  for (const Movement& movement : movements) {
    for (const Phase& phase : movement.phases) {
      if (phase.kind != PhaseKind::preshape && main_phase_of(phase.kind) == phase.kind)
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
  int labelled = 0, detected = 0, recordings = 0;
  double recorded_s = 0, reconstruct_s = 0;
  const double total_s = measure_seconds([&] {
    imports::import_recordings(request, [&](Demonstration&& demonstration) {
      ++recordings;
      recorded_s += longest_duration_s(report_streams(demonstration.streams));
      HumanMotion motion;
      std::vector<Movement> movements;
      reconstruct_s += measure_seconds([&] {
        motion = reconstruct::reconstruct(demonstration, options.reconstruct, options.human);
        movements = segment::segment(motion, options.segment,
                                     reconstruct::objects_on_side(demonstration, Side::right),
                                     demonstration.task);
      });
      const Case condition = {{"set", set.name}, {"recording", demonstration.name}};
      for (const StreamReport& stream : report_streams(demonstration.streams)) {
        const auto row = [&](const char* quantity, const char* unit, double value) {
          result.add(condition, fmt::format("{}, {}", stream.name, quantity), unit, value,
                     stream.columns);
        };
        row("duration", "s", stream.duration_s);
        row("rate", "Hz", stream.rate_hz);
        row("valid share", "1", stream.valid_share);
      }
      const SegmentationScore score = score_segmentation(demonstration.labels, movements);
      StudyRow& movement_count = result.add(condition, "detected movements", "1", score.found, 1);
      if (score.labelled > 0) movement_count.at_least = movement_count.at_most = score.labelled;
      for (const Label& label : demonstration.labels) {
        if (label.phase != PhaseKind::reach) continue;
        ++labelled;
        detected += overlaps_reach(label, movements) ? 1 : 0;
      }
      all.add(score);
      for (const AngleFile& file : set.reference_angles) {
        if (file.recording != demonstration.name) continue;
        for (const AngleAgreement& angle : compare_with_angle_file(
                 demonstration, motion, options.reconstruct, options.folder / file.file)) {
          const bool elbow = angle.angle == "elbow flexion";
          StudyRow& correlation =
              result.add(condition, angle.angle + ", correlation", "1", angle.correlation, angle.n);
          if (elbow) correlation.at_least = 0.99;
          StudyRow& rms = result.add(condition, angle.angle + ", rms without offset", "rad",
                                     angle.rms_rad, angle.n);
          if (elbow) rms.at_most = 0.0698;  // 4 degrees
        }
      }
      result.plots.emplace_back(demonstration.name,
                                speed_plot(demonstration.name, motion, movements));
    });
  });
  const Case condition = {{"set", set.name}};
  if (labelled > 0)
    result.add(condition, "labelled reaches detected", "1", detected, labelled).at_least = labelled;
  if (set.same_boundaries) {
    for (const char* boundary : {"reach begin", "reach end"}) {
      const std::vector<double>& part = all.error_s[boundary];
      result
          .add(condition, fmt::format("{}, largest error", boundary), "s", math::quantile(part, 1),
               part.size())
          .at_most = 0.1;
    }
    const std::vector<double> errors = all.reach_errors_s();
    result
        .add(condition, "reach boundaries, median error", "s", math::quantile(errors, 0.5),
             errors.size())
        .at_most = 0.04;
  }
  const auto add_speed = [&](const char* step, double step_s) {
    result
        .add(condition, fmt::format("{}, times real time", step), "1", recorded_s / step_s,
             recordings)
        .is_timing = true;
  };
  add_speed("import", total_s - reconstruct_s);
  add_speed("reconstruction and segmentation", reconstruct_s);
  run.progress(fmt::format("{}: {}", set.name, count_with_noun(recordings, "recording")));
}

}  // namespace morphe::study
