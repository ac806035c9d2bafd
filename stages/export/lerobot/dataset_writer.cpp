#include "stages/export/lerobot/dataset_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>

namespace morphe::exports {
namespace {

using Json = nlohmann::ordered_json;
using parquet::ValueType;

/// The features that every dataset has, at the end.
constexpr std::array<const char*, 5> kDefaultFeatures{"timestamp", "frame_index", "episode_index",
                                                      "index", "task_index"};

ValueType type_of(const Feature& feature) {
  return feature.is_integer ? ValueType::int64 : ValueType::float32;
}

std::vector<parquet::Column> data_columns(const std::vector<Feature>& features) {
  std::vector<parquet::Column> columns;
  for (const Feature& feature : features)
    columns.push_back({feature.name, type_of(feature), feature.names.size() > 1});
  return columns;
}

std::vector<parquet::Column> episode_columns(const std::vector<Feature>& features) {
  std::vector<parquet::Column> columns{
      {"episode_index", ValueType::int64},   {"tasks", ValueType::text, true},
      {"length", ValueType::int64},          {"data/chunk_index", ValueType::int64},
      {"data/file_index", ValueType::int64}, {"dataset_from_index", ValueType::int64},
      {"dataset_to_index", ValueType::int64}};
  for (const Feature& feature : features) {
    const auto add = [&](const char* statistic, ValueType type) {
      columns.push_back({fmt::format("stats/{}/{}", feature.name, statistic), type, true});
    };
    const ValueType extreme = feature.is_integer ? ValueType::int64 : ValueType::float64;
    add("min", extreme);
    add("max", extreme);
    add("mean", ValueType::float64);
    add("std", ValueType::float64);
    add("count", ValueType::int64);
    for (const char* name : kQuantileNames) add(name, ValueType::float64);
  }
  columns.push_back({"meta/episodes/chunk_index", ValueType::int64});
  columns.push_back({"meta/episodes/file_index", ValueType::int64});
  return columns;
}

std::vector<std::int64_t> integers(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// Returns an upper bound of the bytes of a cell with so many values, with its levels.
std::uint64_t cell_bytes(std::size_t values) { return 10 * values; }

/// The entry from which pandas takes the texts of the tasks as the index.
constexpr const char* kPandasEntry =
    R"({"index_columns": ["task"], "column_indexes": [{"name": null, "field_name": null, )"
    R"("pandas_type": "unicode", "numpy_type": "object", "metadata": {"encoding": "UTF-8"}}], )"
    R"("columns": [{"name": "task_index", "field_name": "task_index", "pandas_type": "int64", )"
    R"("numpy_type": "int64", "metadata": null}, {"name": "task", "field_name": "task", )"
    R"("pandas_type": "unicode", "numpy_type": "object", "metadata": null}], )"
    R"("creator": {"library": "pyarrow", "version": "22.0.0"}, "pandas_version": "2.3.3"})";

}  // namespace

LeRobotWriter::LeRobotWriter(LeRobotDataset dataset, NewFile new_file)
    : dataset_(std::move(dataset)), new_file_(std::move(new_file)), features_(dataset_.features) {
  for (const char* name : kDefaultFeatures)
    features_.push_back({name, {name}, std::string_view(name) != "timestamp"});
  for (const Feature& feature : features_) statistics_.emplace_back(feature.names.size());
  data_ = {"data", data_columns(features_), 0, -1, {}};
  episodes_ = {"meta/episodes", episode_columns(features_), 0, -1, {}};
}

parquet::ParquetWriter& LeRobotWriter::writer_for(Series& series, std::uint64_t bytes) {
  if (series.writer && series.writer->size() + bytes <= dataset_.max_file_bytes)
    return *series.writer;
  if (series.writer) series.writer->finish();
  if (++series.file == dataset_.files_per_chunk) {
    series.file = 0;
    ++series.chunk;
  }
  const std::string name =
      fmt::format("{}/chunk-{:03}/file-{:03}.parquet", series.folder, series.chunk, series.file);
  files::AtomicFile& file = new_file_(name);
  return series.writer.emplace(file.part(), file.target().string(), series.columns);
}

void LeRobotWriter::add(const Episode& episode) {
  assert(episode.values.size() == dataset_.features.size());
  const Eigen::Index frames = episode.values.front().rows();
  const auto [task, is_new] =
      task_index_.emplace(episode.task, static_cast<std::int64_t>(tasks_.size()));
  if (is_new) tasks_.push_back(episode.task);

  std::vector<JointRows> values = episode.values;
  for (std::size_t k = 0; k < values.size(); ++k) {
    assert(values[k].allFinite());
    // The statistics are those of the stored numbers.
    if (!features_[k].is_integer) values[k] = values[k].cast<float>().cast<double>();
  }
  const auto index = Eigen::VectorXd::LinSpaced(frames, 0, static_cast<double>(frames - 1)).eval();
  values.emplace_back((index / dataset_.fps).cast<float>().cast<double>());
  values.emplace_back(index);
  values.emplace_back(JointRows::Constant(frames, 1, static_cast<double>(episode_count_)));
  values.emplace_back(index.array() + static_cast<double>(frame_count_));
  values.emplace_back(JointRows::Constant(frames, 1, static_cast<double>(task->second)));

  add_frames(values);
  add_episode_row(episode.task, values);
  ++episode_count_;
  frame_count_ += frames;
}

void LeRobotWriter::add_frames(const std::vector<JointRows>& values) {
  const Eigen::Index frames = values.front().rows();
  std::uint64_t bytes = 0;
  for (const Feature& feature : features_) bytes += cell_bytes(feature.names.size()) * frames;
  parquet::ParquetWriter& writer = writer_for(data_, bytes);
  for (Eigen::Index row = 0; row < frames; ++row)
    for (std::size_t k = 0; k < features_.size(); ++k) {
      const auto cells = values[k].row(row);
      if (features_[k].names.size() > 1 && features_[k].is_integer)
        writer.add_integers(integers({cells.begin(), cells.end()}));
      else if (features_[k].names.size() > 1)
        writer.add_numbers(std::vector<double>(cells.begin(), cells.end()));
      else if (features_[k].is_integer)
        writer.add_integer(static_cast<std::int64_t>(cells[0]));
      else
        writer.add_number(cells[0]);
    }
}

void LeRobotWriter::add_episode_row(const std::string& task, const std::vector<JointRows>& values) {
  const std::int64_t frames = values.front().rows();
  std::uint64_t bytes = task.size();
  for (const Feature& feature : features_)
    bytes += cell_bytes((4 + kQuantileShares.size()) * feature.names.size() + 1);
  parquet::ParquetWriter& writer = writer_for(episodes_, bytes);
  writer.add_integer(episode_count_);
  writer.add_texts(std::vector<std::string>{task});
  writer.add_integer(frames);
  writer.add_integer(data_.chunk);
  writer.add_integer(data_.file);
  writer.add_integer(frame_count_);
  writer.add_integer(frame_count_ + frames);
  for (std::size_t k = 0; k < features_.size(); ++k) {
    const FrameStatistics own = statistics_of(values[k]);
    for (const std::vector<double>* extreme : {&own.min, &own.max}) {
      if (features_[k].is_integer)
        writer.add_integers(integers(*extreme));
      else
        writer.add_numbers(*extreme);
    }
    writer.add_numbers(own.mean);
    writer.add_numbers(own.std);
    writer.add_integers(std::vector<std::int64_t>{own.count});
    for (const std::vector<double>& quantile : own.quantiles) writer.add_numbers(quantile);
    statistics_[k].add(values[k]);
  }
  writer.add_integer(episodes_.chunk);
  writer.add_integer(episodes_.file);
}

void LeRobotWriter::write_tasks() {
  files::AtomicFile& file = new_file_("meta/tasks.parquet");
  parquet::ParquetWriter writer(file.part(), file.target().string(),
                                {{"task_index", ValueType::int64}, {"task", ValueType::text}},
                                {{"pandas", kPandasEntry}});
  for (std::size_t k = 0; k < tasks_.size(); ++k) {
    writer.add_integer(static_cast<std::int64_t>(k));
    writer.add_text(tasks_[k]);
  }
  writer.finish();
}

std::string LeRobotWriter::info_json(
    const std::map<std::string, std::pair<int, int>>& splits) const {
  constexpr int kFileMegabytes = 100;
  Json features = Json::object();
  for (std::size_t k = 0; k < features_.size(); ++k) {
    const Feature& feature = features_[k];
    const bool is_default = k >= dataset_.features.size();
    features[feature.name] = {{"dtype", feature.is_integer ? "int64" : "float32"},
                              {"shape", {feature.names.size()}},
                              {"names", is_default ? Json() : Json(feature.names)}};
  }
  Json json = {{"codebase_version", "v3.0"},
               {"robot_type", dataset_.robot_type},
               {"total_episodes", episode_count_},
               {"total_frames", frame_count_},
               {"total_tasks", tasks_.size()},
               {"chunks_size", dataset_.files_per_chunk},
               {"data_files_size_in_mb", kFileMegabytes},
               {"video_files_size_in_mb", kFileMegabytes},
               {"fps", dataset_.fps},
               {"splits", Json::object()},
               {"data_path", "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"},
               {"video_path", nullptr},
               {"features", features}};
  for (const auto& [name, range] : splits)
    json["splits"][name] = fmt::format("{}:{}", range.first, range.second);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string LeRobotWriter::stats_json() const {
  Json json = Json::object();
  for (std::size_t k = 0; k < features_.size(); ++k) {
    const FrameStatistics all = statistics_[k].statistics();
    const auto extreme = [&](const std::vector<double>& values) {
      return features_[k].is_integer ? Json(integers(values)) : Json(values);
    };
    Json& own = json[features_[k].name] = {{"min", extreme(all.min)},
                                           {"max", extreme(all.max)},
                                           {"mean", all.mean},
                                           {"std", all.std},
                                           {"count", {all.count}}};
    for (std::size_t q = 0; q < kQuantileShares.size(); ++q)
      own[kQuantileNames[q]] = all.quantiles[q];
  }
  return json.dump(1) + "\n";
}

void LeRobotWriter::finish(const std::map<std::string, std::pair<int, int>>& splits) {
  for (Series* series : {&data_, &episodes_})
    if (series->writer) series->writer->finish();
  write_tasks();
  new_file_("meta/stats.json").write(stats_json());
  new_file_("meta/info.json").write(info_json(splits));
}

}  // namespace morphe::exports
