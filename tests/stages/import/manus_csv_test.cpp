#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::HasSubstr;
using ManusCsv = RecordingFolder;

std::vector<std::string> manus_nodes() {
  std::vector<std::string> nodes{"Hand", "Thumb_CMC", "Thumb_MCP", "Thumb_DIP", "Thumb_TIP"};
  for (const char* finger : {"Index", "Middle", "Ring", "Pinky"}) {
    for (const char* joint : {"CMC", "MCP", "PIP", "DIP", "TIP"}) {
      nodes.push_back(fmt::format("{}_{}", finger, joint));
    }
  }
  return nodes;
}

std::string header() {
  std::string text = "Frame,Elapsed_Time_In_Milliseconds,Time";
  for (const std::string& node : manus_nodes()) {
    text += fmt::format(",{0}_Position_X,{0}_Position_Y,{0}_Position_Z,{0}_Rotation_X", node);
  }
  return text + ",Pinch_ThumbToIndex\n";
}

/// A right hand in left-handed axes, z to the fingers, thumb at -x, palm at -y; `curl` cm to the
/// palm at the tips.
std::string row(int ms, double curl, double scale = 1) {
  std::string text = fmt::format("1,{},00:00:00:000", ms);
  const auto nodes = manus_nodes();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::size_t finger = k == 0 ? 2 : k < 5 ? 0 : 1 + (k - 5) / 5;
    const std::size_t along = k == 0 ? 0 : k < 5 ? k : 1 + (k - 5) % 5;
    const bool tip = nodes[k].ends_with("TIP");
    text += fmt::format(
        ",{},{},{},0", scale * (k == 0 ? 0.0 : 2.0 * (static_cast<double>(finger) - 2)),
        scale * (tip ? -curl : 0.0),
        scale * (along == 0 ? 0 : 1 + 3.5 * static_cast<double>(along - 1) + (k < 5 ? 0 : 1)));
  }
  return text + ",0\n";
}

TEST_F(ManusCsv, TheShapeOfAHand) {
  const Demonstration d = read(write(header() + row(0, 3) + row(17, 3), "trial_R.csv"));
  const HandStream& hand = *d.streams.hand;
  EXPECT_EQ(hand.kind, HandKind::keypoints);
  EXPECT_EQ(hand.time, (std::vector<double>{0, 0.017}));
  EXPECT_LT(hand.position(0, 0).norm(), 1e-12);
  EXPECT_LT((hand.position(0, 8) - Vec3(0.02, -0.03, 0.16)).norm(), 1e-12);  // index tip
  EXPECT_LT((hand.position(0, 9) - Vec3(0, 0, 0.055)).norm(), 1e-12);        // middle MCP, not CMC
  EXPECT_THAT(d.import_notes,
              Contains("the glove was not tracked: only the shape of the right hand is "
                       "used, not its position"));
}

TEST_F(ManusCsv, TheSideIsTheNamesOrTheFingers) {
  EXPECT_THAT(error_of(write(header() + row(0, 3), "trial_L.csv")),
              HasSubstr("left hand: its fingers curl like those of a right hand"));
  EXPECT_THAT(
      read(write(header() + row(0, 3), "trial.csv")).import_notes,
      Contains(
          "the file name does not end in _L or _R: right hand, judged by the curl of its fingers"));
  EXPECT_THAT(read(write(header() + row(0, 0.1), "flat.csv")).import_notes,
              Contains(HasSubstr("as requested: its fingers are too straight to judge")));
}

TEST_F(ManusCsv, ErrorsSayWhere) {
  const auto error = [&](const std::string& text) { return error_of(write(text, "m_R.csv")); };
  std::string lacking = header();
  lacking.replace(lacking.find("Index_PIP_Position_Y"), 9, "Index_IP_");
  EXPECT_EQ(error(lacking + row(0, 1)), "m_R.csv:1: Index_PIP_Position_Y: the column is missing");
  EXPECT_EQ(error(header()), "m_R.csv:1: the file ends before the first row");
  EXPECT_EQ(error(header() + row(5, 1) + row(4, 1)),
            "m_R.csv:3: Elapsed_Time_In_Milliseconds: must be greater than in the previous row");
  EXPECT_EQ(error(header() + "1,2,3\n"), "m_R.csv:2: the row has 3 cells, the header has 104");
  EXPECT_THAT(error(header() + row(0, 3, 3)),
              HasSubstr("unit: implausible: the right hand would measure 0.165 m"));
}

}  // namespace
}  // namespace morphe::imports
