#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stages/import/folders/recording_formats.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::filesystem::path kData = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl";

class ViconCsv : public RecordingFolder {
 protected:
  std::string error_of(const std::string& text) { return RecordingFolder::error_of(write(text)); }
};

const std::string kViconHeader =
    "Trajectories\n50\n,,A:RFTP,,,A:RTHUM\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n"
    ",,mm,mm,mm,mm,mm,mm\n";

TEST_F(ViconCsv, ReadsUnitsRateGapsAndByteOrderMark) {
  const Demonstration d = read(write(std::string("\xEF\xBB\xBF") + kViconHeader +
                                     "11,0,1,2,3,-4.5,5e1,6\r\n12,0,,,,7,8,9\r\n\r\n"));
  const MarkerStream& markers = *d.streams.markers;
  EXPECT_EQ(d.name, "trial");
  EXPECT_EQ(d.subject, "A");
  EXPECT_EQ(d.hand, Side::right);
  EXPECT_EQ(markers.names, (std::vector<std::string>{"RFTP", "RTHUM"}));
  ASSERT_EQ(markers.time.size(), 2u);
  EXPECT_DOUBLE_EQ(markers.time[0], 0.2);
  EXPECT_DOUBLE_EQ(markers.time[1], 0.22);
  EXPECT_TRUE(markers.position(0, 0).isApprox(Vec3(0.001, 0.002, 0.003), 1e-15));
  EXPECT_TRUE(markers.position(0, 1).isApprox(Vec3(-0.0045, 0.05, 0.006), 1e-15));
  EXPECT_FALSE(is_known(markers.position(1, 0)));
  EXPECT_FALSE(d.calibration.markers.has_value());
}

TEST_F(ViconCsv, TakesMetres) {
  std::string text;
  for (std::size_t i = 0; i < kViconHeader.size(); ++i) {
    if (kViconHeader.compare(i, 2, "mm") != 0) text += kViconHeader[i];
  }
  EXPECT_DOUBLE_EQ(read(write(text + "1,0,1,2,3,4,5,6\n")).streams.markers->position(0, 0).z(), 3);
}

TEST_F(ViconCsv, ErrorsNameLineAndColumn) {
  const std::string row = "1,0,1,2,3,4,5,6\n";
  EXPECT_EQ(error_of("Trajectories\n100\n,,A:RFTP,,,A:RTHUM\nFrame,Sub Frame,X,Y,Z,X,Z\n"
                     ",,mm,mm,mm,mm,mm\n" +
                     row),
            "trial.csv:4: RTHUM.Y: the column is missing");
  EXPECT_EQ(error_of("Trajectories\n100\n,,A:RFTP,,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n"
                     ",,mm,mm,mm,mm,mm,mm\n" +
                     row),
            "trial.csv:4: column 6: belongs to no marker");
  EXPECT_EQ(error_of("Trajectories\n100\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,inch\n" + row),
            "trial.csv:5: RFTP.Z: has another unit than the first column");
  EXPECT_THAT(
      error_of("Trajectories\n100\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,ell,ell,ell\n1,0,1,2,3\n"),
      HasSubstr("trial.csv:5: unit: 'ell' in the file is unknown"));
  EXPECT_EQ(error_of("Trajectories\n100\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,mm,m,mm\n" + row),
            "trial.csv:5: RFTP.Y: has another unit than the first column");
  EXPECT_EQ(error_of(kViconHeader + row + "2,0,1,2,3,4,5\n"),
            "trial.csv:7: RTHUM.Z: the row has 7 cells, the header has 8");
  EXPECT_EQ(error_of(kViconHeader + "1,0,1,2,3,4,5,6,7\n"),
            "trial.csv:6: column 9: the row has 9 cells, the header has 8");
  EXPECT_EQ(error_of(kViconHeader + "1,0,1,2,3,4,5x,6\n"),
            "trial.csv:6: RTHUM.Y: must be a number, not '5x'");
  EXPECT_EQ(error_of(kViconHeader), "trial.csv:5: ends before the first frame");
  EXPECT_EQ(error_of("Trajectories\nfast\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n" + row),
            "trial.csv:2: rate: must be a number, not 'fast'");
}

