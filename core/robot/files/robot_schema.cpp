#include "core/robot/files/robot_schema.hpp"

namespace morphe::robot {
namespace {

using config::boolean_schema;
using config::enum_schema;
using config::integer_schema;
using config::list_schema;
using config::number_schema;
using config::object_schema;
using config::scalar_schema;
using config::Schema;
using config::SchemaKey;

Schema positive_schema() {
  Schema schema = number_schema();
  schema["exclusiveMinimum"] = 0;
  return schema;
}

Schema vector_schema() { return list_schema(number_schema(), 3); }

SchemaKey convention_key() {
  return {"convention", enum_schema({"modified", "standard"}),
          "Denavit-Hartenberg: modified (Craig, the default) or standard"};
}

SchemaKey parent_key() {
  return {"parent", scalar_schema(),
          "a frame, a chain (its end) or base; if absent the file's own base"};
}

SchemaKey mount_key() {
  return {"mount",
          object_schema({{"position", vector_schema(), "x, y, z [m]"},
                         {"rpy", vector_schema(), "Rz(yaw) Ry(pitch) Rx(roll), fixed axes [rad]"},
                         {"quaternion", list_schema(number_schema(), 4), "w, x, y, z"},
                         {"matrix", list_schema(list_schema(number_schema())),
                          "3 rows of 3 numbers, or 4 of 4"}}),
          "where it stands from its parent: position and one of rpy, quaternion and matrix"};
}

/// Returns the keys of limits. They are alternatives to other keys, so they are not required.
std::vector<SchemaKey> limit_keys() {
  return {{"lower", number_schema(), "[rad], [m] of one that slides"},
          {"upper", number_schema(), "[rad], [m] of one that slides"},
          {"velocity", positive_schema(), "[rad/s]"},
          {"acceleration", positive_schema(), "[rad/s^2]"},
          {"jerk", positive_schema(), "[rad/s^3]"}};
}

Schema joint_schema() {
  std::vector<SchemaKey> keys = {
      {"name", scalar_schema(), "of the joint and the frame after it", true},
      {"type", enum_schema({"revolute", "prismatic"}), "prismatic slides along z"},
      {"theta", number_schema(), "offset of a turning joint [rad]", true},
      {"d", number_schema(), "along z [m]", true},
      {"a", number_schema(), "along x [m]", true},
      {"alpha", number_schema(), "about x [rad]", true},
      {"couple",
       object_schema({{"joint", scalar_schema(), "an earlier one that is driven", true},
                      {"ratio", number_schema(), "turns by so much for each of the other's"},
                      {"offset", number_schema(), "where it stands when the other is at 0 [rad]"}}),
       "it is moved by another joint, in place of limits of its own"}};
  for (const SchemaKey& key : limit_keys()) keys.push_back(key);
  return object_schema(keys);
}

Schema chain_schema() {
  return object_schema(
      {{"name", scalar_schema(), "the chain called arm is the arm", true},
       parent_key(),
       mount_key(),
       convention_key(),
       {"joints", list_schema(joint_schema()), "base to tip"},
       {"first", scalar_schema(), "of a chain of the URDF: its first joint or link"},
       {"last", scalar_schema(), "of a chain of the URDF: its last joint or link"}});
}

std::vector<SchemaKey> made_up_limits() {
  return {{"velocity", positive_schema(), "[rad/s]"},
          {"acceleration", positive_schema(), "[rad/s^2]"},
          {"jerk", positive_schema(), "[rad/s^3]"},
          {"radius", number_schema(), "of a capsule along each link [m]; 0: none"}};
}

Schema generate_schema() {
  std::vector<SchemaKey> arm = {
      {"joints", integer_schema(), "6 to 60", true},
      {"length", positive_schema(), "from shoulder to wrist [m]", true},
      {"limit", positive_schema(), "each joint turns this far both ways [rad]"}};
  std::vector<SchemaKey> hand = {
      {"fingers", integer_schema(), "3 to 12, the thumb included", true},
      {"length", positive_schema(), "from the wrist to the middle fingertip [m]", true},
      {"breadth", positive_schema(), "across the knuckles [m]", true}};
  for (const SchemaKey& key : made_up_limits()) {
    arm.push_back(key);
    hand.push_back(key);
  }
  return object_schema({{"arm", object_schema(arm), "of n joints, as in the paper"},
                        {"hand", object_schema(hand), "of m fingers"}});
}

Schema urdf_schema() {
  std::vector<SchemaKey> limits = limit_keys();
  limits.insert(limits.begin(), {"joint", scalar_schema(), "of the URDF", true});
  limits.push_back({"braking",
                    object_schema({{"slope", number_schema(), "[1/s]", true},
                                   {"drop", number_schema(), "[rad/s]", true},
                                   {"lower_end", number_schema(), "[rad]", true},
                                   {"upper_end", number_schema(), "[rad]", true}}),
                    "a velocity limit that falls towards the ends"});
  limits.push_back(
      {"enforce", boolean_schema(), "false: a coupled joint's position limits are not"});
  return object_schema(
      {{"file", scalar_schema(), "relative to this file", true},
       {"srdf", scalar_schema(), "whose disabled collisions are taken"},
       {"shapes", enum_schema({"use", "ignore"}), "of its collision elements"},
       {"velocity", positive_schema(), "where the file has none [rad/s]"},
       {"acceleration", positive_schema(), "where the file has none [rad/s^2]"},
       {"jerk", positive_schema(), "where the file has none [rad/s^3]"},
       {"limits", list_schema(object_schema(limits)), "they win over the file's"}});
}

Schema collision_schema() {
  const Schema pairs = list_schema(list_schema(scalar_schema(), 2));
  return object_schema(
      {{"capsules",
        list_schema(object_schema({{"name", scalar_schema(), "", true},
                                   {"frame", scalar_schema(), "a frame, link or chain", true},
                                   {"from", vector_schema(), "in its frame [m]", true},
                                   {"to", vector_schema(), "in its frame [m]", true},
                                   {"radius", positive_schema(), "[m]", true}})),
        "the robot's body"},
       {"allowed_links", pairs, "links or frames of which no capsules collide"},
       {"allowed_pairs", pairs, "capsules that never collide; a * at the end stands for any"},
       {"may_touch_target", list_schema(scalar_schema()), "capsules that may touch the target"}});
}

Schema finger_schema() {
  Schema schema = enum_schema({"thumb", "index", "middle", "ring", "little", "wrist"});
  for (int finger = 0; finger < 5; ++finger) schema["enum"].push_back(finger);
  return schema;
}

Schema tip_schema() {
  return object_schema(
      {{"name", scalar_schema(), "", true},
       {"chain", scalar_schema(), "it stands at this chain's end"},
       {"frame", scalar_schema(), "in place of a chain"},
       mount_key(),
       {"finger", finger_schema(), "the human's that it follows"},
       {"along", number_schema(), "in place of finger: 0 (index) to 1 (little)"},
       {"pad_depth", number_schema(), "from the pad's surface to the finger's axis [m]"}});
}

}  // namespace

Schema robot_schema() {
  return object_schema(
      {{"name", scalar_schema(), "of the robot", true},
       convention_key(),
       {"parts",
        list_schema(
            object_schema({{"file", scalar_schema(), "another description"},
                           {"generate", generate_schema(), "in place of a file"},
                           parent_key(),
                           mount_key(),
                           {"prefix", scalar_schema(), "goes before all names of the part"}})),
        "other descriptions that it is made of"},
       {"generate", generate_schema(), "an arm or a hand by rule"},
       {"urdf", urdf_schema(), "where links and joints come from"},
       {"chains", list_schema(chain_schema()), "rows of joints, base to tip"},
       {"frames",
        list_schema(
            object_schema({{"name", scalar_schema(), "", true}, parent_key(), mount_key()})),
        "fixed frames"},
       {"hold",
        list_schema(object_schema({{"joint", scalar_schema(), "", true},
                                   {"at", number_schema(), "[rad], [m] of one that slides"}})),
        "joints that stand still"},
       {"shoulder", scalar_schema(), "frame; the arm's first joint if absent"},
       {"palm", scalar_schema(),
        "frame that carries the hand: z to the fingers, x out of the palm, y to a right thumb"},
       {"tips", list_schema(tip_schema()), "fingertips: z along the last bone, x out of the pad"},
       {"side", enum_schema({"right", "left"}), "of the hand"},
       {"natural",
        list_schema(
            object_schema({{"joint", scalar_schema(), "one that no goal asks anything of", true},
                           {"follow", scalar_schema(), "a joint whose value it takes"},
                           {"value", number_schema(), "or so much, or so much more [rad]"}})),
        "the natural posture, where a config names none"},
       {"centres",
        list_schema(object_schema(
            {{"chain", scalar_schema(), "", true}, {"frame", scalar_schema(), "", true}})),
        "replace the derived joint centres of that chain"},
       {"collision", collision_schema(), "capsules and what of them may touch"}});
}

}  // namespace morphe::robot
