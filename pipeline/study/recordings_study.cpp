#include "pipeline/study/score_recordings.hpp"

namespace morphe::study {

StudyResult recordings_study(const config::ConfigNode& config, const StudyRun& run) {
  ScoreOptions options;
  options.folder = run.config.parent_path();
  config::read_document(config, static_cast<RecordingsStudyOptions&>(options));
  StudyResult result;
  for (const RealSet& set : options.real) score_real(options, set, run, result);
  Plot errors;
  errors.title = "Boundaries of reaches on synthetic recordings";
  errors.x_label = "error [ms]";
  errors.y_label = "share of boundaries with a smaller error [%]";
  for (const SyntheticSet& set : options.synthetic)
    score_synthetic(options, set, run, result, errors);
  if (!errors.lines.empty()) result.plots.emplace_back("boundary_errors", std::move(errors));
  return result;
}

}  // namespace morphe::study
