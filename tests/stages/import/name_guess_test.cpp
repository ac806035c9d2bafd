#include <gmock/gmock.h>

#include <map>

#include "stages/import/guess/name_guess.hpp"
#include "stages/import/guess/recorded_name.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

using Names = std::map<std::string, std::string>;

Names points(const std::vector<std::string>& names, Side hand = Side::right) {
  const GuessedNames guessed = guess_points(names, hand);
  return {guessed.begin(), guessed.end()};
}

/// Each joint the child of the one before it, unless a name says "child<parent".
Names joints(const std::vector<std::string>& chain, Side hand = Side::right) {
  std::vector<std::string> names, parents;
  for (const std::string& entry : chain) {
    const std::size_t sign = entry.find('<');
    names.push_back(entry.substr(0, sign));
    parents.push_back(sign != std::string::npos ? entry.substr(sign + 1)
                      : names.size() > 1        ? names[names.size() - 2]
                                                : "");
  }
  const GuessedNames guessed = guess_joints(names, parents, hand);
  return {guessed.begin(), guessed.end()};
}

TEST(RecordedName, IsTakenApart) {
  const RecordedName parsed = parse_recorded_name("mixamorig:RightHandIndex3_end");
  for (const BodyTerm term : {BodyTerm::right, BodyTerm::hand, BodyTerm::index, BodyTerm::tip}) {
    EXPECT_TRUE(parsed.has(term));
  }
  EXPECT_EQ(parsed.numbers, std::vector<int>{3});
  EXPECT_FALSE(parsed.has_unknown_word);
  EXPECT_TRUE(parse_recorded_name("RELB").has(BodyTerm::elbow));
  EXPECT_TRUE(parse_recorded_name("RELB").has(BodyTerm::right));
  EXPECT_FALSE(parse_recorded_name("cup_handle").has(BodyTerm::hand));
  EXPECT_TRUE(parse_recorded_name("cup_handle").has_unknown_word);
  EXPECT_TRUE(parse_recorded_name(std::string(10000, 'l')).has_unknown_word);
}

TEST(NameGuess, PointsOfJointsInSeveralTongues) {
  const Names english =
      points({"Shoulder_R", "elbow R", "RightWrist", "R.thumb.tip", "r_index_tip",
              "right_index_knuckle", "cup", "ring_stand", "table_1", "right_chest"});
  EXPECT_EQ(english, (Names{{"Shoulder_R", "right_shoulder"},
                            {"elbow R", "right_elbow"},
                            {"RightWrist", "right_wrist"},
                            {"R.thumb.tip", "right_thumb_tip"},
                            {"r_index_tip", "right_index_tip"},
                            {"right_index_knuckle", "right_index_mcp"}}));
  EXPECT_EQ(points({"Schulter", "Ellbogen", "Handgelenk", "Daumen", "Zeigefinger"}, Side::left),
            (Names{{"Schulter", "left_shoulder"},
                   {"Ellbogen", "left_elbow"},
                   {"Handgelenk", "left_wrist"},
                   {"Daumen", "left_thumb_tip"},
                   {"Zeigefinger", "left_index_tip"}}));
}

TEST(NameGuess, ClustersAndLandmarksAreMarkers) {
  EXPECT_EQ(points({"UpperArm_1", "UpperArm_2", "UpperArm_3", "Forearm_1", "Forearm_2", "Forearm_3",
                    "Hand_1", "Hand_2", "Hand_3", "elbow_lat", "elbow_med", "radial_styloid",
                    "ulnar_styloid", "acromion", "thumb_nail", "index_nail", "index_mcp"}),
            (Names{{"UpperArm_1", "RUAR1"},
                   {"UpperArm_2", "RUAR2"},
                   {"UpperArm_3", "RUAR3"},
                   {"Forearm_1", "RLAR1"},
                   {"Forearm_2", "RLAR2"},
                   {"Forearm_3", "RLAR3"},
                   {"Hand_1", "RHAN1"},
                   {"Hand_2", "RHAN2"},
                   {"Hand_3", "RHAN3"},
                   {"elbow_lat", "RLEP"},
                   {"elbow_med", "RMEP"},
                   {"radial_styloid", "RSPR"},
                   {"ulnar_styloid", "RSPU"},
                   {"acromion", "RGTH"},
                   {"thumb_nail", "RTHUM"},
                   {"index_nail", "RFTP"},
                   {"index_mcp", "RFB"}}));
}