TEST_F(ViconCsv, RealTrialsMatchTheirText) {
  std::vector<Demonstration> trials;
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {kData / "recordings.yaml"};
  import_recordings(request, [&](Demonstration&& d) { trials.push_back(std::move(d)); });
  ASSERT_EQ(trials.size(), 5u);
  const std::size_t frames[] = {890, 580, 638, 339, 410};
  const std::size_t still[] = {41, 30, 196, 41, 41};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(trials[i].streams.markers->time.size(), frames[i]);
    EXPECT_EQ(trials[i].streams.markers->names.size(), 49u);
    EXPECT_EQ(trials[i].calibration.markers->time.size(), still[i]);
    EXPECT_EQ(trials[i].licence, "MIT");
  }
  EXPECT_EQ(trials[1].name, "ADL004DR2");
  EXPECT_EQ(trials[1].subject, "ADL004");
  EXPECT_EQ(trials[3].task, "reach forward");
  EXPECT_EQ(trials[0].streams.markers->names[0], "RSHO1");
  EXPECT_TRUE(trials[0].streams.markers->position(0, 0).isApprox(
      Vec3(0.127789154, -0.270754150, 0.355326569), 1e-12));
  EXPECT_DOUBLE_EQ(trials[0].streams.markers->time.back(), 8.89);
  EXPECT_DOUBLE_EQ(trials[0].calibration.markers->time.front(), 0.40);
}

TEST_F(ViconCsv, NamesAreMapped) {
  const auto file = write(
      "Trajectories\n100\n,,P:INDEX\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n"
      "1,0,1,2,3\n");
  ImportRequest request{{file}, {}, "", write("INDEX: RFTP\n", "names.yaml"), {}};
  import_recordings(request, [](Demonstration&& d) {
    EXPECT_EQ(d.streams.markers->names, std::vector<std::string>{"RFTP"});
  });
  request.name_map = write("MIDDLE: RFTP\n", "names.yaml");
  EXPECT_THAT([&] { import_recordings(request, [](Demonstration&&) {}); },
              ThrowsMessage<InputError>(HasSubstr(
                  "trial.csv: names: 'MIDDLE' is to be renamed but is not in the recording")));
}

TEST_F(ViconCsv, NamesMayBeInTheRecordingOrInTheStaticTrial) {
  const std::string rows = "Frame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n1,0,1,2,3,40,50,60\n";
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {write("Trajectories\n100\n,,P:HAND,,,P:INDEX\n" + rows)};
  request.static_trial = write("Trajectories\n100\n,,P:HAND,,,P:ELBOW\n" + rows, "static.csv");
  request.name_map = write("{HAND: RHAN1, INDEX: RFTP, ELBOW: RLEP}", "names.yaml");
  const Demonstration d = read(request);
  EXPECT_THAT(d.streams.markers->names, ElementsAre("RHAN1", "RFTP"));
  EXPECT_THAT(d.calibration.markers->names, ElementsAre("RHAN1", "RLEP"));
  request.name_map = write("{HAND: RHAN1, THUMB: RTHUM}", "names.yaml");
  try {
    read(request);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(
        error.what(),
        HasSubstr("trial.csv: names: 'THUMB' is to be renamed but is not in the recording"));
  }
}

TEST_F(ViconCsv, SeveralSubjectsKeepTheirNames) {
  const std::string rows = "Frame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n1,0,1,2,3,40,50,60\n";
  Demonstration d = read(write("Trajectories\n100\n,,A:HAND,,,box:TOP\n" + rows));
  EXPECT_THAT(d.streams.markers->names, ElementsAre("A:HAND", "box:TOP"));
  EXPECT_EQ(d.subject, "");
  EXPECT_THAT(d.import_notes, testing::Contains("marker names keep the subject as prefix: A, box"));
  d = read(write("Trajectories\n100\n,,A:HAND,,,HAND\n" + rows));
  EXPECT_THAT(d.streams.markers->names, ElementsAre("A:HAND", "HAND"));
  d = read(write("Trajectories\n100\n,,A:HAND,,,*5\n" + rows));  // a point without a name
  EXPECT_THAT(d.streams.markers->names, ElementsAre("HAND", "*5"));
  EXPECT_EQ(d.subject, "A");
}

TEST_F(ViconCsv, AxesAreTheUsualOnesOrAsGiven) {
  const auto file = write(kViconHeader + "1,0,1,2,3,40,50,60\n");
  EXPECT_THAT(read(file).import_notes,
              ElementsAre("axes not in the file; assumed 'x y z' (right, forward, up)"));
  const Demonstration d = read(file, {"y -x z", "", {}});
  EXPECT_LT((d.streams.markers->position(0, 1) - Vec3(0.05, -0.04, 0.06)).norm(), 1e-15);
  EXPECT_THAT(d.import_notes, ElementsAre());
  const Demonstration mirrored = read(file, {"y x z", "", {}});
  EXPECT_LT((mirrored.streams.markers->position(0, 1) - Vec3(0.05, 0.04, 0.06)).norm(), 1e-15);
  EXPECT_THAT(mirrored.import_notes,
              ElementsAre("the axes 'y x z' are left-handed: the points are mirrored"));
}

