#include "stages/import/trackers/hot3d_poses.hpp"

#include <cmath>

#include "stages/import/recording/named_columns.hpp"
#include "stages/import/recording/whole_number.hpp"

namespace morphe::imports {

std::map<std::string, TimedPoses> read_hot3d_poses(const std::filesystem::path& file) {
  const files::CsvText csv = files::read_csv(file);
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns columns(csv, 1);
  const std::size_t uid = columns.at("object_uid"), stamp = columns.at("timestamp[ns]");
  const auto numbers =
      columns.at({"t_wo_x[m]", "t_wo_y[m]", "t_wo_z[m]", "q_wo_w", "q_wo_x", "q_wo_y", "q_wo_z"});
  std::map<std::string, TimedPoses> bodies;
  for (std::size_t line = columns.first_row(); line <= csv.lines.size(); ++line) {
    const auto row = columns.cells(line);
    const auto time_ns = whole_number(row[stamp]);
    if (!time_ns) csv.fail(line, "timestamp[ns]", "must be a whole number");
    TimedPoses& body = bodies[std::string(row[uid])];
    if (!body.time_ns.empty() && *time_ns < body.time_ns.back())
      csv.fail(line, "timestamp[ns]", "must be greater than in the previous row of this object");
    double v[7];
    for (int k = 0; k < 7; ++k) v[k] = columns.number(line, row, numbers[k]);
    const Quat rotation(v[3], v[4], v[5], v[6]);
    if (!(std::abs(rotation.norm() - 1) < 0.01))
      csv.fail(line, "q_wo_w", "is not a quaternion of unit length");
    body.time_ns.push_back(*time_ns);
    body.pose.push_back(make_pose({v[0], v[1], v[2]}, rotation.normalized()));
  }
  return bodies;
}

}  // namespace morphe::imports
