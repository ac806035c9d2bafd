#include <fmt/format.h>

#include "core/math/statistics.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/stream_report.hpp"
#include "core/parallel/for_each.hpp"
#include "pipeline/study/measure_seconds.hpp"
#include "pipeline/study/reconstruction_score.hpp"
#include "pipeline/study/score_recordings.hpp"
#include "pipeline/study/segmentation_score.hpp"
#include "pipeline/synthesize/synthesize.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::study {
namespace {

struct RecordingScore {
  SegmentationScore segmentation;
  ReconstructionScore reconstruction;
  double recorded_s = 0, synthesize_s = 0, rebuild_s = 0;
};

RecordingScore score_recording(const ScoreOptions& options,
                               const synthesize::SynthesizeOptions& synthetic,
                               const SyntheticSet& set, std::uint64_t index) {
  RecordingScore outcome;
  synthesize::SyntheticRecording recording;
  outcome.synthesize_s =
      measure_seconds([&] { recording = synthesize::synthesize(synthetic, set.seed, index); });
  HumanMotion motion;
  std::vector<Movement> movements;
  outcome.rebuild_s = measure_seconds([&] {
    motion = reconstruct::reconstruct(recording.recorded, options.reconstruct, options.human);
  });
  movements = segment::segment(motion, options.segment,
                               reconstruct::objects_on_side(recording.recorded, Side::right));
  outcome.recorded_s = longest_duration_s(report_streams(recording.recorded.streams));
  outcome.segmentation = score_segmentation(recording.recorded.labels, movements);
  if (set.score_positions) outcome.reconstruction = score_reconstruction(motion, recording.truth);
  return outcome;
}

RecordingScore score_set(const ScoreOptions& options, const SyntheticSet& set,
                         const StudyRun& run) {
  config::ConfigNode node = config::ConfigNode::load(options.folder / set.config);
  for (const std::string& setting : set.set) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) node.fail(fmt::format("set: '{}' contains no '='", setting));
    node.set(setting.substr(0, equals), setting.substr(equals + 1));
  }
  synthesize::SynthesizeOptions synthetic;
  config::read_document(node, synthetic);

  RecordingScore sum;
  parallel::ordered_for_each<RecordingScore>(
      run.quick ? set.quick_count : set.count, run.jobs,
      [&](std::uint64_t index) { return score_recording(options, synthetic, set, index); },
      [&](const RecordingScore& recording) {
        sum.segmentation.add(recording.segmentation);
        sum.reconstruction.add(recording.reconstruction);
        sum.recorded_s += recording.recorded_s;
        sum.synthesize_s += recording.synthesize_s;
        sum.rebuild_s += recording.rebuild_s;
      });
  return sum;
}

void add_accuracy(const Case& condition, const SyntheticSet& set, const ReconstructionScore& score,
                  StudyResult& result) {
  const auto add = [&](const char* metric, const MeanSquare& square, const char* unit,
                       double at_most = 0) {
    StudyRow& row = result.add(condition, metric, unit, square.rms(), square.n);
    if (at_most > 0) row.at_most = at_most;
  };
  add("shoulder, rms", score.shoulder, "m");
  add("elbow, rms", score.elbow, "m", set.max_joint_rms_m);
  add("wrist, rms", score.wrist, "m", set.max_joint_rms_m);
  add("fingertips, rms", score.tips, "m", set.max_fingertip_rms_m);
  add("fingertips in the hand (the glove's part), rms", score.tips_in_hand, "m");
  add("hand orientation, rms", score.orientation, "rad");
  add("arm angles, rms", score.arm_angles, "rad");
  add("hand angles, rms", score.hand_angles, "rad");
  add("index tip at rest, rms speed", score.speed_at_rest, "m/s");
  add("index tip at rest, true rms speed", score.true_speed_at_rest, "m/s");
  result.add(condition, "frames fully reconstructed", "1",
             score.seen / static_cast<double>(score.frames), score.frames);
  const std::ptrdiff_t delays = std::ssize(score.delay_s);
  result.add(condition, "delay, median", "s", math::quantile(score.delay_s, 0.5), delays);
  result.add(condition, "delay, 5th percentile", "s", math::quantile(score.delay_s, 0.05), delays);
  result.add(condition, "delay, 95th percentile", "s", math::quantile(score.delay_s, 0.95), delays);
  result.add(condition, "peak speed of reaches over the true value, median", "1",
             math::quantile(score.peak_ratio, 0.5), score.peak_ratio.size());
}

void add_boundaries(const Case& condition, const SyntheticSet& set, const SegmentationScore& score,
                    StudyResult& result) {
  for (const auto& [name, part] : score.error_s) {
    result.add(condition, name + ", median error", "s", math::quantile(part, 0.5), part.size());
    result.add(condition, name + ", 95th percentile", "s", math::quantile(part, 0.95), part.size());
  }
  const std::vector<double> errors = score.reach_errors_s();
  StudyRow& median = result.add(condition, "reach boundaries, median error", "s",
                                math::quantile(errors, 0.5), errors.size());
  if (set.max_median_error_s > 0) median.at_most = set.max_median_error_s;
  StudyRow& p95 = result.add(condition, "reach boundaries, 95th percentile", "s",
                             math::quantile(errors, 0.95), errors.size());
  if (set.max_p95_error_s > 0) p95.at_most = set.max_p95_error_s;
}

}  // namespace

void score_synthetic(const ScoreOptions& options, const SyntheticSet& set, const StudyRun& run,
                     StudyResult& result, Plot& errors) {
  const RecordingScore sum = score_set(options, set, run);
  const SegmentationScore& score = sum.segmentation;
  const Case condition = {{"set", set.name}};
  const double min_share = set.min_recall > 0 ? set.min_recall : kUnknown;
  result.add(condition, "movements, precision", "1", score.precision(), score.found).at_least =
      min_share;
  result.add(condition, "movements, recall", "1", score.recall(), score.labelled).at_least =
      min_share;
  add_boundaries(condition, set, score, result);
  if (set.score_positions) add_accuracy(condition, set, sum.reconstruction, result);
  result.add(condition, "synthesize, times real time", "1", sum.recorded_s / sum.synthesize_s, 1)
      .is_timing = true;
  result.add(condition, "reconstruction, times real time", "1", sum.recorded_s / sum.rebuild_s, 1)
      .is_timing = true;

  Plot::Line line{set.name, {}, {}};
  const std::vector<double> all = score.reach_errors_s();
  for (int percent = 0; percent <= 98; ++percent) {
    line.x.push_back(1000 * math::quantile(all, percent / 100.0));
    line.y.push_back(percent);
  }
  errors.lines.push_back(std::move(line));
  run.progress(fmt::format("{}: {} labelled, {} detected", set.name,
                           count_with_noun(score.labelled, "movement"), score.found));
}

}  // namespace morphe::study
