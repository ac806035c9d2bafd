#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/store/hdf5_file.hpp"
#include "stages/import/trackers/apple_hand.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::HasSubstr;

Vec3 joint_in(const Demonstration& d, const std::string& name, std::size_t row) {
  const BodyStream& body = *d.streams.skeleton;
  const auto at = std::ranges::find(body.names, name) - body.names.begin();
  return at == std::ssize(body.names) ? unknown_point()
                                      : body.position(row, static_cast<std::size_t>(at));
}

/// In the wrist's frame of a right hand: fingers along -x, thumb's side +z, palm -y.
Vec3 in_wrist(std::size_t keypoint, double bent = 0) {
  if (keypoint == 0) return Vec3::Zero();
  const std::size_t finger = (keypoint - 1) / 4, part = (keypoint - 1) % 4;
  return {-0.09 - 0.03 * static_cast<double>(part), part == 3 ? -bent : 0,
          0.04 - 0.02 * static_cast<double>(finger)};
}

TEST(AppleHand, NamesInAllTheirForms) {
  for (const char* name : {"indexFingerKnuckle", "IndexKnuckle", "index_knuckle"}) {
    EXPECT_EQ(normalized_apple_name(name), "indexknuckle");
  }
  EXPECT_EQ(apple_joints()[1], "thumbknuckle");
  EXPECT_EQ(apple_joints()[5], "indexknuckle");
  EXPECT_EQ(apple_joints()[20], "littletip");
}

