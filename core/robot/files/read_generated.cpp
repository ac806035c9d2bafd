#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

/// Reads the numbers that are present; those in `required` must be.
void read_numbers(const config::ConfigNode& node,
                  std::initializer_list<std::pair<const char*, double*>> required,
                  std::initializer_list<std::pair<const char*, double*>> optional) {
  for (const auto& [key, value] : required) *value = node[key].number();
  for (const auto& [key, value] : optional) {
    if (node.has(key)) *value = node[key].number();
  }
}

void expect_free(const Assembly& assembly, const config::ConfigNode& node,
                 std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (has_frame_or_chain(assembly, name)) node.fail("already exists");
  }
}

}  // namespace

void read_generated(Assembly& assembly, const MountPoint& base, const config::ConfigNode& node) {
  if (node.has("arm") == node.has("hand")) node.fail("must have either arm or hand");
  std::string wrong;
  if (node.has("arm")) {
    const config::ConfigNode arm = node["arm"];
    ArmSpec shape;
    shape.joints = static_cast<int>(arm["joints"].integer());
    read_numbers(arm, {{"length", &shape.length}},
                 {{"limit", &shape.limit},
                  {"velocity", &shape.velocity},
                  {"acceleration", &shape.acceleration},
                  {"jerk", &shape.jerk},
                  {"radius", &shape.radius}});
    if (const std::string message = validation_error(shape); !message.empty()) arm.fail(message);
    expect_free(assembly, arm, {"arm", "arm_1", "wrist"});
    add_generated_arm(assembly, base, shape);
  } else {
    const config::ConfigNode hand = node["hand"];
    HandSpec shape;
    shape.fingers = static_cast<int>(hand["fingers"].integer());
    read_numbers(hand, {{"length", &shape.length}, {"breadth", &shape.breadth}},
                 {{"velocity", &shape.velocity},
                  {"acceleration", &shape.acceleration},
                  {"jerk", &shape.jerk},
                  {"radius", &shape.radius}});
    if (const std::string message = validation_error(shape); !message.empty()) hand.fail(message);
    expect_free(assembly, hand, {"palm", "thumb", "finger1", "index"});
    add_generated_hand(assembly, base, shape);
  }
}

}  // namespace morphe::robot
