#pragma once

#include <array>
#include <string_view>

namespace morphe::setup {

/// The limits of an arm of seven joints, as its maker or a driver publishes them; 0 if unpublished.
struct PublishedArm {
  std::string_view name;    ///< part of the name of the robot or its first joint, in lower case
  std::string_view source;  ///< publisher of the limits
  std::array<double, 7> acceleration, jerk;  ///< [rad/s²], [rad/s³]
  /// The braking curve of a joint (RobotModel::BrakingCurve).
  struct Braking {
    double twice_deceleration, velocity_offset, lower_end, upper_end;
  };
  std::array<Braking, 7> braking;
};

/// The arms with published limits.
inline constexpr std::array<PublishedArm, 5> kPublishedArms = {{
    {"panda",
     "Franka's control parameters",
     {15, 7.5, 10, 12.5, 15, 20, 20},
     {7500, 3750, 5000, 6250, 7500, 10000, 10000},
     {}},
    {"fr3",
     "libfranka, rate_limiting.h",
     {10, 10, 10, 10, 10, 10, 10},
     {5000, 5000, 5000, 5000, 5000, 5000, 5000},
     {{{12, 0.3, -2.7501, 2.7501},
       {5.17, 0.2, -1.7918, 1.7918},
       {7, 0.2, -2.9065, 2.9065},
       {8, 0.3, -3.0481, -0.1458},
       {34, 0.35, -2.8101, 2.8101},
       {11, 0.35, 0.54092, 4.5205},
       {34, 0.35, -3.0196, 3.0196}}}},
    {"iiwa", "lbr_fri_ros2_stack's MoveIt file", {10, 10, 10, 10, 10, 10, 10}, {}, {}},
    {"gen3", "ros2_kortex's MoveIt file", {8.6, 8.6, 8.6, 8.6, 8.6, 8.6, 8.6}, {}, {}},
    {"kinova", "ros2_kortex's MoveIt file", {8.6, 8.6, 8.6, 8.6, 8.6, 8.6, 8.6}, {}, {}},
}};

}  // namespace morphe::setup