TEST_F(ViconCsv, OtherSectionsAreLeftOut) {
  const Demonstration d = read(
      write("Devices\n1000\n,,Force\nFrame,Sub Frame,Fx\n,,N\n1,0,5\n1,1,6\n\n" + kViconHeader +
            "1,0,1,2,3,40,50,60\n2,0,1,2,3,40,50,60\n,,,\n" + "Model Outputs\n100\n,,Angle\n"));
  EXPECT_EQ(d.streams.markers->time.size(), 2u);
  EXPECT_THAT(d.import_notes, testing::Contains("sections skipped: Devices, Model Outputs"));
  EXPECT_EQ(error_of("Devices\n1000\n,,Force\n"), "trial.csv:1: section 'Trajectories' not found");
}

struct Damage {
  const char* name;
  const char* text;    ///< behind kViconHeader
  const char* error;   ///< "" = it is read
  const char* report;  ///< "" = none
};
class DamagedViconCsv : public ViconCsv, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedViconCsv, IsRefusedOrReported) {
  const Damage& damage = GetParam();
  if (*damage.error != 0) {
    EXPECT_EQ(error_of(kViconHeader + damage.text), std::string("trial.csv:") + damage.error);
  } else {
    const Demonstration d = read(write(kViconHeader + damage.text));
    EXPECT_THAT(d.import_notes, testing::Contains(HasSubstr(damage.report)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, DamagedViconCsv,
    testing::Values(Damage{"MixedLineEnds",
                           "1,0,1,2,3,40,50,60\r\n2,0,1,2,3,40,50,60\r3,0,1,2,3,4,5,6\n", "",
                           "mixed line endings; all are accepted"},
                    Damage{"BlankLine", "1,0,1,2,3,40,50,60\n\n2,0,1,2,3,4,5,6\n",
                           "8: a section must begin here, but '2' is not a section", ""},
                    Damage{"TooFewCells", "1,0,1,2,3,40,50\n",
                           "6: RTHUM.Z: the row has 7 cells, the header has 8", ""},
                    Damage{"CutInARow", "1,0,1,2,3,40,50,60\n2,0,1,", "",
                           "the last line is cut off in its cell 4 of 8; skipped"},
                    Damage{"TooManyCells", "1,0,1,2,3,40,50,60,7\n",
                           "6: column 9: the row has 9 cells, the header has 8", ""},
                    Damage{"OtherSeparator", "1;0;1;2;3;40;50;60\n",
                           "6: Sub Frame: the row has 1 cells, the header has 8", ""},
                    Damage{"DecimalComma", "1,0,1,5,2,3,40,50,60\n",
                           "6: column 9: the row has 9 cells, the header has 8", ""},
                    Damage{"NothingSeen", "1,0,,,,,,\n2,0,nan,nan,nan,NaN,NaN,NaN\n", "",
                           "no marker is visible in any frame"},
                    Damage{"MarkerNeverSeen", "1,0,,,,40,50,60\n", "", "never visible: RFTP"},
                    Damage{"OriginForNotSeen", "1,0,0,0,0,40,50,60\n", "",
                           "1 points are exactly at the origin"},
                    Damage{"Infinite", "1,0,inf,2,3,40,50,60\n", "",
                           "1 point has only some of x, y, z; treated as not visible"},
                    Damage{"TimeRunsBack", "2,0,1,2,3,40,50,60\n1,0,1,2,3,40,50,60\n",
                           "7: Frame: must be greater than in the previous row", ""},
                    Damage{"TimeStands", "1,0,1,2,3,40,50,60\n1,0,1,2,3,40,50,60\n", "",
                           "1 row has the time of the row before; skipped"},
                    Damage{"FramesLeftOut", "1,0,1,2,3,40,50,60\n5,0,1,2,3,40,50,60\n", "",
                           "3 frame numbers are missing"},
                    Damage{"SubFrames", "1,0,1,2,3,40,50,60\n1,1,1,2,3,40,50,60\n",
                           "7: Sub Frame: must be 0; sub-frames are not supported", ""},
                    Damage{"FrameIsNoNumber", "one,0,1,2,3,40,50,60\n",
                           "6: Frame: must be a number, not 'one'", ""},
                    Damage{"NoFrame", "", "5: ends before the first frame", ""}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST_F(ViconCsv, CarriageReturnsAloneEndLines) {
  std::string text = kViconHeader + "1,0,1,2,3,40,50,60\n";
  std::ranges::replace(text, '\n', '\r');
  EXPECT_EQ(read(write(text)).streams.markers->time.size(), 1u);
}

TEST_F(ViconCsv, WrongUnitIsNoticedAndCanBeOverruled) {
  std::string text = kViconHeader;
  for (std::size_t at = 0; (at = text.find("mm")) != std::string::npos;) text.replace(at, 2, "m");
  const auto file = write(text + "1,0,100,200,300,400,500,600\n");
  EXPECT_EQ(RecordingFolder::error_of(file),
            "trial.csv: unit: implausible: the markers extend over 520 m; give --unit or "
            "`unit:`");
  const Demonstration d = read(file, {"", "mm", 25});
  EXPECT_LT((d.streams.markers->position(0, 0) - Vec3(0.1, 0.2, 0.3)).norm(), 1e-15);
  EXPECT_THAT(d.import_notes, testing::Contains("unit m in the file; the given mm is used"));
  EXPECT_THAT(d.import_notes,
              testing::Contains("50 frames per second in the file; the given 25 is used"));
}

TEST_F(ViconCsv, EmptyFilesAreNotRecognised) {
  for (const char* text : {"", "\xEF\xBB\xBF", "\n\n", ",,,\n"}) {
    EXPECT_THAT(error_of(text), testing::AnyOf(HasSubstr("trial.csv:1: format: not recognised"),
                                               HasSubstr("is empty")));
    ImportRequest request;
    request.conventions.forward = ForwardSource::recorded;
    request.paths = {folder_ / "trial.csv"};
    request.format = "vicon-csv";
    EXPECT_THAT(
        [&] { read(request); },
        ThrowsMessage<InputError>(HasSubstr("trial.csv:1: section 'Trajectories' not found")));
  }
}

/// Numbers that Python read from the text.
TEST_F(ViconCsv, TwoSubjectsMatchTheirText) {
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/pyomeca/recordings.yaml"};
  const Demonstration d = read(request);
  const MarkerStream& markers = *d.streams.markers;
  ASSERT_EQ(markers.time.size(), 580u);
  ASSERT_EQ(markers.names.size(), 51u);
  EXPECT_EQ(markers.names[0], "boite:gauche_ext");
  EXPECT_EQ(markers.names[24], "RGTH");
  EXPECT_DOUBLE_EQ(markers.time.back(), 5.79);
  EXPECT_LT((markers.position(0, 0) - Vec3(-0.276862, -0.0441628, 0.675697)).norm(), 1e-12);
  EXPECT_LT((markers.position(579, 50) - Vec3(0.610845, -0.623752, 0.0996826)).norm(), 1e-12);
  EXPECT_EQ(
      std::ranges::count_if(markers.position.values, [](const Vec3& p) { return is_known(p); }),
      29275);
}

TEST_F(ViconCsv, UnknownContentAndFormatListWhatIsKnown) {
  EXPECT_EQ(error_of("time,x\n0,1\n"),
            "trial.csv:1: format: not recognised; known: " +
                fmt::format("{}", fmt::join(import_format_names(), ", ")));
  ImportRequest request{{write("x")}, {}, "c4d", {}, {}};
  const auto import_all = [&] { import_recordings(request, [](Demonstration&&) {}); };
  EXPECT_THAT(import_all,
              ThrowsMessage<InputError>(HasSubstr("unknown 'c4d'; known: vicon-csv, ")));
  request = {{folder_ / "absent.csv"}, {}, "", {}, {}};
  EXPECT_THAT(import_all, ThrowsMessage<InputError>(HasSubstr("absent.csv: cannot be read")));
}

TEST_F(ViconCsv, ManifestErrors) {
  write(kViconHeader + "1,0,1,2,3,4,5,6\n");
  const auto manifest_error = [&](const std::string& text) -> std::string {
    ImportRequest request{{write(text, "recordings.yaml")}, {}, "", {}, {}};
    try {
      import_recordings(request, [](Demonstration&&) {});
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "no error";
  };
  EXPECT_EQ(manifest_error("recordings:\n  - {file: trial.csv}\n"), "no error");
  EXPECT_EQ(manifest_error("recordings:\n  - {name: a}\n"),
            "recordings.yaml:2: recordings[0].file: is missing");
  EXPECT_EQ(manifest_error("recordings:\n  - {file: trial.csv, colour: red}\n"),
            "recordings.yaml:2: recordings[0].colour: unknown key");
  EXPECT_THAT(manifest_error("hand: none\nrecordings:\n  - {file: trial.csv}\n"),
              HasSubstr("hand: must be right, left or both, not 'none'"));
  EXPECT_THAT(manifest_error("recordings:\n  - {file: trial.csv}\n  - {file: trial.csv}\n"),
              HasSubstr("'trial' appears twice"));
}

}  // namespace
}  // namespace morphe::imports
