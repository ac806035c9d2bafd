#include "stages/import/recording/repeated_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/count_with_noun.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

/// Chosen by hand: a logger writes a row twice now and then; a clock with too few decimals makes
/// every other row, or more, look like the one before.
constexpr double kMaxRepeatedShare = 0.05;
constexpr std::size_t kAllowedRows = 3;  ///< repeated rows of a short recording

/// Returns the indices of the rows whose time is above that of the last row kept.
std::vector<std::size_t> distinct_rows(const std::vector<double>& time) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (rows.empty() || time[i] != time[rows.back()]) rows.push_back(i);
  }
  return rows;
}

template <class T>
void keep(const std::vector<std::size_t>& rows, std::vector<T>& values) {
  if (values.empty()) return;
  for (std::size_t i = 0; i < rows.size(); ++i) values[i] = values[rows[i]];
  values.resize(rows.size());
}

template <class T>
void keep(const std::vector<std::size_t>& rows, Array2D<T>& table) {
  if (table.rows == 0) return;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < table.cols; ++k) table(i, k) = table(rows[i], k);
  }
  table.rows = rows.size();
  table.values.resize(table.rows * table.cols);
}

void keep(const std::vector<std::size_t>& rows, JointRows& table) {
  if (table.rows() == 0) return;
  table = JointRows(table(rows, Eigen::all));
}

/// Removes the repeated rows of a stream or object and returns their number.
template <class Stream>
std::size_t drop_from(const std::string& source, Stream& stream) {
  const std::vector<std::size_t> rows = distinct_rows(stream.time);
  const std::size_t all = stream.time.size(), repeated = all - rows.size();
  if (repeated == 0) return 0;
  if (repeated > kAllowedRows &&
      static_cast<double>(repeated) > kMaxRepeatedShare * static_cast<double>(all)) {
    throw UnresolvedConvention(
        "rate", fmt::format("{}: rate: {} of {} rows have the time of the row before; give --rate "
                            "or `rate_hz:` in frames per second",
                            source, repeated, all));
  }
  keep(rows, stream.time);
  if constexpr (requires { stream.position; }) keep(rows, stream.position);
  if constexpr (requires { stream.orientation; }) keep(rows, stream.orientation);
  if constexpr (requires { stream.confidence; }) keep(rows, stream.confidence);
  if constexpr (requires { stream.angles; }) keep(rows, stream.angles);
  return repeated;
}

std::size_t drop_from(const std::string& source, Streams& streams) {
  std::size_t repeated = 0;
  const auto drop = [&](auto& stream) {
    if (stream) repeated = std::max(repeated, drop_from(source, *stream));
  };
  drop(streams.markers);
  drop(streams.sensors);
  drop(streams.skeleton);
  drop(streams.hand);
  drop(streams.arm_angles);
  return repeated;
}

}  // namespace

void drop_repeated_rows(const std::string& source, Demonstration& demonstration) {
  std::size_t repeated = drop_from(source, demonstration.streams);
  for (SceneObject& object : demonstration.objects)
    repeated = std::max(repeated, drop_from(source, object));
  const std::size_t in_static = drop_from(source, demonstration.calibration);
  const auto note = [&](std::size_t count, const char* place) {
    if (count == 0) return;
    demonstration.import_notes.push_back(fmt::format("{}{} {} the time of the row before; skipped",
                                                     place, count_with_noun(count, "row"),
                                                     count == 1 ? "has" : "have"));
  };
  note(repeated, "");
  note(in_static, "static trial: ");
}

}  // namespace morphe::imports
