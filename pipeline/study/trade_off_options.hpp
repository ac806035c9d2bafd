#pragma once

#include <string>
#include <vector>

#include "core/motion/key_bounds.hpp"
#include "pipeline/study/recording_source.hpp"

namespace morphe::study {

/// A weight of the pipelines' configs and the values that are compared.
struct ComparedWeight {
  std::string key;             ///< such as "map.palm_direction"
  std::vector<double> values;  ///< ascending
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, ComparedWeight& o) {
  f.required("key", o.key);
  f.required("values", o.values, bounds::kWeight);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const ComparedWeight& weight);

/// The options of configs/studies/trade_off.yaml: the recordings are planned with each value of
/// each weight, while the other weights are those of the pipeline.
struct TradeOffStudyOptions {
  std::string study;
  std::vector<std::string> pipelines;  ///< configs of one robot or of several
  std::vector<ComparedWeight> weights;
  std::vector<RecordingSource> choose;  ///< recordings that decide the knee
  std::vector<RecordingSource> show;    ///< other recordings, whose figures are shown beside
  int quick_robots = 1;                 ///< robots of each config in the quick variant
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, TradeOffStudyOptions& o) {
  f.required("study", o.study);
  f.required("pipelines", o.pipelines);
  f.required("weights", o.weights);
  f.required("choose", o.choose);
  f("show", o.show);
  f("quick_robots", o.quick_robots, bounds::kCount);
}
/// Returns a message about the first invalid value, "" if all values are valid.
std::string validation_error(const TradeOffStudyOptions& options);

}  // namespace morphe::study
