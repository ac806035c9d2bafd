// One mechanism reads the tables of all formats: each case below holds for every reader of markers
// in text.
#include <gmock/gmock.h>

#include <algorithm>
#include <regex>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two markers A and B in three frames, in millimetres at 100 Hz.
struct WrittenFormat {
  const char* name;
  const char* header;
  const char* leading[3];  ///< frame or time of each row
};
constexpr WrittenFormat kFormats[] = {
    {"vicon",
     "Trajectories\n100\n,,A,,,B,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n",
     {"1,0", "2,0", "3,0"}},
    {"workstation",
     "TRAJECTORIES\n100,Hz\n,A,,,B,,\nField #,X,Y,Z,X,Y,Z\n,mm,mm,mm,mm,mm,mm\n",
     {"1", "2", "3"}},
    {"trc",
     "PathFileType,4,(X/Y/Z),x.trc\nDataRate,NumFrames,NumMarkers,Units\n100,3,2,mm\n"
     "Frame#,Time,A,,,B,,\n,,X1,Y1,Z1,X2,Y2,Z2\n\n",
     {"1,0.00", "2,0.01", "3,0.02"}},
    {"points",
     "time (s),A_x (mm),A_y (mm),A_z (mm),B_x (mm),B_y (mm),B_z (mm)\n",
     {"0.00", "0.01", "0.02"}},
    {"qualisys",
     "NO_OF_FRAMES,3\nNO_OF_MARKERS,2\nFREQUENCY,100\nDATA_INCLUDED,3D\nMARKER_NAMES,A,B\n"
     "Frame,Time,A X,A Y,A Z,B X,B Y,B Z\n",
     {"1,0.00", "2,0.01", "3,0.02"}},
    {"motive",
     "Format Version,1.23,Export Frame Rate,100,Length Units,Millimeters\n\n,Type,Marker,Marker,"
     "Marker,Marker,Marker,Marker\n,Name,A,A,A,B,B,B\n,ID,1,1,1,2,2,2\n"
     ",,Position,Position,Position,Position,Position,Position\n"
     "Frame,Time (Seconds),X,Y,Z,X,Y,Z\n",
     {"0,0.00", "1,0.01", "2,0.02"}},
};
constexpr const char* kSecondA = "11.5,21.5,31.5";

class AlikeReaders : public RecordingFolder, public testing::WithParamInterface<WrittenFormat> {
 protected:
  std::string text() const {
    const WrittenFormat& format = GetParam();
    std::string all = format.header;
    for (int i = 0; i < 3; ++i) {
      all += format.leading[i];
      for (const int tens : {10, 20, 30, 40, 50, 60}) all += fmt::format(",{}.5", tens + i);
      all += '\n';
    }
    return all;
  }
  /// The text with the first occurrence of a part replaced.
  std::string text_with(const std::string& part, const std::string& other) const {
    std::string all = text();
    return all.replace(all.find(part), part.size(), other);
  }
  MarkerStream markers_in(const std::string& all) {
    const Demonstration d = read(write(all), {"x y z", "", {}});
    notes_ = d.import_notes;
    return *d.streams.markers;
  }
  void expect_second_a_is_unseen(const std::string& cells) {
    const MarkerStream markers = markers_in(text_with(kSecondA, cells));
    EXPECT_TRUE(is_known(markers.position(0, 0))) << cells;
    EXPECT_FALSE(is_known(markers.position(1, 0))) << cells;
    EXPECT_TRUE(is_known(markers.position(1, 1))) << cells;
  }
  void expect_whole(const std::string& all) {
    const MarkerStream markers = markers_in(all);
    EXPECT_THAT(markers.names, ElementsAre("A", "B"));
    ASSERT_EQ(markers.time.size(), 3u);
    EXPECT_NEAR(markers.time[2] - markers.time[0], 0.02, 1e-12);
    EXPECT_LT((markers.position(2, 1) - Vec3(0.0425, 0.0525, 0.0625)).norm(), 1e-12);
  }
  std::vector<std::string> notes_;
};

