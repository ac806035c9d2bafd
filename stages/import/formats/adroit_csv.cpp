// Adroit demonstrations as text: an optional '#' line, column names, then a row every 10 ms. Their
// world has Z up, the hand starts at Y = -0.24 m and reaches to a door at Y > 0.1 m: Y is forward
// and X to the right, so coordinates are used unchanged.
#include <algorithm>

#include "core/files/table_text.hpp"
#include "stages/import/formats/adroit_hand.hpp"
#include "stages/import/formats/readers.hpp"
#include "stages/import/recording/format.hpp"
#include "stages/import/recording/named_columns.hpp"
#include "stages/import/trackers/hand_tracker.hpp"

namespace morphe::imports {
namespace {

/// The radius of the sphere that replaces the bar of the door handle, around its only recorded
/// point. While the latch turns, the hand is in contact, and the centre of the nearest fingertip is
/// 26 to 30 mm from that point in all five recordings; half a fingertip is about 8 mm thick.
constexpr double kHandleRadius_m = 0.020;

}  // namespace

bool recognises_adroit_csv(std::string_view head) {
  if (head.starts_with('#')) head.remove_prefix(head.find('\n') + 1);  // npos + 1 is 0
  return head.starts_with("t_s,") && head.find(",ARRx,") != std::string_view::npos;
}

Demonstration read_adroit_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_table(files.file);
  if (!files.static_trial.empty()) csv.fail(1, "static_trial", "this format has no static trial");
  if (!files.name_map.empty())
    csv.fail(1, "names", "this format has no names to map; remove names");
  const NamedColumns columns(csv, !csv.lines.empty() && csv.lines[0].starts_with('#') ? 2 : 1);
  const std::size_t rows = columns.rows();
  std::vector<double> time;
  BodyStream wrist = unseen_body({"wrist"}, rows);
  AngleStream angles{{std::begin(kAdroitJoints), std::end(kAdroitJoints)}, {}, {}};
  angles.angles.resize(rows, kAdroitJointCount);
  HandStream tips{HandKind::fingertips, {}, {}, {}, {rows, 5, unknown_point()}};
  SceneObject handle;
  handle.name = "handle";
  handle.shape = Shape::sphere;
  handle.size = {kHandleRadius_m};
  for (std::size_t i = 0; i < rows; ++i) {
    const std::size_t line = columns.first_row() + i;
    const auto cells = columns.cells(line);
    const auto value = [&](std::string_view name) {
      return columns.number(line, cells, columns.at(name));
    };
    const double time_s = value("t_s");
    AdroitAngles q{};
    for (std::size_t j = 0; j < kAdroitJointCount; ++j) q[j] = value(kAdroitJoints[j]);
    const Vec3 palm = {value("palm_x"), value("palm_y"), value("palm_z")};
    handle.position.push_back({value("handle_x"), value("handle_y"), value("handle_z")});
    handle.orientation.push_back(Quat::Identity());
    add_time(time_s, csv.file, line, "t_s", time);
    // The orientation follows from the angles, the position from the palm's point itself, which was
    // recorded at the same instant as the handle's.
    Pose world_from_palm = adroit_world_from_palm(q, 0);
    world_from_palm.translation() += palm - world_from_palm * adroit_palm_point();
    wrist.position(i, 0) = world_from_palm.translation();
    wrist.orientation(i, 0) = Quat(world_from_palm.linear() * adroit_palm_from_hand()).normalized();
    const std::array<Vec3, 5> in_palm = adroit_fingertips(q);
    for (int finger = 0; finger < 5; ++finger)
      tips.position(i, finger) = world_from_palm * in_palm[finger];
    angles.angles.row(i) = Eigen::Map<const Eigen::RowVectorXd>(q.data(), kAdroitJointCount);
  }
  wrist.time = angles.time = tips.time = handle.time = time;
  Demonstration demonstration;
  demonstration.import_notes = csv.notes;
  demonstration.streams.sensors = std::move(wrist);
  demonstration.streams.arm_angles = std::move(angles);
  demonstration.streams.hand = std::move(tips);
  demonstration.objects.push_back(std::move(handle));
  return demonstration;
}

}  // namespace morphe::imports
