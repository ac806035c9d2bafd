#include <gmock/gmock.h>

#include "tests/stages/import/c3d_text.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const Conventions kC3d{"x y z", "", {}};

class C3d : public RecordingFolder {
 protected:
  std::filesystem::path write(const C3dText& c3d) {
    return RecordingFolder::write(c3d.text(), "trial.c3d");
  }
};

/// Quarters of a millimetre are exact in every way of writing.
C3dText three_frames() {
  C3dText c3d;
  c3d.frames = {{{100.25, -20, 3}, {-1000, 0.5, 2047.75}},
                {unknown_point(), {1, 2, 3}},
                {{110, -30.5, 5}, {4, 5, 6}}};
  return c3d;
}

struct Writing {
  int processor;
  double scale;
  int analog;
};
class C3dWriting : public C3d, public testing::WithParamInterface<Writing> {};

TEST_P(C3dWriting, GivesTheSamePoints) {
  C3dText c3d = three_frames();
  c3d.processor = GetParam().processor;
  c3d.scale = GetParam().scale;
  c3d.analog = GetParam().analog;
  c3d.analog_per_frame = c3d.analog / 3;
  const Demonstration d = read(write(c3d), kC3d);
  const MarkerStream& markers = *d.streams.markers;
  EXPECT_THAT(markers.names, ElementsAre("A", "B"));
  EXPECT_THAT(markers.time, ElementsAre(0, 0.01, 0.02));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const Vec3& truth = c3d.frames[i][k];
      if (!is_known(truth)) {
        EXPECT_FALSE(is_known(markers.position(i, k)));
      } else {
        EXPECT_LT((markers.position(i, k) - truth / 1000).norm(), 1e-12) << i << " " << k;
      }
    }
  }
  EXPECT_THAT(d.import_notes, ElementsAre());
}

INSTANTIATE_TEST_SUITE_P(All, C3dWriting,
                         testing::Values(Writing{84, -1, 0}, Writing{84, 0.25, 0},
                                         Writing{84, -1, 12}, Writing{84, 0.25, 12},
                                         Writing{85, -1, 0}, Writing{85, 0.25, 3},
                                         Writing{86, -1, 6}, Writing{86, 0.25, 0}));

/// Numbers that Python read from the bytes.
TEST_F(C3d, PropulsionMatchesItsBytes) {
  ImportRequest request;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) /
                   "datasets/kineticstoolkit/recordings.yaml"};
  const Demonstration d = read(request);
  const MarkerStream& markers = *d.streams.markers;
  ASSERT_EQ(markers.time.size(), 700u);
  ASSERT_EQ(markers.names.size(), 41u);
  EXPECT_EQ(markers.names[40], "RHAN3");
  EXPECT_EQ(markers.names[33], "RLEP");
  EXPECT_NEAR(markers.time.back(), 699 / 69.99261474609375, 1e-12);
  EXPECT_LT(
      (markers.position(0, 40) - Vec3(0.2515324056148529, -0.9149888753890991, 0.9688568115234375))
          .norm(),
      1e-15);
  EXPECT_LT((markers.position(699, 40) -
             Vec3(0.1857684850692749, -0.5875105261802673, 0.6192331910133362))
                .norm(),
            1e-15);
  std::size_t seen_points = 0, gaps = 0;
  for (std::size_t k = 0; k < 41; ++k) {
    bool before = true;
    for (std::size_t i = 0; i < 700; ++i) {
      const bool now = is_known(markers.position(i, k));
      if (now) ++seen_points;
      if (before && !now) ++gaps;
      before = now;
    }
  }
  EXPECT_EQ(seen_points, 22316u);
  EXPECT_EQ(gaps, 234u);
  EXPECT_THAT(d.import_notes,
              ElementsAre("never visible: Probe1, Probe2, Probe3, Probe4, Probe5, Probe6",
                          HasSubstr("no static trial: joint centres")));
}

TEST_F(C3d, MoreFramesThanAWordHolds) {
  C3dText c3d = three_frames();
  c3d.frames.assign(70000, c3d.frames[0]);
  c3d.trial_fields = true;
  const Demonstration d = read(write(c3d), kC3d);
  EXPECT_EQ(d.streams.markers->time.size(), 70000u);
  EXPECT_EQ(d.streams.markers->time.back(), 699.99);
}

