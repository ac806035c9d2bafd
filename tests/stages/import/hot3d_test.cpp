#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "stages/import/trackers/umetrack_hand.hpp"
#include "tests/stages/import/recording_folder.hpp"

namespace morphe::imports {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;

/// A left hand that lies flat: fingers along +x, thumb's side +z, palm to -y, as UmeTrack's. All
/// joints of a finger bend about +z, which curls it to the palm.
json profile() {
  json axes = json::array(), points = json::array(), rest = json::array(), bones = json::array(),
       weights = json::array();
  std::vector<json> tips, joints;
  for (int finger = 0; finger < 5; ++finger) {
    const double z = 40 - 20 * finger;
    for (int joint = 0; joint < 4; ++joint) {
      axes.push_back({0, 0, -1});
      points.push_back({90 + 30 * std::max(0, joint - 1), 0, z});
    }
    tips.push_back({175, 0, z});
    for (int joint = 0; joint < 3; ++joint) joints.push_back({90 + 30 * joint, 0, z});
  }
  for (int wrist = 0; wrist < 2; ++wrist) {
    axes.push_back({1, 0, 0});
    points.push_back({0, 0, 0});
  }
  const auto landmark = [&](const json& at, int bone) {
    rest.push_back(at);
    bones.push_back({bone, 0, 0});
    weights.push_back({1, 0, 0});
  };
  for (int finger = 0; finger < 5; ++finger)
    landmark(tips[static_cast<std::size_t>(finger)], 4 + 3 * finger);
  landmark({0, 0, 0}, 1);
  landmark(joints[1], 2);  // the thumb has two
  landmark(joints[2], 3);
  for (int finger = 1; finger < 5; ++finger) {
    for (int joint = 0; joint < 3; ++joint) {
      landmark(joints[static_cast<std::size_t>(3 * finger + joint)], 2 + 3 * finger + joint);
    }
  }
  landmark({60, 0, 0}, 1);
  json model;
  model["hand_model"] = {{"joint_rotation_axes", axes},
                         {"joint_rest_positions", points},
                         {"landmark_rest_positions", rest},
                         {"landmark_rest_bone_indices", bones},
                         {"landmark_rest_bone_weights", weights}};
  return model;
}

std::string angles(double bent) {
  std::string text;
  for (int k = 0; k < 22; ++k) text += fmt::format("{}{}", k == 0 ? "" : ", ", k < 20 ? bent : 0);
  return "[" + text + "]";
}

std::string hand(const std::string& side, double x, double bent) {
  return fmt::format(R"("{}": {{"wrist_xform": {{"t_xyz": [{}, 1, 2], "q_wxyz": [1, 0, 0, 0]}}, )"
                     R"("joint_angles": {}, "hand_confidence": 0.9}})",
                     side, x, angles(bent));
}

std::string line(long stamp_ns, const std::string& hands) {
  return fmt::format(R"({{"timestamp_ns": {}, "hand_poses": {{{}}}}})", stamp_ns, hands) + "\n";
}

constexpr const char* kPoses =
    "object_uid,timestamp[ns],t_wo_x[m],t_wo_y[m],t_wo_z[m],q_wo_w,q_wo_x,q_wo_y,q_wo_z\n";

class Hot3d : public RecordingFolder {
 protected:
  Hot3d() {
    write(profile().dump(), "umetrack_hand_user_profile.json");
    say("Aria");
  }
  void say(const std::string& headset) {
    write(fmt::format(R"({{"headset": "{}", "participant_id": "P7", "object_uids": ["22"], )"
                      R"("object_names": ["mug"]}})",
                      headset),
          "metadata.json");
  }
  std::filesystem::path hands(const std::string& text) {
    return write(text, "umetrack_hand_pose_trajectory.jsonl");
  }
  static Vec3 joint(const Demonstration& d, const std::string& name, std::size_t row) {
    const BodyStream& body = *d.streams.skeleton;
    const auto at = std::ranges::find(body.names, name) - body.names.begin();
    return body.position(row, static_cast<std::size_t>(at));
  }
};

TEST_F(Hot3d, BothHandsBendToTheirPalms) {
  const double quarter = M_PI / 6;  // three of them are a right angle; each finger has four joints
  const Demonstration d =
      read(hands(line(100'000'000'000, hand("0", 0, 0) + "," + hand("1", 3, 0)) +
                 line(100'033'333'333, hand("1", 3, quarter))));
  EXPECT_EQ(d.subject, "P7");
  EXPECT_LT((joint(d, "left_index_tip", 0) - Vec3(0.175, 1, 2.020)).norm(), 1e-12);
  EXPECT_LT((joint(d, "right_index_tip", 0) - Vec3(3 - 0.175, 1, 2.020)).norm(), 1e-12);
  EXPECT_LT((joint(d, "right_wrist", 1) - Vec3(3, 1, 2)).norm(), 1e-12);
  EXPECT_FALSE(is_known(joint(d, "left_wrist", 1)));
  // Bent by 60, 90 and 120 degrees in all: two joints at the knuckle, one each beyond.
  const Vec3 knuckle(3 - 0.09, 1, 2.020);
  const Vec3 tip = knuckle + 0.030 * Vec3(-0.5, -std::sqrt(0.75), 0) + 0.030 * Vec3(0, -1, 0) +
                   0.025 * Vec3(0.5, -std::sqrt(0.75), 0);
  EXPECT_LT((joint(d, "right_index_tip", 1) - tip).norm(), 1e-12);
  EXPECT_LT((joint(d, "right_thumb_cmc", 1) - Vec3(3 - 0.09, 1, 2.040)).norm(), 1e-12);
  EXPECT_THAT(d.import_notes, Contains("the left hand is visible in 1 of 2 frames"));
}

TEST_F(Hot3d, FramesOfTheSecondCameraAreLeftOut) {
  const Demonstration d =
      read(hands(line(100'000'000'000, hand("1", 3, 0)) + line(100'000'080'000, hand("1", 3, 0)) +
                 line(100'033'333'333, hand("1", 3, 0))));
  EXPECT_EQ(d.streams.skeleton->time.size(), 2u);
  EXPECT_THAT(d.import_notes, Contains("1 frame skipped, within 10 ms of the previous one: from "
                                       "another camera"));
}

TEST_F(Hot3d, ObjectsAndTheHeadsetComeAlong) {
  say("Quest3");
  write(kPoses + std::string("22,100000000000,1,2,3,1,0,0,0\n33,100000000000,0,0,0,1,0,0,0\n"
                             "22,100033333333,1,2,4,1,0,0,0\n"),
        "dynamic_objects.csv");
  write(kPoses + std::string("9,100000000000,0,1.6,0,1,0,0,0\n"), "headset_trajectory.csv");
  const Demonstration d = read(hands(line(100'000'000'000, hand("1", 3, 0))));
  ASSERT_EQ(d.objects.size(), 2u);
  EXPECT_EQ(d.objects[0].name, "mug");
  EXPECT_EQ(d.objects[1].name, "object_33");
  EXPECT_LT((d.objects[0].position[1] - Vec3(1, -4, 2)).norm(), 1e-12);  // y is up
  EXPECT_LT((joint(d, "right_wrist", 0) - Vec3(3, -2, 1)).norm(), 1e-12);
  EXPECT_LT((joint(d, "head", 0) - Vec3(0, 0, 1.6)).norm(), 1e-12);
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("object mug: only its pose was recorded")));
}

TEST_F(Hot3d, AMeshBesideGivesTheShape) {
  write(kPoses + std::string("22,100000000000,1,2,3,1,0,0,0\n"), "dynamic_objects.csv");
  // A tetrahedron as glTF's binary form: a header, a chunk of JSON, a chunk of numbers.
  const float points[] = {0, 0, 0, 0.1F, 0, 0, 0, 0.1F, 0, 0, 0, 0.1F};
  const std::uint32_t sides[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
                     R"("nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
                     R"({"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":96}],)"
                     R"("bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},)"
                     R"({"buffer":0,"byteOffset":48,"byteLength":48}],"accessors":[)"
                     R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3",)"
                     R"("min":[0,0,0],"max":[0.1,0.1,0.1]},)"
                     R"({"bufferView":1,"componentType":5125,"count":12,"type":"SCALAR"}]})";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::uint32_t value) {
    return std::string(reinterpret_cast<const char*>(&value), 4);
  };
  const auto size = static_cast<std::uint32_t>(text.size());
  write("glTF" + word(2) + word(12 + 8 + size + 8 + 96) + word(size) + "JSON" + text + word(96) +
            std::string("BIN\0", 4) + std::string(reinterpret_cast<const char*>(points), 48) +
            std::string(reinterpret_cast<const char*>(sides), 48),
        "22.glb");
  const Demonstration d = read(hands(line(100'000'000'000, hand("1", 3, 0))));
  ASSERT_EQ(d.objects.size(), 1u);
  EXPECT_EQ(d.objects[0].name, "mug");
  EXPECT_EQ(d.objects[0].shape, Shape::mesh);
  EXPECT_EQ(d.objects[0].triangles.size(), 4u);
  EXPECT_EQ(d.objects[0].vertices.size(), 4u);
  EXPECT_EQ(d.objects[0].position.size(), 1u);
}

TEST_F(Hot3d, ErrorsSayWhere) {
  const std::string file = "umetrack_hand_pose_trajectory.jsonl";
  const std::string good = line(100'000'000'000, hand("1", 3, 0));
  const auto error = [&](const std::string& text) { return error_of(hands(text)); };
  EXPECT_EQ(error(good + line(99'000'000'000, hand("1", 3, 0))),
            file + ":2: timestamp_ns: must be greater than in the previous line");
  EXPECT_EQ(error(good + good.substr(0, 60)),
            file + ":2: is not a JSON object: the line is damaged or cut off");
  EXPECT_EQ(error(line(1, R"("1": {"joint_angles": []})")),
            file + ":1: hand_poses.1.wrist_xform: is missing");
  std::string text = good;
  text.replace(text.find("[1, 0, 0, 0]"), 12, "[2, 0, 0, 0]");
  EXPECT_EQ(error(text),
            file + ":1: hand_poses.1.wrist_xform.q_wxyz: is not a quaternion of unit length");
  text = good;
  text.replace(text.find("[3, 1, 2]"), 9, "[3, 1]");
  EXPECT_EQ(error(text), file + ":1: hand_poses.1.wrist_xform.t_xyz: must have 3 numbers, not 2");
  EXPECT_EQ(error("{\"timestamp_ns\": 1.5, \"hand_poses\": {}}\n"),
            file + ":1: timestamp_ns: must be a whole number");
  write("{}", "metadata.json");
  EXPECT_THAT(error(good), HasSubstr("axes: no metadata.json beside the file names the headset"));
  say("Aria");
  json bad = profile();
  bad["hand_model"]["joint_rotation_axes"].erase(3);
  write(bad.dump(), "umetrack_hand_user_profile.json");
  EXPECT_EQ(
      error(good),
      "umetrack_hand_user_profile.json: hand_model.joint_rotation_axes: must have 66 numbers, "
      "not 63");
  bad = profile();
  bad["hand_model"]["landmark_rest_bone_indices"][0][0] = 17;
  write(bad.dump(), "umetrack_hand_user_profile.json");
  EXPECT_THAT(error(good), HasSubstr("must be whole numbers from 0 to 16"));
  std::filesystem::remove(folder_ / "umetrack_hand_user_profile.json");
  EXPECT_EQ(error(good), file +
                             ": the hand model umetrack_hand_user_profile.json is missing "
                             "beside it");
}

TEST_F(Hot3d, ExchangedSidesAndOtherUnitsAreRefused) {
  // A left hand that bends away from its palm is a right one.
  EXPECT_THAT(error_of(hands(line(100'000'000'000, hand("0", 0, -0.5)))),
              HasSubstr("left hand: its fingers curl like those of a right hand"));
  Conventions feet;
  feet.unit = "0.3048";
  EXPECT_THAT(error_of(hands(line(100'000'000'000, hand("0", 0, 0.1))), feet),
              HasSubstr("unit: implausible: the left hand would measure 0.0"));
}

}  // namespace
}  // namespace morphe::imports
