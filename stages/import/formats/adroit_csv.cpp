// Adroit demonstrations as text: an optional '#' line, column names, then a row every 10 ms. Their
// world has Z up, the hand starts at Y = -0.24 m and reaches to a door at Y > 0.1 m: Y is forward
// and X to the right, so coordinates are used unchanged.
#include <algorithm>

#include "stages/import/formats/adroit_hand.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/recording/named_columns.hpp"

namespace morphe::imports {
namespace {

/// The radius of a sphere for the door handle's bar, around its only recorded point. While the
/// latch turns, the nearest fingertip centre comes to 26 to 30 mm from that point in all five
/// recordings, which is contact; a fingertip of that hand is about 8 mm thick (half), which leaves
/// 20 mm.
constexpr double kHandleRadius_m = 0.020;

struct Row {
  double time_s = 0;
  AdroitAngles angles{};
  Vec3 palm, handle;
};

std::vector<Row> read_rows(const files::CsvText& csv) {
  const std::size_t header = !csv.lines.empty() && csv.lines[0].starts_with('#') ? 2 : 1;
  const NamedColumns columns(csv, header);
  std::vector<Row> rows;
  for (std::size_t line = columns.first_row(); line <= csv.lines.size(); ++line) {
    const auto cells = columns.cells(line);
    const auto value = [&](std::string_view name) {
      return columns.number(line, cells, columns.at(name));
    };
    Row& row = rows.emplace_back();
    row.time_s = value("t_s");
    for (std::size_t j = 0; j < kAdroitJointCount; ++j) row.angles[j] = value(kAdroitJoints[j]);
    row.palm = {value("palm_x"), value("palm_y"), value("palm_z")};
    row.handle = {value("handle_x"), value("handle_y"), value("handle_z")};
    if (rows.size() > 1 && !(row.time_s > rows[rows.size() - 2].time_s)) {
      csv.fail(line, "t_s", "must be greater than in the previous row");
    }
  }
  return rows;
}

}  // namespace

bool recognises_adroit_csv(std::string_view head) {
  if (head.starts_with('#')) head.remove_prefix(std::min(head.size(), head.find('\n') + 1));
  return head.starts_with("t_s,") && head.find(",ARRx,") != std::string_view::npos;
}

Demonstration read_adroit_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_csv(files.file);
  if (!files.static_trial.empty()) csv.fail(1, "static_trial", "this format has no static trial");
  const std::vector<Row> rows = read_rows(csv);
  std::vector<double> time;
  for (const Row& row : rows) time.push_back(row.time_s);

  BodyStream wrist{
      {"wrist"}, {}, time, {rows.size(), 1, unknown_point()}, {rows.size(), 1, unknown_rotation()}};
  AngleStream angles{{std::begin(kAdroitJoints), std::end(kAdroitJoints)}, time, {}};
  angles.angles.resize(rows.size(), kAdroitJointCount);
  HandStream tips{HandKind::fingertips, {}, time, {}, {rows.size(), 5, unknown_point()}};
  SceneObject handle;
  handle.name = "handle";
  handle.shape = Shape::sphere;
  handle.size = {kHandleRadius_m};
  handle.time = time;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const AdroitAngles& q = rows[i].angles;
    // The orientation follows from the angles, the position from the palm point itself, which was
    // recorded at the same instant as the handle's.
    Pose world_from_palm = adroit_world_from_palm(q, 0);
    world_from_palm.translation() += rows[i].palm - world_from_palm * adroit_palm_point();
    wrist.position(i, 0) = world_from_palm.translation();
    wrist.orientation(i, 0) = Quat(world_from_palm.linear() * adroit_palm_from_hand()).normalized();
    const std::array<Vec3, 5> in_palm = adroit_fingertips(q);
    for (std::size_t finger = 0; finger < 5; ++finger) {
      tips.position(i, finger) = world_from_palm * in_palm[finger];
    }
    angles.angles.row(i) = Eigen::Map<const Eigen::RowVectorXd>(q.data(), kAdroitJointCount);
    handle.position.push_back(rows[i].handle);
    handle.orientation.push_back(Quat::Identity());
  }
  Demonstration demonstration;
  demonstration.import_notes = csv.notes;
  demonstration.streams.sensors = std::move(wrist);
  demonstration.streams.arm_angles = std::move(angles);
  demonstration.streams.hand = std::move(tips);
  demonstration.objects.push_back(std::move(handle));
  return demonstration;
}

}  // namespace morphe::imports