/// As OptiTrack's Motive writes it: nobody says where points begin.
TEST_F(C3d, DataStartZeroIsBehindTheParameters) {
  std::string text = three_frames().text();
  const std::size_t header_word = 16, value = text.find("DATA_START") + 10 + 4;
  for (const std::size_t at : {header_word, value}) text[at] = text[at + 1] = '\0';
  const Demonstration d = read(RecordingFolder::write(text, "trial.c3d"), kC3d);
  const Demonstration whole = read(write(three_frames()), kC3d);
  EXPECT_EQ(d.streams.markers->position(2, 0), whole.streams.markers->position(2, 0));
  EXPECT_EQ(d.streams.markers->time, whole.streams.markers->time);
  EXPECT_THAT(d.import_notes, ElementsAre(HasSubstr("read from block 4, after the parameters")));
  text[512 + 2] = '\xff';  // 255 blocks of parameters, which the file does not have
  EXPECT_THAT(error_of(RecordingFolder::write(text, "trial.c3d"), kC3d),
              HasSubstr("trial.c3d: POINT:FRAMES: 3 frames are stated from byte"));
}

TEST_F(C3d, LaterFirstFrameIsLater) {
  C3dText c3d = three_frames();
  c3d.first = 51;
  EXPECT_EQ(read(write(c3d), kC3d).streams.markers->time.front(), 0.5);
}

TEST_F(C3d, AxesFromTheScreenAreReportedAndGivenWay) {
  C3dText c3d = three_frames();
  EXPECT_THAT(error_of(write(c3d)), HasSubstr("trial.c3d: axes: the file does not state"));
  c3d.x_screen = "+X";
  c3d.y_screen = "+Z";
  Demonstration d = read(write(c3d));
  EXPECT_EQ(d.streams.markers->position(2, 0), Vec3(0.110, -0.0305, 0.005));
  EXPECT_THAT(d.import_notes, ElementsAre(HasSubstr("axes 'x y z' from POINT:X_SCREEN")));
  c3d.x_screen = "-Z";
  c3d.y_screen = "Y";  // forward = up x right = Y x -Z = -X
  d = read(write(c3d));
  EXPECT_EQ(d.streams.markers->position(2, 0), Vec3(-0.005, -0.110, -0.0305));
  d = read(write(c3d), kC3d);
  EXPECT_EQ(d.streams.markers->position(2, 0), Vec3(0.110, -0.0305, 0.005));
}

TEST_F(C3d, UnitIsTheFilesOrAskedFor) {
  C3dText c3d = three_frames();
  c3d.units = "";
  EXPECT_THAT(error_of(write(c3d), kC3d), HasSubstr("trial.c3d: unit: not in the file"));
  EXPECT_EQ(read(write(c3d), {"x y z", "cm", {}}).streams.markers->position(2, 1),
            Vec3(0.04, 0.05, 0.06));
  c3d.units = "m";
  EXPECT_THAT(error_of(write(c3d), kC3d),
              HasSubstr("trial.c3d: unit: implausible: the markers extend over"));
  const Demonstration d = read(write(c3d), {"x y z", "mm", {}});
  EXPECT_THAT(d.import_notes, ElementsAre("unit m in the file; the given mm is used"));
  c3d.units = "ell";
  EXPECT_THAT(error_of(write(c3d), kC3d),
              HasSubstr("trial.c3d: unit: 'ell' in the file is unknown"));
}

TEST_F(C3d, LiesAreErrorsOrReported) {
  const C3dText honest = three_frames();
  const std::string text = honest.text();
  const auto with = [&](std::size_t offset, std::size_t value) {
    return RecordingFolder::write(std::string(text).replace(offset, 2, honest.word(value)),
                                  "trial.c3d");
  };
  const auto value_of = [&](const std::string& name, std::size_t behind) {
    return text.find(name) + name.size() + behind;
  };
  EXPECT_EQ(error_of(with(2, 3), kC3d), "trial.c3d: POINT:USED: 2 points here, 3 in the header");
  EXPECT_THAT(error_of(with(4, 5), kC3d), HasSubstr("trial.c3d: ANALOG:USED: 0 channels"));
  EXPECT_THAT(error_of(with(0, 0x507f), kC3d), HasSubstr("byte 64512: the parameter section"));
  EXPECT_THAT(error_of(with(514, 80 * 256), kC3d), HasSubstr("byte 515: processor 80 is unknown"));
  const std::size_t frames = value_of("FRAMES", 4);
  EXPECT_EQ(error_of(with(frames, 5), kC3d),
            "trial.c3d: POINT:FRAMES: 5 frames are stated from byte 1536 on, but the file has 3");
  EXPECT_THAT(error_of(with(frames, 0), kC3d), HasSubstr("POINT:FRAMES: 0 frames"));
  EXPECT_THAT(read(with(frames, 2), kC3d).import_notes,
              ElementsAre("the header states 3 frames; 2 were read"));
  EXPECT_THAT(error_of(with(value_of("DATA_START", 4), 999), kC3d), HasSubstr("the file has 0"));
  EXPECT_THAT(error_of(with(value_of("LABELS", 5), 200), kC3d),
              HasSubstr("parameter LABELS overlaps the next one"));
}

