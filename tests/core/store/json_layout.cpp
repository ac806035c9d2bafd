#include "core/store/json_layout.hpp"

#include <gtest/gtest.h>

#include "core/store/plan_layout.hpp"

namespace morphe::store {
namespace {

using Json = JsonWriter::Json;

TEST(JsonLayout, AGraspIsWhatItsGroupHolds) {
  Grasp grasp;
  grasp.sample = 7;
  grasp.base_from_object = Pose(Eigen::Translation3d(1, 2, 3));
  grasp.tips_in_object = {Vec3(0.1, 0.2, 0.3), unknown_point()};
  grasp.grasp_posture = Eigen::Vector2d(0.25, -0.5);
  JsonWriter bare;
  lay_out_grasp(bare, grasp);
  EXPECT_EQ(bare.json["sample"], 7);
  EXPECT_EQ(bare.json["object_pose"][1], Json({0, 1, 0, 2}));
  EXPECT_EQ(bare.json["tips_in_object"][0], Json({0.1, 0.2, 0.3}));
  EXPECT_EQ(bare.json["tips_in_object"][1], Json({nullptr, nullptr, nullptr}));
  EXPECT_EQ(bare.json["grasp_posture"], Json({0.25, -0.5}));
  for (const char* absent : {"contacts", "quality", "grasp_force"})
    EXPECT_FALSE(bare.json.contains(absent));

  PadContact contact;
  contact.tip = "thumb";
  contact.origin = ContactOrigin::auto_closed;
  contact.signed_distance = -1e-4;
  grasp.contacts = {contact, contact};
  grasp.contacts[1].tip = "index";
  grasp.quality.available_force = kInfinity;
  grasp.grasp_torque = grasp.servo_target = Eigen::Vector2d(0, 0.5);
  JsonWriter whole;
  lay_out_grasp(whole, grasp);
  ASSERT_EQ(whole.json["contacts"].size(), 2U);
  EXPECT_EQ(whole.json["contacts"][1]["tip"], "index");
  EXPECT_EQ(whole.json["contacts"][0]["origin"], "auto_closed");
  EXPECT_EQ(whole.json["contacts"][0]["signed_distance"], -1e-4);
  EXPECT_TRUE(whole.json["contacts"][0]["normal_force"].is_null());
  EXPECT_TRUE(whole.json["quality"]["available_force"].is_null());
  EXPECT_EQ(whole.json["grasp_force"]["torque"], Json({0, 0.5}));
}

}  // namespace
}  // namespace morphe::store
