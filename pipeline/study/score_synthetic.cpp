#include <fmt/format.h>

#include <memory>

#include "core/math/statistics.hpp"
#include "core/motion/count_with_noun.hpp"
#include "core/motion/stream_report.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "pipeline/study/measure_seconds.hpp"
#include "pipeline/study/reconstruction_score.hpp"
#include "pipeline/study/score_recordings.hpp"
#include "pipeline/study/segmentation_score.hpp"
#include "pipeline/synthesize/synthesize.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::study {
namespace {

/// The scores of one synthetic recording.
struct RecordingScore {
  SegmentationScore segmentation;
  ReconstructionScore reconstruction;
  double recorded_s = 0, synthesize_s = 0, rebuild_s = 0;
};

RecordingScore score_recording(const ScoreOptions& options,
                               const synthesize::SynthesizeOptions& synthetic,
                               const SyntheticSet& set, std::size_t index) {
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

  const auto count = static_cast<std::size_t>(run.quick ? set.quick_count : set.count);
  RecordingScore sum;
  parallel::OrderedParallelMap<std::size_t, RecordingScore> map;
  map.next = [&, next = std::size_t{0}]() mutable {
    return next == count ? nullptr : std::make_unique<std::size_t>(next++);
  };
  map.work = [&](const std::size_t& index) {
    return std::make_unique<RecordingScore>(score_recording(options, synthetic, set, index));
  };
  map.write = [&](const RecordingScore& one) {
    sum.segmentation.add(one.segmentation);
    sum.reconstruction.add(one.reconstruction);
    sum.recorded_s += one.recorded_s;
    sum.synthesize_s += one.synthesize_s;
    sum.rebuild_s += one.rebuild_s;
  };
  morphe::parallel::run(map, run.jobs);
  return sum;
}

void add_accuracy(const Case& of, const SyntheticSet& set, const ReconstructionScore& score,
                  StudyResult& result) {
  const auto add = [&](const char* metric, const MeanSquare& square, const char* unit,
                       double at_most = 0) {
    result.rows.push_back(make_row(of, metric, unit, square.rms(), square.n));
    if (at_most > 0) result.rows.back().at_most = at_most;
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
  result.rows.push_back(
      make_row(of, "frames fully reconstructed", "1",
               static_cast<double>(score.seen) / static_cast<double>(score.frames), score.frames));
  const std::size_t delays = score.delay_s.size(), peaks = score.peak_ratio.size();
  result.rows.push_back(
      make_row(of, "delay, median", "s", math::quantile(score.delay_s, 0.5), delays));
  result.rows.push_back(
      make_row(of, "delay, 5th percentile", "s", math::quantile(score.delay_s, 0.05), delays));
  result.rows.push_back(
      make_row(of, "delay, 95th percentile", "s", math::quantile(score.delay_s, 0.95), delays));
  result.rows.push_back(make_row(of, "peak speed of reaches over the true value, median", "1",
                                 math::quantile(score.peak_ratio, 0.5), peaks));
}

void add_boundaries(const Case& of, const SyntheticSet& set, const SegmentationScore& score,
                    StudyResult& result) {
  std::vector<double> errors;
  for (const auto& [name, part] : score.error_s) {
    result.rows.push_back(
        make_row(of, name + ", median error", "s", math::quantile(part, 0.5), part.size()));
    result.rows.push_back(
        make_row(of, name + ", 95th percentile", "s", math::quantile(part, 0.95), part.size()));
    if (name == "reach begin" || name == "reach end")
      errors.insert(errors.end(), part.begin(), part.end());
  }
  StudyRow median = make_row(of, "reach boundaries, median error", "s", math::quantile(errors, 0.5),
                             errors.size());
  StudyRow high = make_row(of, "reach boundaries, 95th percentile", "s",
                           math::quantile(errors, 0.95), errors.size());
  if (set.max_median_error_s > 0) median.at_most = set.max_median_error_s;
  if (set.max_p95_error_s > 0) high.at_most = set.max_p95_error_s;
  result.rows.push_back(median);
  result.rows.push_back(high);
}

}  // namespace

void score_synthetic(const ScoreOptions& options, const SyntheticSet& set, const StudyRun& run,
                     StudyResult& result, Plot& errors) {
  const RecordingScore sum = score_set(options, set, run);
  const SegmentationScore& score = sum.segmentation;
  const Case of = {{"set", set.name}};
  StudyRow precision = make_row(of, "movements, precision", "1", score.precision(), score.found);
  StudyRow recall = make_row(of, "movements, recall", "1", score.recall(), score.labelled);
  if (set.min_recall > 0) precision.at_least = recall.at_least = set.min_recall;
  result.rows.push_back(precision);
  result.rows.push_back(recall);
  add_boundaries(of, set, score, result);
  if (set.score_positions) add_accuracy(of, set, sum.reconstruction, result);
  StudyRow made =
      make_row(of, "synthesize, times real time", "1", sum.recorded_s / sum.synthesize_s, 1);
  StudyRow rebuilt =
      make_row(of, "reconstruction, times real time", "1", sum.recorded_s / sum.rebuild_s, 1);
  made.is_timing = rebuilt.is_timing = true;
  result.rows.push_back(made);
  result.rows.push_back(rebuilt);

  Plot::Line line{set.name, {}, {}};
  std::vector<double> all;
  for (const char* name : {"reach begin", "reach end"}) {
    const auto part = score.error_s.find(name);
    if (part != score.error_s.end())
      all.insert(all.end(), part->second.begin(), part->second.end());
  }
  for (int percent = 0; percent <= 98; ++percent) {
    line.x.push_back(1000 * math::quantile(all, percent / 100.0));
    line.y.push_back(percent);
  }
  errors.lines.push_back(std::move(line));
  run.progress(fmt::format("{}: {} labelled, {} detected", set.name,
                           count_with_noun(score.labelled, "movement"), score.found));
}

}  // namespace morphe::study