TEST_F(C3d, LabelsThatLack) {
  C3dText c3d = three_frames();
  c3d.labels = {"A"};
  const Demonstration d = read(write(c3d), kC3d);
  EXPECT_THAT(d.streams.markers->names, ElementsAre("A", "*2"));
  EXPECT_THAT(d.import_notes, ElementsAre("points without a name: 1"));
}

TEST_F(C3d, PointsThatAreNoPointsWereNotSeen) {
  C3dText c3d = three_frames();
  c3d.frames.assign(3, {Vec3::Zero(), unknown_point()});
  const Demonstration d = read(write(c3d), kC3d);
  EXPECT_THAT(d.import_notes,
              ElementsAre("3 points are exactly at the origin; treated as not visible",
                          "no marker is visible in any frame"));
}

/// No length in the file is believed: cut anywhere it is refused; with any byte changed it is
/// refused by name, or read with one point at most another than it was.
TEST_F(C3d, DamageIsNeverACrash) {
  const std::string text = three_frames().text();
  const auto markers_of = [&](const std::filesystem::path& file) {
    return read(file, kC3d).streams.markers.value();
  };
  const MarkerStream honest = markers_of(RecordingFolder::write(text, "trial.c3d"));
  for (std::size_t length = 0; length < text.size(); length += 61) {
    EXPECT_NE(error_of(RecordingFolder::write(text.substr(0, length), "trial.c3d"), kC3d),
              "no error")
        << length;
  }
  const auto same_point = [](const Vec3& a, const Vec3& b) {
    return a == b || (!is_known(a) && !is_known(b));
  };
  int refused = 0, read_anyway = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == 0) continue;
    std::string damaged = text;
    damaged[at] = at % 2 == 0 ? '\x7f' : '\xff';
    const std::filesystem::path file = RecordingFolder::write(damaged, "trial.c3d");
    const std::string error = error_of(file, kC3d);
    if (error != "no error") {
      ++refused;
      EXPECT_THAT(error, StartsWith("trial.c3d:")) << at;
      continue;
    }
    ++read_anyway;
    const MarkerStream found = markers_of(file);
    EXPECT_EQ(found.time.size(), honest.time.size()) << at;
    ASSERT_EQ(found.position.values.size(), honest.position.values.size()) << at;
    int others = 0;
    for (std::size_t k = 0; k < honest.position.values.size(); ++k)
      others += same_point(found.position.values[k], honest.position.values[k]) ? 0 : 1;
    EXPECT_LE(others, 1) << at;
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(read_anyway, 50);
}

TEST_F(C3d, QuantitiesThatAreNoPlacesAreLeftOut) {
  C3dText c3d = three_frames();
  c3d.labels = {"S:RWRA", "S:RWristAngles", "S:RElbowMoment"};
  for (auto& frame : c3d.frames) frame.push_back({170, -20, 30});
  c3d.angles = {"RWristAngles"};  // listed without the subject
  c3d.moments2 = {"S:RElbowMoment"};
  const Demonstration d = read(write(c3d), kC3d);
  EXPECT_THAT(d.streams.markers->names, ElementsAre("S:RWRA"));
  EXPECT_LT((d.streams.markers->position(2, 0) - Vec3(0.110, -0.0305, 0.005)).norm(), 1e-12);
  EXPECT_THAT(d.import_notes,
              testing::Contains("points skipped, no places according to POINT:ANGLES, "
                                "POINT:MOMENTS: S:RWristAngles, S:RElbowMoment"));
  c3d.angles = {"S:RWRA", "RWristAngles"};
  EXPECT_THAT(error_of(write(c3d), kC3d), HasSubstr("no point is a place"));
}

TEST_F(C3d, ALabelThatStandsTwiceIsNumbered) {
  C3dText c3d = three_frames();
  c3d.labels = {"RTHI", "RTHI"};
  const Demonstration d = read(write(c3d), kC3d);
  EXPECT_THAT(d.streams.markers->names, ElementsAre("RTHI", "RTHI_2"));
  EXPECT_THAT(d.import_notes,
              testing::Contains("the name RTHI stands more than once; another is called RTHI_2"));
}

TEST_F(C3d, ParametersEndWithTheirSection) {
  for (const int processor : {84, 85, 86}) {
    C3dText c3d = three_frames();
    c3d.processor = processor;
    c3d.last_pointer_leaves_section = true;
    EXPECT_EQ(read(write(c3d), kC3d).streams.markers->time.size(), 3u) << processor;
  }
}

TEST_F(C3d, AFrameTooManyIsNotMissed) {
  C3dText c3d = three_frames();
  c3d.extra_frames = 1;
  const Demonstration d = read(write(c3d), kC3d);
  EXPECT_EQ(d.streams.markers->time.size(), 3u);
  EXPECT_THAT(d.import_notes,
              testing::Contains("4 frames are stated, the file has 3; these were read"));
}

}  // namespace
}  // namespace morphe::imports
