#include "core/robot/files/robot_schema.hpp"

#include <map>
#include <string>

#include "core/robot/files/generated_specs.hpp"
#include "core/robot/files/limit_bounds.hpp"

namespace morphe::robot {
namespace {

using config::boolean_schema;
using config::enum_schema;
using config::list_schema;
using config::number_schema;
using config::object_schema;
using config::scalar_schema;
using config::Schema;
using config::SchemaKey;

Schema vector_schema(const KeyBounds& bounds) { return list_schema(number_schema(bounds), 3); }

SchemaKey limit_key(const char* name, const char* description) {
  return {name, number_schema(limit_bounds(name)), description};
}

SchemaKey convention_key() {
  return {"convention", enum_schema({"modified", "standard"}),
          "Denavit-Hartenberg: modified (Craig, the default) or standard"};
}

SchemaKey parent_key() {
  return {"parent", scalar_schema(),
          "a frame, a chain (its end) or base; default: the base of this file"};
}

SchemaKey mount_key() {
  return {"mount",
          object_schema({{"position", vector_schema(bounds::kCoordinate), "x, y, z [m]"},
                         {"rpy", vector_schema(bounds::kAngle),
                          "Rz(yaw) Ry(pitch) Rx(roll), fixed axes [rad]"},
                         {"quaternion", list_schema(number_schema(bounds::kUnit), 4), "w, x, y, z"},
                         {"matrix", list_schema(list_schema(number_schema(bounds::kCoordinate))),
                          "3 rows of 3 numbers, or 4 of 4"}}),
          "pose in its parent: position and one of rpy, quaternion and matrix"};
}

/// Returns the keys of rate limits, which are not required because other keys can replace them.
std::vector<SchemaKey> rate_keys() {
  return {limit_key("velocity", "[rad/s]"), limit_key("acceleration", "[rad/s^2]"),
          limit_key("jerk", "[rad/s^3]")};
}

void append(const std::vector<SchemaKey>& added, std::vector<SchemaKey>& keys) {
  keys.insert(keys.end(), added.begin(), added.end());
}

void append_limits(std::vector<SchemaKey>& keys) {
  keys.push_back(limit_key("lower", "[rad], [m] if prismatic"));
  keys.push_back(limit_key("upper", "[rad], [m] if prismatic"));
  append(rate_keys(), keys);
}

Schema joint_schema() {
  std::vector<SchemaKey> keys = {
      {"name", scalar_schema(), "name of the joint and of the frame after it", true},
      {"type", enum_schema({"revolute", "prismatic"}), "prismatic joints move along z"},
      {"theta", number_schema(bounds::kAngle), "offset of a revolute joint [rad]", true},
      {"d", number_schema(bounds::kSignedLength), "along z [m]", true},
      {"a", number_schema(bounds::kSignedLength), "along x [m]", true},
      {"alpha", number_schema(bounds::kAngle), "about x [rad]", true},
      {"couple",
       object_schema(
           {{"joint", scalar_schema(), "an earlier actuated joint", true},
            {"ratio", number_schema(bounds::kCoupling), "angle per angle of the other joint"},
            {"offset", number_schema(bounds::kJointPosition),
             "angle when the other joint is at 0 [rad]"}}),
       "coupling to another joint, in place of own limits"}};
  append_limits(keys);
  return object_schema(keys);
}

Schema chain_schema() {
  return object_schema({{"name", scalar_schema(), "the chain called arm is the arm", true},
                        parent_key(),
                        mount_key(),
                        convention_key(),
                        {"joints", list_schema(joint_schema()), "base to tip"},
                        {"first", scalar_schema(), "first joint or link of a chain of the URDF"},
                        {"last", scalar_schema(), "last joint or link of a chain of the URDF"}});
}

Schema generate_schema() {
  const config::KeyDescriptions meaning = [](const std::string& type, const std::string& key) {
    static const std::map<std::string, std::string> kMeanings = {
        {"ArmSpec.joints", "6 to 60"},
        {"ArmSpec.length", "from shoulder to wrist [m]"},
        {"ArmSpec.limit", "limit of each joint in both directions [rad]"},
        {"HandSpec.fingers", "3 to 12, the thumb included"},
        {"HandSpec.length", "from the wrist to the middle fingertip [m]"},
        {"HandSpec.breadth", "across the knuckles [m]"},
        {"velocity", "[rad/s]"},
        {"acceleration", "[rad/s^2]"},
        {"jerk", "[rad/s^3]"},
        {"radius", "radius of a capsule along each link [m]; 0: none"}};
    const auto own = kMeanings.find(type + "." + key);
    return own == kMeanings.end() ? kMeanings.at(key) : own->second;
  };
  return object_schema(
      {{"arm", config::schema_of<ArmSpec>(meaning), "an arm of n joints, as in the paper"},
       {"hand", config::schema_of<HandSpec>(meaning), "a hand of m fingers"}});
}

Schema urdf_schema() {
  std::vector<SchemaKey> limits = {{"joint", scalar_schema(), "joint of the URDF", true}};
  append_limits(limits);
  limits.push_back(
      {"braking",
       object_schema(
           {{"twice_deceleration", number_schema(bounds::kJointAcceleration), "[rad/s^2]", true},
            {"velocity_offset", number_schema(bounds::kSpeedOffset), "[rad/s]", true},
            {"lower_end", number_schema(bounds::kJointPosition), "[rad]", true},
            {"upper_end", number_schema(bounds::kJointPosition), "[rad]", true}}),
       "a velocity limit that decreases towards the position limits"});
  limits.push_back({"enforce_position_limits", boolean_schema(),
                    "false: ignore the position limits of a coupled joint"});
  return object_schema(
      {{"file", scalar_schema(), "relative to this file", true},
       {"srdf", scalar_schema(), "SRDF whose disabled collisions are used"},
       {"shapes", enum_schema({"use", "ignore"}), "whether to use its collision elements"},
       limit_key("velocity", "used where the URDF gives none [rad/s]"),
       limit_key("acceleration", "used where the URDF gives none [rad/s^2]"),
       limit_key("jerk", "used where the URDF gives none [rad/s^3]"),
       {"limits", list_schema(object_schema(limits)), "they override those of the URDF"}});
}

Schema collision_schema() {
  const Schema pairs = list_schema(list_schema(scalar_schema(), 2));
  return object_schema(
      {{"capsules",
        list_schema(
            object_schema({{"name", scalar_schema(), "", true},
                           {"frame", scalar_schema(), "a frame, link or chain", true},
                           {"from", vector_schema(bounds::kCoordinate), "in its frame [m]", true},
                           {"to", vector_schema(bounds::kCoordinate), "in its frame [m]", true},
                           {"radius", number_schema(bounds::kPositiveLength), "[m]", true}})),
        "the robot's body"},
       {"allowed_links", pairs, "pairs of links or frames whose collisions are not checked"},
       {"allowed_collision_pairs", pairs,
        "pairs of capsules whose collisions are not checked; a * at the end matches any ending"},
       {"may_touch_target", list_schema(scalar_schema()), "capsules that may touch the target"}});
}

Schema finger_schema() {
  Schema schema = enum_schema({"thumb", "index", "middle", "ring", "little", "wrist"});
  for (int finger = 0; finger < 5; ++finger) schema["enum"].push_back(finger);
  return schema;
}

Schema tip_schema() {
  return object_schema({{"name", scalar_schema(), "", true},
                        {"chain", scalar_schema(), "the chain at whose end the tip is"},
                        {"frame", scalar_schema(), "in place of a chain"},
                        mount_key(),
                        {"finger", finger_schema(), "human finger that it follows"},
                        {"finger_curve_share", number_schema(bounds::kShare),
                         "in place of finger: 0 (index) to 1 (little)"},
                        {"pad_depth", number_schema(bounds::kLength),
                         "from the pad's surface to the finger's axis [m]"}});
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
                           {"prefix", scalar_schema(), "put before all names of the part"}})),
        "other descriptions that this robot consists of"},
       {"generate", generate_schema(), "an arm or a hand generated from a few sizes"},
       {"urdf", urdf_schema(), "URDF that gives links and joints"},
       {"chains", list_schema(chain_schema()), "rows of joints, base to tip"},
       {"frames",
        list_schema(
            object_schema({{"name", scalar_schema(), "", true}, parent_key(), mount_key()})),
        "fixed frames"},
       {"fixed_joints",
        list_schema(object_schema(
            {{"joint", scalar_schema(), "", true},
             {"position", number_schema(bounds::kJointPosition), "[rad], [m] if prismatic"}})),
        "joints fixed at a position"},
       {"shoulder", scalar_schema(), "frame; default: the arm's first joint"},
       {"palm", scalar_schema(),
        "frame that carries the hand: z to the fingers, x out of the palm, y to a right thumb"},
       {"tips", list_schema(tip_schema()), "fingertips: z along the last bone, x out of the pad"},
       {"side", enum_schema({"right", "left"}), "side of the hand"},
       {"natural_posture",
        list_schema(
            object_schema({{"joint", scalar_schema(), "a joint that no goal determines", true},
                           {"follow", scalar_schema(), "a joint whose value it copies"},
                           {"value", number_schema(bounds::kJointPosition),
                            "value, or offset to the joint in follow [rad]"}})),
        "natural posture, unless a config gives one"},
       {"joint_centres",
        list_schema(object_schema(
            {{"chain", scalar_schema(), "", true}, {"frame", scalar_schema(), "", true}})),
        "replace the derived joint centres of that chain"},
       {"collision", collision_schema(), "capsules and which of them may touch"},
       {"check", list_schema(scalar_schema()),
        "sentences on what is assumed, to be checked before the robot is used"},
       {"assumed",
        object_schema({{"limits", scalar_schema(), "limits that the manufacturer does not publish"},
                       {"mount", scalar_schema(), "how parts are mounted on each other"},
                       {"geometry", scalar_schema(), "bodies, fingertips, chains"}}),
        "what is not known from the manufacturer, stored with every plan"}});
}

}  // namespace morphe::robot
