#include <gmock/gmock.h>

#include "core/files/text_encoding.hpp"
#include "stages/import/guess/plausibility.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::StrEq;
using testing::ThrowsMessage;

const std::string kTrial =
    "Trajectories\n100\n,,Daphn\xE9"
    "e:HAND\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n1,0,1,2,3\n"
    "2,0,2,3,4\n";

TEST(TextEncoding, KnowsUtf8FromOtherBytes) {
  for (const char* text : {"", "abc", "\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"}) {
    EXPECT_TRUE(files::is_utf8(text)) << text;
  }
  // Cut short, alone, too long for what it says, half of a pair, beyond the last code.
  for (const char* text :
       {"\xC3", "\xA9",
        "\xE9"
        "e",
        "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"}) {
    EXPECT_FALSE(files::is_utf8(text));
  }
  EXPECT_EQ(files::utf8_from_latin1("Daphn\xE9"
                                    "e"),
            "Daphn\xC3\xA9"
            "e");
}

TEST_F(RecordingFolder, OldEncodingsAreReported) {
  const Demonstration d = read(write(kTrial));
  EXPECT_EQ(d.subject,
            "Daphn\xC3\xA9"
            "e");
  EXPECT_THAT(d.import_notes, Contains("the text is not UTF-8; assumed ISO 8859-1"));
}

TEST_F(RecordingFolder, BytesOfZeroAreNoText) {
  std::string text = kTrial;
  text[text.find("HAND")] = '\0';
  EXPECT_THAT(error_of(write(text)), HasSubstr("trial.csv: contains null bytes"));
}

TEST_F(RecordingFolder, OutliersBeyondReasonAreRefused) {
  std::string text = kTrial;
  EXPECT_THAT(error_of(write(text.replace(text.rfind("4\n"), 1, "1e8"))),
              HasSubstr("trial.csv: unit: implausible: the markers extend over"));
  Demonstration d;
  d.streams.sensors.emplace().position = Array2D<Vec3>(2, 1, Vec3(999, 0, 0));
  d.calibration.arm_angles.emplace().angles = JointRows::Constant(1, 1, kUnknown);
  const auto check = [&] { check_plausibility("f", d); };
  EXPECT_NO_THROW(check());
  d.streams.sensors->position(1, 0).y() = -2000;
  EXPECT_THAT(check, ThrowsMessage<InputError>(
                         StrEq("f: unit: implausible: a point is 2e+03 m from the origin")));
  d.streams = {};
  d.calibration.arm_angles->angles(0, 0) = -90;  // degrees
  EXPECT_THAT(check, ThrowsMessage<InputError>(StrEq("f: unit: implausible: an angle is -90 rad")));
  text = kTrial;
  EXPECT_EQ(error_of(write(text.replace(text.rfind("2,0"), 1, "1e9"))),
            "trial.csv: time: implausible: 1e+07 s between two rows, 0 and 1e+07 s");
  text = kTrial;
  EXPECT_THAT(error_of(write(text.replace(text.find("100"), 3, "1e-9"))),
              HasSubstr("trial.csv: time: implausible: 1e+09 s between two rows"));
}

}  // namespace
}  // namespace morphe::imports
