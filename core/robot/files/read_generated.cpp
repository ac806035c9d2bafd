#include "core/config/fields.hpp"
#include "core/robot/files/assembly.hpp"

namespace morphe::robot {
namespace {

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
    config::read_options(arm, shape);
    require_unused(assembly, arm, {"arm", "arm_1", "wrist"});
    add_generated_arm(assembly, base, shape);
  } else {
    const config::ConfigNode hand = node["hand"];
    HandSpec shape;
    config::read_options(hand, shape);
    require_unused(assembly, hand, {"palm", "thumb", "finger1", "index"});
    add_generated_hand(assembly, base, shape);
  }
}

}  // namespace morphe::robot
