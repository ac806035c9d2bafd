// A recording of two hands, as two demonstrations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/motion/input_error.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path kAllShipped = fs::path(MORPHE_SOURCE_DIR) / "datasets";
const fs::path kStanding = kAllShipped / "pybvh/bvh_test3.bvh";  // five fingers a hand

std::vector<Demonstration> read(const ImportRequest& request, ImportResult* imported = nullptr) {
  std::vector<Demonstration> all;
  ImportResult what =
      import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  if (imported != nullptr) *imported = std::move(what);
  return all;
}

std::vector<std::string> names_of_all(const std::vector<Demonstration>& all) {
  std::vector<std::string> names;
  for (const Demonstration& d : all) names.push_back(d.name);
  return names;
}

ImportRequest both(const fs::path& path) {
  ImportRequest request;
  request.paths = {path};
  request.hand = HandSelection::both;
  request.name_map = fs::path(MORPHE_SOURCE_DIR) / "configs/names/five_fingers.yaml";
  request.conventions.axes = "x y z";  // as its manifest says
  request.conventions.unit = "in";
  return request;
}

TEST(BothHands, AreADemonstrationEach) {
  ImportResult imported;
  const auto all = read(both(kStanding), &imported);
  ASSERT_THAT(names_of_all(all), ElementsAre("bvh_test3_right", "bvh_test3_left"));
  EXPECT_EQ(all[0].hand, Side::right);
  EXPECT_EQ(all[1].hand, Side::left);
  ASSERT_TRUE(all[0].streams.skeleton && all[1].streams.skeleton);
  EXPECT_EQ(all[0].streams.skeleton->names, all[1].streams.skeleton->names);
  // What is written as a manifest reads the same.
  const fs::path folder = fs::path(testing::TempDir()) / "both_hands";
  fs::create_directories(folder);
  std::ofstream(folder / "recordings.yaml") << manifest_text(imported.entries, folder);
  ImportRequest again;
  again.paths = {folder / "recordings.yaml"};
  EXPECT_EQ(names_of_all(read(again)), names_of_all(all));
  std::ofstream(folder / "recordings.yaml")
      << "recordings:\n  - {file: " << kStanding.string()
      << ", hand: both, name: person, axes: x y z, unit: in}\n";
  EXPECT_THAT(names_of_all(read(again)), ElementsAre("person_right", "person_left"));
  fs::remove_all(folder);
}

TEST(BothHands, OfARecordingOfOneHandAreAnErrorButInAFolderThatHand) {
  const fs::path door = kAllShipped / "adroit-dapg/door_demo_06.csv";
  try {
    ImportRequest request;
    request.paths = {door};
    request.hand = HandSelection::both;
    read(request);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("hand: is both, but no point name belongs to the right"));
  }
  const fs::path folder = fs::path(testing::TempDir()) / "both_hands_folder";
  fs::create_directories(folder);
  fs::copy_file(door, folder / "door.csv", fs::copy_options::overwrite_existing);
  fs::copy_file(kStanding, folder / "gestures.bvh", fs::copy_options::overwrite_existing);
  EXPECT_THAT(names_of_all(read(both(folder))),
              ElementsAre("door", "gestures_right", "gestures_left"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace morphe::imports