TEST(AppleHand, OnlyRigidMotionsAreTaken) {
  std::vector<double> m{0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
  EXPECT_LT((pose_from_matrix(m, false)->translation() - Vec3(5, 6, 7)).norm(), 1e-12);
  EXPECT_FALSE(pose_from_matrix(m, true));  // its last row is none
  m[0] = 0.2;
  EXPECT_FALSE(pose_from_matrix(m, false));
  EXPECT_FALSE(pose_from_matrix({-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, false));
}

class AvpJsonl : public RecordingFolder {
 protected:
  static std::string matrix(const Vec3& at) {
    return fmt::format("[1,0,0,0, 0,1,0,0, 0,0,1,0, {},{},{},1]", at.x(), at.y(), at.z());
  }
  static std::string hand(const Vec3& wrist, double bent = 0) {
    std::string text = "\"wrist\": " + matrix(wrist);
    for (std::size_t k = 1; k < kKeypointCount; ++k) {
      text += fmt::format(", \"{}\": {}", apple_joints()[k], matrix(in_wrist(k, bent)));
    }
    return "{" + text + "}";
  }
  static std::string line(double time_s, const std::string& hands) {
    return fmt::format(R"({{"timestamp": {}, "headMatrix": {}{}}})", time_s, matrix({0, 1.6, 0}),
                       hands) +
           "\n";
  }
  std::filesystem::path tracking(const std::string& text) { return write(text, "tracking.jsonl"); }
};

TEST_F(AvpJsonl, TheWristCarriesTheFingers) {
  const Demonstration d =
      read(tracking(line(0.5, ", \"rightHand\": " + hand({0.2, 1.0, -0.4})) + line(0.6, "")));
  // Y is up, -Z forward.
  EXPECT_LT((joint_in(d, "right_wrist", 0) - Vec3(0.2, 0.4, 1.0)).norm(), 1e-12);
  EXPECT_LT((joint_in(d, "right_index_tip", 0) - Vec3(0.02, 0.38, 1.0)).norm(), 1e-12);
  EXPECT_LT((joint_in(d, "head", 1) - Vec3(0, 0, 1.6)).norm(), 1e-12);
  EXPECT_FALSE(is_known(joint_in(d, "right_wrist", 1)));
  EXPECT_THAT(d.import_notes, Contains("the left hand is never visible"));
  EXPECT_THAT(d.import_notes, Contains("the right hand is visible in 1 of 2 frames"));
}

TEST_F(AvpJsonl, ErrorsSayWhere) {
  const std::string good = line(0.5, ", \"rightHand\": " + hand({0.2, 1.0, -0.4}));
  const auto error = [&](const std::string& text) { return error_of(tracking(text)); };
  EXPECT_EQ(error(good + line(0.4, ", \"rightHand\": " + hand({0.2, 1.0, -0.4}))),
            "tracking.jsonl:2: timestamp: must be greater than in the previous row");
  std::string text = good;
  text.replace(text.find("[1,0,0,0"), 8, "[2,0,0,0");
  EXPECT_EQ(error(text),
            "tracking.jsonl:1: headMatrix: is not a rigid transform in column-major order");
  text = good;
  text.replace(text.find("1]"), 2, "1,1]");
  EXPECT_EQ(error(text), "tracking.jsonl:1: headMatrix: must have 16 numbers, not 17");
  text = good;
  text.replace(text.find("\"timestamp\": 0.5"), 16, "\"timestamp\": \"x\"");
  EXPECT_EQ(error(text), "tracking.jsonl:1: timestamp: must contain only finite numbers");
  for (std::size_t length = 100; length < good.size() - 2; length += 101) {
    EXPECT_THAT(error(good + good.substr(0, length)), HasSubstr("tracking.jsonl:2: ")) << length;
  }
  EXPECT_THAT(error(line(0, ", \"leftHand\": " + hand({0, 0, 0}, 0.05))),
              HasSubstr("left hand: its fingers curl like those of a right hand"));
}

class EgodexHdf5 : public RecordingFolder {
 protected:
  /// N rows of unit matrices at a place; the hand's joints are the wrist's, moved.
  static store::Hdf5Array<double> track(const Vec3& at, std::size_t rows = 3) {
    store::Hdf5Array<double> all{{rows, 4, 4}, {}};
    for (std::size_t i = 0; i < rows; ++i) {
      for (const double v :
           {1.0, 0.0, 0.0, at.x(), 0.0, 1.0, 0.0, at.y() + 0.1 * static_cast<double>(i), 0.0, 0.0,
            1.0, at.z(), 0.0, 0.0, 0.0, 1.0}) {
        all.values.push_back(v);
      }
    }
    return all;
  }
  std::filesystem::path episode(const std::string& changed = "", const Vec3& scale = Vec3::Ones(),
                                std::size_t rows = 3) {
    const std::filesystem::path file = folder_ / "0.hdf5";
    store::Hdf5File out = store::Hdf5File::create(file);
    const store::Hdf5Group root = out.root();
    root.set("task", std::string("fold"));
    root.create("camera");
    const store::Hdf5Group transforms = root.create("transforms"),
                           sure = root.create("confidences");
    const Vec3 wrist(0.2, 1.0, -0.4);
    const auto put = [&](const std::string& name, const Vec3& at) {
      transforms.write(name, name == changed ? track(at.cwiseProduct(scale), rows) : track(at));
      sure.write(name, store::Hdf5Array<double>{{3}, {1, 0.5, name == "rightHand" ? 0.0 : 0.2}});
    };
    put("camera", {0, 1.6, 0});
    put("hip", {0, 0.8, 0});
    put("rightArm", {0.2, 1.4, 0});
    put("rightForearm", {0.2, 1.1, 0});
    put("rightHand", wrist);
    const char* parts[] = {"Knuckle", "IntermediateBase", "IntermediateTip", "Tip"};
    const char* fingers[] = {"Thumb", "IndexFinger", "MiddleFinger", "RingFinger", "LittleFinger"};
    for (std::size_t k = 1; k < kKeypointCount; ++k) {
      put(std::string("right") + fingers[(k - 1) / 4] + parts[(k - 1) % 4], wrist + in_wrist(k));
    }
    out.close();
    return file;
  }
};

TEST_F(EgodexHdf5, AnArmAndAHandInTheWorld) {
  const Demonstration d = read(episode());
  EXPECT_EQ(d.streams.skeleton->time, (std::vector<double>{0, 1 / 30.0, 2 / 30.0}));
  EXPECT_LT((joint_in(d, "right_shoulder", 0) - Vec3(0.2, 0, 1.4)).norm(), 1e-12);
  EXPECT_LT((joint_in(d, "right_elbow", 1) - Vec3(0.2, 0, 1.2)).norm(), 1e-12);
  EXPECT_LT((joint_in(d, "right_wrist", 1) - Vec3(0.2, 0.4, 1.1)).norm(), 1e-12);
  EXPECT_LT((joint_in(d, "right_little_tip", 0) - Vec3(0.02, 0.4 + 0.04, 1.0)).norm(), 1e-12);
  EXPECT_FALSE(is_known(joint_in(d, "right_wrist", 2)));  // no confidence
  EXPECT_TRUE(is_known(joint_in(d, "right_little_tip", 2)));
  EXPECT_THAT(d.streams.skeleton->names, Contains("head"));
  EXPECT_THAT(d.streams.skeleton->names, Contains("pelvis"));
  EXPECT_THAT(d.import_notes, Contains("task: fold"));
  EXPECT_THAT(d.import_notes, Contains("the left hand is never visible"));
}

TEST_F(EgodexHdf5, ErrorsSayWhere) {
  EXPECT_THAT(error_of(episode("rightIndexFingerTip", Vec3::Ones(), 2)),
              HasSubstr("0.hdf5:/transforms/rightIndexFingerTip: "));
  const std::filesystem::path whole = episode();
  const auto size = std::filesystem::file_size(whole);
  for (const double share : {0.3, 0.6, 0.9, 0.999}) {
    episode();
    std::filesystem::resize_file(whole,
                                 static_cast<std::uintmax_t>(share * static_cast<double>(size)));
    EXPECT_THAT(error_of(whole), HasSubstr("0.hdf5")) << share;
  }
}

TEST_F(EgodexHdf5, AFolderOfEpisodesIsADataset) {
  episode();
  write("not a recording", "0.mp4");
  ImportRequest request;
  request.paths = {folder_};
  std::vector<Demonstration> all;
  const ImportResult imported =
      import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].hand, Side::right);
}

}  // namespace
}  // namespace morphe::imports