TEST_P(AlikeReaders, ReadTheTable) { expect_whole(text()); }

TEST_P(AlikeReaders, MissingValuesAreNotSeen) {
  for (const char* cells : {",,", "Nan,NAN,nan", "-nan,#N/A,inf", "-1.#IND,1.#QNAN,-inf",
                            "null,None,N/A", "-nan(ind),#DIV/0!,--"}) {
    expect_second_a_is_unseen(cells);
  }
}

TEST_P(AlikeReaders, FillersAreNotSeen) {
  expect_second_a_is_unseen("-9999,-9999,-9999");
  EXPECT_THAT(notes_, Contains("-9999 stands in 3 cells; treated as not visible"));
  expect_second_a_is_unseen("0,0,0");
}

TEST_P(AlikeReaders, APointWithSomeOfItsCoordinatesIsNotSeen) {
  expect_second_a_is_unseen("11.5,,31.5");
  EXPECT_THAT(notes_, Contains("1 point has only some of x, y, z; treated as not visible"));
}

TEST_P(AlikeReaders, SemicolonsTabsDecimalCommasAndQuotes) {
  for (const char separator : {';', '\t'}) {
    std::string all = text();
    std::ranges::replace(all, ',', separator);
    expect_whole(all);
    std::ranges::replace(all, '.', ',');
    expect_whole(all);
    EXPECT_THAT(notes_, Contains("numbers use decimal commas"));
  }
  expect_whole(std::regex_replace(text(), std::regex("([0-9]+\\.5)"), "\"$1\""));
}

TEST_P(AlikeReaders, Utf16) {
  std::string bytes = "\xFF\xFE";
  for (const char c : text()) bytes += {c, '\0'};
  expect_whole(bytes);
  EXPECT_THAT(notes_, Contains("the text is UTF-16; converted"));
}

TEST_P(AlikeReaders, BlankLinesAndLineEnds) {
  std::string all = "\n\n" + text() + "\n\n";
  expect_whole(all);
  for (std::size_t at = 0; (at = all.find('\n', at)) != std::string::npos; at += 2)
    all.replace(at, 1, "\r\n");
  expect_whole(all);
}

TEST_P(AlikeReaders, ATimeThatStandsTwiceLosesItsRow) {
  const WrittenFormat& format = GetParam();
  const MarkerStream markers =
      markers_in(text_with(std::string("\n") + format.leading[2] + ",12.5",
                           std::string("\n") + format.leading[1] + ",12.5"));
  ASSERT_EQ(markers.time.size(), 2u);
  EXPECT_LT((markers.position(1, 0) - Vec3(0.0115, 0.0215, 0.0315)).norm(), 1e-12);
  EXPECT_THAT(notes_, Contains("1 row has the time of the row before; skipped"));
}

TEST_P(AlikeReaders, ACutLastLineIsLeftOut) {
  const std::string all = text();
  const MarkerStream markers = markers_in(all.substr(0, all.size() - 8));
  EXPECT_EQ(markers.time.size(), 2u);
  EXPECT_THAT(notes_, Contains(HasSubstr("the last line is cut off")));
}

TEST_P(AlikeReaders, NamesThatStandTwiceAreNumbered) {
  std::string all = text();
  for (std::size_t at = 0; (at = all.find_first_of("B", at)) != std::string::npos; ++at)
    all[at] = 'A';
  const MarkerStream markers = markers_in(all);
  EXPECT_THAT(markers.names, ElementsAre("A", "A_2"));
  EXPECT_LT((markers.position(2, 1) - Vec3(0.0425, 0.0525, 0.0625)).norm(), 1e-12);
  EXPECT_THAT(notes_, Contains("the name A stands more than once; another is called A_2"));
}

INSTANTIATE_TEST_SUITE_P(All, AlikeReaders, testing::ValuesIn(kFormats),
                         [](const auto& format) { return format.param.name; });

}  // namespace
}  // namespace morphe::imports