TEST(NameGuess, MarkersOfPlugInGait) {
  EXPECT_EQ(points({"LSHO", "RSHO", "RELB", "RWRA", "RWRB", "RFIN", "RFHD"}),
            (Names{{"LSHO", "left_shoulder"},
                   {"RSHO", "right_shoulder"},
                   {"RELB", "right_elbow"},
                   {"RWRA", "right_wrist"},
                   {"RFIN", "right_index_mcp"}}));
}

TEST(NameGuess, NumberedPointsAreAHandIfThereAreTwentyOne) {
  std::vector<std::string> names;
  for (int k = 20; k >= 0; --k) names.push_back("landmark_" + std::to_string(k));
  const Names hand = points(names, Side::left);
  EXPECT_EQ(hand.size(), 21u);
  EXPECT_EQ(hand.at("landmark_0"), "left_wrist");
  EXPECT_EQ(hand.at("landmark_4"), "left_thumb_tip");
  EXPECT_EQ(hand.at("landmark_17"), "left_little_mcp");
  names.pop_back();
  EXPECT_EQ(points(names), Names{});
}

TEST(NameGuess, SkeletonsOfFourPrograms) {
  const auto expect_arm = [&](const Names& found, const char* shoulder, const char* elbow,
                              const char* wrist) {
    EXPECT_EQ(found.at(shoulder), "right_shoulder");
    EXPECT_EQ(found.at(elbow), "right_elbow");
    EXPECT_EQ(found.at(wrist), "right_wrist");
  };
  expect_arm(joints({"mixamorig:Spine2", "mixamorig:RightShoulder", "mixamorig:RightArm",
                     "mixamorig:RightForeArm", "mixamorig:RightHand"}),
             "mixamorig:RightArm", "mixamorig:RightForeArm", "mixamorig:RightHand");
  expect_arm(joints({"Chest4", "RightCollar", "RightShoulder", "RightElbow", "RightWrist"}),
             "RightShoulder", "RightElbow", "RightWrist");
  expect_arm(joints({"clavicle_r", "upperarm_r", "lowerarm_r", "hand_r"}), "upperarm_r",
             "lowerarm_r", "hand_r");
  expect_arm(joints({"Bip01 R Clavicle", "Bip01 R UpperArm", "Bip01 R Forearm", "Bip01 R Hand"}),
             "Bip01 R UpperArm", "Bip01 R Forearm", "Bip01 R Hand");
}

TEST(NameGuess, OtherLanguages) {
  const Names japanese = joints({"上半身", "右肩", "右腕", "右ひじ", "右手首", "右人指１",
                                 "右人指２", "右人指３", "右人指先"});
  EXPECT_EQ(japanese, (Names{{"右腕", "right_shoulder"},
                             {"右ひじ", "right_elbow"},
                             {"右手首", "right_wrist"},
                             {"右人指１", "right_index_mcp"},
                             {"右人指２", "right_index_pip"},
                             {"右人指３", "right_index_dip"},
                             {"右人指先", "right_index_tip"}}));
  EXPECT_EQ(points({"hombro izquierdo", "codo izquierdo", "muñeca izquierda", "pulgar izquierdo"}),
            (Names{{"hombro izquierdo", "left_shoulder"},
                   {"codo izquierdo", "left_elbow"},
                   {"muñeca izquierda", "left_wrist"},
                   {"pulgar izquierdo", "left_thumb_tip"}}));
}

