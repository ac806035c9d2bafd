#include "stages/import/folders/marker_objects.hpp"

#include <gmock/gmock.h>

#include <random>

#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Vec3 kSize(0.4, 0.3, 0.1);

/// The corners of a box that turns about z and rises, and a marker that stands elsewhere.
struct Box {
  Demonstration demonstration;
  std::vector<Pose> truth;

  explicit Box(double noise_m = 0) {
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0, noise_m > 0 ? noise_m : 1);
    MarkerStream markers;
    for (int corner = 0; corner < 8; ++corner) {
      markers.names.push_back("box:" + std::to_string(corner));
    }
    markers.names.push_back("hand");
    markers.position = Array2D<Vec3>(100, 9, Vec3(1, 1, 1));
    for (std::size_t i = 0; i < 100; ++i) {
      const double t = 0.01 * static_cast<double>(i);
      markers.time.push_back(t);
      truth.push_back(make_pose(Vec3(0.1, 0.5, 0.2 * t),
                                Quat(Eigen::AngleAxisd(0.3 + 0.5 * t, Vec3::UnitZ()))));
      for (std::size_t corner = 0; corner < 8; ++corner) {
        const Vec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                        (corner & 4) != 0 ? 1 : -1);
        Vec3& point = markers.position(i, corner);
        point = truth[i] * Vec3(0.5 * sign.cwiseProduct(kSize));
        if (noise_m > 0) point += Vec3(noise(random), noise(random), noise(random));
      }
    }
    demonstration.streams.markers = std::move(markers);
  }
};

double worst_error(const Box& box, const SceneObject& found) {
  double worst = 0;
  for (std::size_t n = 0; n < found.time.size(); ++n) {
    const auto i = static_cast<std::size_t>(std::lround(100 * found.time[n]));
    worst = std::max({worst, (found.position[n] - box.truth[i].translation()).norm(),
                      angle_between(found.orientation[n], Quat(box.truth[i].linear()))});
  }
  return worst;
}

TEST(MarkerObjects, BoxMovesAsItsCorners) {
  Box box;
  add_marker_object("f", {"crate", {"box:*"}, "box", {}}, box.demonstration);
  const SceneObject& found = box.demonstration.objects.at(0);
  EXPECT_EQ(found.name, "crate");
  EXPECT_EQ(found.shape, Shape::box);
  ASSERT_EQ(found.time.size(), 100u);
  EXPECT_LT((Vec3(found.size.data()) - kSize).norm(), 1e-12);
  EXPECT_LT(worst_error(box, found), 1e-7);
  EXPECT_EQ(box.demonstration.streams.markers->names.size(), 9u);
  EXPECT_THAT(box.demonstration.import_notes,
              ElementsAre("crate: from 8 markers, RMS deviation from a rigid body 0.0 mm"));
}

TEST(MarkerObjects, GapsAndNoiseLeaveTheShapeAlone) {
  Box box(0.0005);
  MarkerStream& markers = *box.demonstration.streams.markers;
  for (std::size_t i = 0; i < 60; ++i) markers.position(i, i % 8) = unknown_point();
  for (std::size_t i = 70; i < 80; ++i) {
    for (std::size_t k = 0; k < 6; ++k) markers.position(i, k) = unknown_point();
  }
  add_marker_object("f", {"crate", {"box:*"}, "box", {}}, box.demonstration);
  const SceneObject& found = box.demonstration.objects.at(0);
  EXPECT_EQ(found.time.size(), 90u);
  EXPECT_LT((Vec3(found.size.data()) - kSize).norm(), 0.001);
  EXPECT_LT(worst_error(box, found), 0.01);
  EXPECT_THAT(box.demonstration.import_notes,
              ElementsAre(HasSubstr("not visible in 10 of 100 frames")));
}

TEST(MarkerObjects, GivenSizeAndShapeAreTaken) {
  Box box;
  add_marker_object("f", {"can", {"box:0", "box:1", "box:2"}, "cylinder", {0.03, 0.1}},
                    box.demonstration);
  EXPECT_EQ(box.demonstration.objects[0].shape, Shape::cylinder);
  EXPECT_THAT(box.demonstration.objects[0].size, ElementsAre(0.03, 0.1));
}

TEST(MarkerObjects, SaysWhatIsWrong) {
  const auto error_of = [](const MarkerObject& object) -> std::string {
    Box box;
    try {
      add_marker_object("f", object, box.demonstration);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of({"o", {"box:*", "lid*"}, "box", {}}),
            "f: objects: o: marker 'lid*' not found");
  EXPECT_EQ(error_of({"o", {"box:1", "box:2"}, "box", {1, 1, 1}}),
            "f: objects: o: in no frame are three of its markers visible that are not on a line");
  EXPECT_EQ(error_of({"o", {"box:0", "box:1", "box:2"}, "box", {}}),
            "f: objects: o: its markers are in one plane; give its size");
  EXPECT_EQ(validation_error(MarkerObject{"o", {}, "ball", {}}),
            "shape must be sphere, box, cylinder or capsule, not 'ball'");
  EXPECT_EQ(validation_error(MarkerObject{"o", {}, "sphere", {}}), "a sphere needs a size");
  EXPECT_EQ(validation_error(MarkerObject{"o", {}, "box", {1, 1}}),
            "the size of a box must be 3 lengths");
}

/// Rows between which a marker of the box is faster than 50 mm/s, read from the text with Python:
/// 161 to 394. Two recordings hold the same box.
TEST_F(RecordingFolder, ShippedBoxMovesAsItsMarkers) {
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/pyomeca/recordings.yaml"};
  std::vector<Demonstration> all;
  import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  const SceneObject& box = all.at(0).objects.at(0);
  EXPECT_LT((Vec3(box.size.data()) - Vec3(all[1].objects.at(0).size.data())).norm(), 0.001);
  ASSERT_EQ(box.time.size(), 580u);
  const auto pose = [&](std::size_t i) { return make_pose(box.position[i], box.orientation[i]); };
  const Vec3 in_box = pose(0).inverse() * all[0].streams.markers->position(0, 5);
  std::size_t first = 0, last = 0;
  for (std::size_t i = 1; i < 580; ++i) {
    if (100 * (pose(i) * in_box - pose(i - 1) * in_box).norm() < 0.05) continue;
    if (first == 0) first = i;
    last = i;
  }
  EXPECT_NEAR(static_cast<double>(first), 161, 2);
  EXPECT_NEAR(static_cast<double>(last), 394, 2);
}

}  // namespace
}  // namespace morphe::imports
