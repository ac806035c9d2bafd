#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

void read_numbers(const config::ConfigNode& node,
                  std::initializer_list<std::pair<const char*, double*>> required,
                  std::initializer_list<std::pair<const char*, double*>> optional) {
  for (const auto& [key, value] : required) *value = node[key].number();
  for (const auto& [key, value] : optional) {
    if (node.has(key)) *value = node[key].number();
  }
}

int read_count(const config::ConfigNode& node) { return static_cast<int>(node.integer()); }

void require_unused(const Assembly& assembly, const config::ConfigNode& node,
                    std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (has_frame_or_chain(assembly, name)) node.fail("already exists");
  }
}

}  // namespace

void read_generated(Assembly& assembly, const MountPoint& base, const config::ConfigNode& node) {
  if (node.has("arm") == node.has("hand")) node.fail("must have either arm or hand");
  if (node.has("arm")) {
    const config::ConfigNode arm = node["arm"];
    ArmSpec shape;
    shape.joints = read_count(arm["joints"]);
    read_numbers(arm, {{"length", &shape.length}},
                 {{"limit", &shape.limit},
                  {"velocity", &shape.velocity},
                  {"acceleration", &shape.acceleration},
                  {"jerk", &shape.jerk},
                  {"radius", &shape.radius}});
    if (const std::string message = validation_error(shape); !message.empty()) arm.fail(message);
    require_unused(assembly, arm, {"arm", "arm_1", "wrist"});
    add_generated_arm(assembly, base, shape);
  } else {
    const config::ConfigNode hand = node["hand"];
    HandSpec shape;
    shape.fingers = read_count(hand["fingers"]);
    read_numbers(hand, {{"length", &shape.length}, {"breadth", &shape.breadth}},
                 {{"velocity", &shape.velocity},
                  {"acceleration", &shape.acceleration},
                  {"jerk", &shape.jerk},
                  {"radius", &shape.radius}});
    if (const std::string message = validation_error(shape); !message.empty()) hand.fail(message);
    require_unused(assembly, hand, {"palm", "thumb", "finger1", "index"});
    add_generated_hand(assembly, base, shape);
  }
}

}  // namespace morphe::robot
