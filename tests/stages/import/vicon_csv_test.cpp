#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "pipeline/motion/input_error.hpp"
#include "stages/import/import.hpp"

namespace morphe {
namespace {

using testing::HasSubstr;

const std::filesystem::path kData = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/ue-adl";

class ViconCsv : public testing::Test {
 protected:
  ViconCsv() { std::filesystem::create_directories(folder_); }
  ~ViconCsv() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text, const std::string& name = "trial.csv") {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  Demonstration read(const std::filesystem::path& file) {
    std::vector<Demonstration> read;
    ImportRequest request;
    request.paths = {file};
    import_recordings(request, [&](Demonstration&& d) { read.push_back(std::move(d)); });
    return read.at(0);
  }
  std::string error_of(const std::string& text) {
    const std::filesystem::path file = write(text);
    try {
      read(file);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "no error";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      ("morphe_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

const std::string kHeader =
    "Trajectories\n50\n,,A:RFTP,,,A:RTHUM\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n"
    ",,mm,mm,mm,mm,mm,mm\n";

TEST_F(ViconCsv, ReadsUnitsRateGapsAndByteOrderMark) {
  const Demonstration d = read(write(std::string("\xEF\xBB\xBF") + kHeader +
                                     "11,0,1,2,3,-4.5,5e1,6\r\n12,0,,,,7,8,9\r\n\r\n"));
  const MarkerStream& markers = *d.streams.markers;
  EXPECT_EQ(d.name, "trial");
  EXPECT_EQ(d.subject, "A");
  EXPECT_EQ(d.hand, "right");
  EXPECT_EQ(markers.names, (std::vector<std::string>{"RFTP", "RTHUM"}));
  ASSERT_EQ(markers.time.size(), 2u);
  EXPECT_DOUBLE_EQ(markers.time[0], 0.2);
  EXPECT_DOUBLE_EQ(markers.time[1], 0.22);
  EXPECT_TRUE(markers.position(0, 0).isApprox(Vec3(0.001, 0.002, 0.003), 1e-15));
  EXPECT_TRUE(markers.position(0, 1).isApprox(Vec3(-0.0045, 0.05, 0.006), 1e-15));
  EXPECT_FALSE(seen(markers.position(1, 0)));
  EXPECT_FALSE(d.calibration.markers.has_value());
}

TEST_F(ViconCsv, TakesMetres) {
  std::string text;
  for (std::size_t i = 0; i < kHeader.size(); ++i) {
    if (kHeader.compare(i, 2, "mm") != 0) text += kHeader[i];
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
            "trial.csv:5: RFTP.Z: unit differs from the first column's");
  EXPECT_THAT(error_of("Trajectories\n100\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,ell,ell,ell\n" + row),
              HasSubstr("trial.csv:5: unit: must be m, cm, mm, in"));
  EXPECT_EQ(error_of("Trajectories\n100\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,mm,m,mm\n" + row),
            "trial.csv:5: RFTP.Y: unit differs from the first column's");
  EXPECT_EQ(error_of(kHeader + row + "2,0,1,2,3,4,5\n"),
            "trial.csv:7: RTHUM.Z: the row has 7 cells, the header 8");
  EXPECT_EQ(error_of(kHeader + "1,0,1,2,3,4,5,6,7\n"),
            "trial.csv:6: column 9: the row has 9 cells, the header 8");
  EXPECT_EQ(error_of(kHeader + "1,0,1,2,3,4,5x,6\n"),
            "trial.csv:6: RTHUM.Y: must be a number, not '5x'");
  EXPECT_EQ(error_of(kHeader + "1,0,1,2,3,4,nan,6\n"),
            "trial.csv:6: RTHUM: has some of X, Y, Z but not all");
  EXPECT_EQ(error_of(kHeader + "1,0,1,,3,4,5,6\n"),
            "trial.csv:6: RFTP: has some of X, Y, Z but not all");
  EXPECT_EQ(error_of(kHeader + row + row), "trial.csv:7: Frame: does not follow the frame before");
  EXPECT_EQ(error_of(kHeader), "trial.csv:5: ends before the first frame");
  EXPECT_EQ(error_of("Trajectories\nfast\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n" + row),
            "trial.csv:2: rate: must be a number, not 'fast'");
  EXPECT_EQ(error_of("Trajectories\n100\n,,A:RFTP,,,A:RFTP\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n"
                     ",,mm,mm,mm,mm,mm,mm\n" +
                     row),
            "trial.csv:3: A:RFTP: the marker stands twice");
}

TEST_F(ViconCsv, RealTrialsMatchTheirText) {
  std::vector<Demonstration> trials;
  ImportRequest request;
  request.paths = {kData / "recordings.yaml"};
  EXPECT_EQ(import_recordings(request, [&](Demonstration&& d) { trials.push_back(std::move(d)); }),
            5u);
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
  request.names = write("MIDDLE: RFTP\n", "names.yaml");
  EXPECT_THROW(import_recordings(request, [](Demonstration&&) {}), InputError);
}

TEST_F(ViconCsv, UnknownContentAndFormatListWhatIsKnown) {
  EXPECT_EQ(error_of("time,x\n0,1\n"),
            "trial.csv:1: format: not recognised; known: " +
                fmt::format("{}", fmt::join(import_format_names(), ", ")));
  ImportRequest request{{write("x")}, {}, "c4d", {}, {}};
  try {
    import_recordings(request, [](Demonstration&&) {});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown 'c4d'; known: vicon-csv, "));
  }
  request = {{folder_ / "absent.csv"}, {}, "", {}, {}};
  EXPECT_THROW(import_recordings(request, [](Demonstration&&) {}), InputError);
}

TEST_F(ViconCsv, ManifestErrors) {
  write(kHeader + "1,0,1,2,3,4,5,6\n");
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
  EXPECT_THAT(manifest_error("hand: both\nrecordings:\n  - {file: trial.csv}\n"),
              HasSubstr("hand must be right or left"));
  EXPECT_THAT(manifest_error("recordings:\n  - {file: trial.csv}\n  - {file: trial.csv}\n"),
              HasSubstr("'trial' stands twice"));
}

}  // namespace
}  // namespace morphe
