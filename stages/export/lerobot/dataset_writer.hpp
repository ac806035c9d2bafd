#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/files/atomic_file.hpp"
#include "core/parquet/parquet_writer.hpp"
#include "stages/export/lerobot/episode.hpp"
#include "stages/export/lerobot/frame_statistics.hpp"

namespace morphe::exports {

/// The data that all episodes of a LeRobotDataset have in common.
struct LeRobotDataset {
  int fps = 30;  ///< frames per second, > 0
  std::string robot_type;
  std::vector<Feature> features;              ///< without the five that every dataset has
  std::uint64_t max_file_bytes = 95'000'000;  ///< of a Parquet file; an episode is not divided
  int files_per_chunk = 1000;                 ///< files in a folder
};

/// Writes a LeRobotDataset v3.0, episode by episode, in memory that does not grow with their number
/// (but for the texts of the tasks):
///   data/chunk-000/file-000.parquet …           one row per frame: the features, then timestamp
///                                               (k / fps), frame_index, episode_index, index and
///                                               task_index
///   meta/episodes/chunk-000/file-000.parquet …  one row per episode, with its statistics
///   meta/tasks.parquet  meta/stats.json  meta/info.json
/// Throws InputError like ParquetWriter.
class LeRobotWriter {
 public:
  /// Creates a file of the dataset, given its name in the dataset's folder, which is written until
  /// finish().
  using NewFile = std::function<files::AtomicFile&(const std::string& name)>;

  LeRobotWriter(LeRobotDataset dataset, NewFile new_file);
  /// Appends an episode of at least one frame.
  void add(const Episode& episode);
  /// Completes the files. `splits` are names with the index of the first episode and that after the
  /// last one.
  void finish(const std::map<std::string, std::pair<int, int>>& splits);

 private:
  /// Parquet files of one kind, of which one is being written.
  struct Series {
    std::string folder;
    std::vector<parquet::Column> columns;
    int chunk = 0, file = -1;
    std::optional<parquet::ParquetWriter> writer;
  };
  /// Returns the writer for so many more bytes, of the same file or of a new one.
  parquet::ParquetWriter& writer_for(Series& series, std::uint64_t bytes);
  void add_frames(const std::vector<JointRows>& values);
  void add_episode_row(const std::string& task, const std::vector<JointRows>& values);
  void write_tasks();
  std::string info_json(const std::map<std::string, std::pair<int, int>>& splits) const;
  std::string stats_json() const;

  LeRobotDataset dataset_;
  NewFile new_file_;
  std::vector<Feature> features_;  ///< with the five that every dataset has
  std::vector<RunningStatistics> statistics_;
  Series data_, episodes_;
  std::vector<std::string> tasks_;
  std::map<std::string, std::int64_t> task_index_;
  std::int64_t episode_count_ = 0, frame_count_ = 0;
};

}  // namespace morphe::exports
