// Gloves of Manus (and Xsens Metagloves) as exported by their recorder, with one file per hand:
// columns by name, NODE_Position_X … of 25 nodes [cm], and a row per frame. The hand is at the
// origin: the file contains its shape, not its position. z points to the fingers; for a right hand
// x points away from the thumb and y out of the back: the axes are left-handed.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/files/table_text.hpp"
#include "stages/import/recording/named_columns.hpp"
#include "stages/import/recording/unseen_points.hpp"
#include "stages/import/trackers/add_note.hpp"
#include "stages/import/trackers/hand_curl.hpp"
#include "stages/import/trackers/hand_tracker.hpp"
#include "stages/import/trackers/readers.hpp"

namespace morphe::imports {
namespace {

constexpr const char* kTimeColumn = "Elapsed_Time_In_Milliseconds";

/// Returns the nodes' names in the order of keypoints. The thumb's IP joint is called DIP.
std::vector<std::string> node_names() {
  std::vector<std::string> names{"Hand", "Thumb_CMC", "Thumb_MCP", "Thumb_DIP", "Thumb_TIP"};
  for (const char* finger : {"Index", "Middle", "Ring", "Pinky"}) {
    for (const char* joint : {"MCP", "PIP", "DIP", "TIP"})
      names.push_back(fmt::format("{}_{}", finger, joint));
  }
  return names;
}

/// Returns the side at the end of a file's stem, as in …_L.csv and …_right.csv.
std::optional<Side> side_in(std::string stem) {
  std::ranges::transform(stem, stem.begin(), [](unsigned char c) { return std::tolower(c); });
  if (stem.ends_with("_l") || stem.ends_with("left")) return Side::left;
  if (stem.ends_with("_r") || stem.ends_with("right")) return Side::right;
  return std::nullopt;
}

/// Returns the side in the file's name; without it, that of the curl; without this, files.hand.
Side side_of(const RecordingFiles& files, const RecordedHand& hand,
             std::vector<std::string>& reports) {
  if (const auto side = side_in(files.file.stem().string())) return *side;
  const double curl_m = finger_curl_m(hand.keypoints);
  const bool is_curled = std::abs(curl_m) > kMinCurl_m;
  const Side side = !is_curled ? files.hand : curl_m < 0 ? Side::right : Side::left;
  add_note(reports, "the file name does not end in _L or _R: {} hand, {}", name_of(side),
           is_curled ? "judged by the curl of its fingers"
                     : "as requested: its fingers are too straight to judge");
  return side;
}

}  // namespace

bool recognises_manus_csv(std::string_view head) {
  const std::string line = files::first_line_with_commas(head);
  return line.find(kTimeColumn) != std::string::npos &&
         line.find("Thumb_CMC_Position_X") != std::string::npos;
}

Demonstration read_manus_csv(const RecordingFiles& files) {
  const files::CsvText csv = files::read_table(files.file);
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  const NamedColumns columns(csv, csv.filled_line(1));
  const std::size_t time_column = columns.at(kTimeColumn);
  std::vector<std::vector<std::size_t>> points;
  for (const std::string& node : node_names()) {
    points.push_back(columns.at(std::vector<std::string>{node + "_Position_X", node + "_Position_Y",
                                                         node + "_Position_Z"}));
  }
  Demonstration demonstration;
  std::vector<std::string>& reports = demonstration.import_notes;
  reports = csv.notes;
  TrackerFrame frame = tracker_frame(files, "x y z", "cm", "", reports);
  frame.world_from_file.col(0) *= -1;  // the file's axes are left-handed
  reports.push_back("the axes of the file are left-handed; x is negated");
  HandClip clip;
  RecordedHand hand = unseen_hand(columns.rows());
  for (std::size_t line = columns.first_row(); line <= csv.lines.size(); ++line) {
    const auto row = columns.cells(line);
    add_time(columns.number(line, row, time_column) / 1e3, csv.file, line, kTimeColumn, clip.time);
    for (int k = 0; k < kKeypointCount; ++k) {
      hand.keypoints(line - columns.first_row(), k) =
          frame.point({columns.number_or_unknown(line, row, points[k][0]),
                       columns.number_or_unknown(line, row, points[k][1]),
                       columns.number_or_unknown(line, row, points[k][2])});
    }
  }
  hide_fillers(frame.unit_m, hand.keypoints, reports);
  const Side side = side_of(files, hand, reports);
  clip.hands[side_index(side)] = std::move(hand);
  add_shape(std::move(clip), files, "the glove was not tracked", demonstration);
  return demonstration;
}

}  // namespace morphe::imports