TEST(NameGuess, FingersAreChainsWhateverTheirNumbers) {
  const Names hand =
      joints({"r_upper_arm", "r_forearm", "r_hand", "r_index_00", "r_index_01", "r_index_02",
              "r_index_03", "r_index_03_end", "r_thumb_a<r_hand", "r_thumb_b", "r_thumb_c",
              "r_thumb_c_end", "r_pinky_1<r_hand", "r_pinky_1_end"});
  EXPECT_EQ(hand.count("r_index_00"), 0u);  // inside the palm
  EXPECT_EQ(hand.at("r_index_01"), "right_index_mcp");
  EXPECT_EQ(hand.at("r_index_03_end"), "right_index_tip");
  EXPECT_EQ(hand.at("r_thumb_a"), "right_thumb_cmc");
  EXPECT_EQ(hand.at("r_thumb_c_end"), "right_thumb_tip");
  EXPECT_EQ(hand.at("r_pinky_1"), "right_little_mcp");
  EXPECT_EQ(hand.at("r_pinky_1_end"), "right_little_tip");
}

TEST(NameGuess, AHandAloneHasNoElbow) {
  EXPECT_EQ(joints({"Scene", "Armature", "RightHand", "RightHandIndex_end"}),
            (Names{{"RightHand", "right_wrist"}, {"RightHandIndex_end", "right_index_tip"}}));
  const Names hand =
      joints({"scene", "hand", "index1", "index2", "index3", "index3_end"}, Side::left);
  EXPECT_EQ(hand, (Names{{"hand", "left_wrist"},
                         {"index1", "left_index_mcp"},
                         {"index2", "left_index_pip"},
                         {"index3", "left_index_dip"},
                         {"index3_end", "left_index_tip"}}));
}

TEST(NameGuess, FingersSideBySideAreToldByTheirWords) {
  const Names hand = joints({"rHand", "rindex_mcp<rHand", "rindex_mcp_end", "rindex_tip<rHand",
                             "rindex_tip_end", "rthumb_tip<rHand", "rthumb_mcp<rHand"});
  EXPECT_EQ(hand, (Names{{"rHand", "right_wrist"},
                         {"rindex_mcp", "right_index_mcp"},
                         {"rindex_tip", "right_index_tip"},
                         {"rthumb_tip", "right_thumb_tip"},
                         {"rthumb_mcp", "right_thumb_mcp"}}));
}

TEST(ArmNames, SayWhatTheyStandFor) {
  EXPECT_EQ(body_part("RUAR12"), "right upper arm");
  EXPECT_EQ(body_part("LFTP"), "left index tip");
  EXPECT_EQ(body_part("left_thumb_ip"), "left thumb ip");
  for (const char* name : {"RSHO", "RUARx", "right_toe", "XUAR1", "", "R", "right_"}) {
    EXPECT_EQ(body_part(name), "") << name;
  }
}

TEST(NameGuess, LateralAndMedialAreToldByEachOther) {
  EXPECT_EQ(
      points({"gh", "EpL", "EpM", "us", "rs"}),
      (Names{{"gh", "RGTH"}, {"EpL", "RLEP"}, {"EpM", "RMEP"}, {"us", "RSPU"}, {"rs", "RSPR"}}));
}

/// The labels of the Istituto Ortopedico Rizzoli: FAL is the lateral malleolus.
TEST(NameGuess, AnkleIsNoForearm) {
  const Names names = points(
      {"R_FAL", "L_FAL", "R_TAM", "R_HLE", "R_HME", "R_RSP", "R_USP", "R_SAE", "L_SAE", "R_FLE"});
  EXPECT_EQ(names, (Names{{"R_HLE", "RLEP"},
                          {"R_HME", "RMEP"},
                          {"R_RSP", "RSPR"},
                          {"R_USP", "RSPU"},
                          {"R_SAE", "RGTH"},
                          {"L_SAE", "LGTH"}}));
}

TEST(NameGuess, AnglesAndForcesAreNoParts) {
  const Names names = points({"RSHO", "RELB", "RWRA", "RWristAngles", "RElbowMoment",
                              "RShoulderPower", "RWristForce", "RElbowAngles"});
  EXPECT_EQ(names.size(), 3u);
  EXPECT_FALSE(names.contains("RWristAngles"));
}

}  // namespace
}  // namespace morphe::imports
