#include "stages/reconstruct/mirror.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace morphe::reconstruct {
namespace {

void mirror(Vec3& point) { point.x() = -point.x(); }

void mirror(Quat& rotation) {
  rotation.y() = -rotation.y();
  rotation.z() = -rotation.z();
}

template <class Values>
void mirror_all(Values& values) {
  for (auto& value : values) mirror(value);
}

/// Returns true for arm markers, whose names begin with the side.
bool has_side_prefix(const std::string& name) {
  static constexpr const char* kParts[] = {"SHO", "UAR", "LAR", "HAN", "FTP", "THUM",
                                           "FB",  "GTH", "LEP", "MEP", "SPR", "SPU"};
  if (name.empty() || (name[0] != 'L' && name[0] != 'R')) return false;
  return std::ranges::any_of(
      kParts, [&](const char* part) { return std::string_view(name).substr(1).starts_with(part); });
}

void swap_side(std::string& name) {
  if (name.starts_with("left_")) {
    name.replace(0, 4, "right");
  } else if (name.starts_with("right_")) {
    name.replace(0, 5, "left");
  }
}

void mirror(Streams& streams) {
  if (streams.markers) {
    mirror_all(streams.markers->position.values);
    for (std::string& name : streams.markers->names) {
      if (has_side_prefix(name)) name[0] = name[0] == 'L' ? 'R' : 'L';
    }
  }
  for (auto* bodies : {&streams.sensors, &streams.skeleton}) {
    if (!*bodies) continue;
    mirror_all((*bodies)->position.values);
    mirror_all((*bodies)->orientation.values);
  }
  if (streams.skeleton) {
    for (std::string& name : streams.skeleton->names) swap_side(name);
    for (std::string& name : streams.skeleton->parents) swap_side(name);
  }
  if (streams.hand) mirror_all(streams.hand->position.values);
}

void remove_unseen_samples(SceneObject& object) {
  int kept = 0;
  for (int i = 0; i < std::ssize(object.time); ++i) {
    if (!is_known(object.position[i]) || !is_known(object.orientation[i])) continue;
    object.time[kept] = object.time[i];
    object.position[kept] = object.position[i];
    object.orientation[kept] = object.orientation[i];
    ++kept;
  }
  object.time.resize(kept);
  object.position.resize(kept);
  object.orientation.resize(kept);
}

void mirror(std::vector<SceneObject>& objects) {
  for (SceneObject& object : objects) {
    mirror_all(object.position);
    mirror_all(object.orientation);
    mirror_all(object.vertices);
    for (Eigen::Vector3i& triangle : object.triangles) std::swap(triangle[1], triangle[2]);
  }
}

}  // namespace

Demonstration mirror_image(const Demonstration& demonstration) {
  Demonstration result = demonstration;
  result.hand = Side::right;
  mirror(result.streams);
  mirror(result.calibration);
  if (result.sensor_offsets) {
    mirror_all(result.sensor_offsets->joint_in_sensor);
    mirror_all(result.sensor_offsets->sensor_from_segment);
  }
  mirror(result.objects);
  return result;
}

HumanMotion mirror_image(HumanMotion motion) {
  // M R M has the axes -x, y, z of the mirrored hand; half a turn about z makes them x, -y, z.
  const Quat half_turn(0, 0, 0, 1);
  for (auto* points : {&motion.shoulder, &motion.elbow, &motion.wrist}) mirror_all(*points);
  mirror_all(motion.tip.values);
  mirror_all(motion.finger_joint.values);
  for (std::vector<Quat>* turns : {&motion.wrist_orientation, &motion.tip_orientation.values}) {
    mirror_all(*turns);
    for (Quat& turn : *turns) turn = turn * half_turn;
  }
  for (Vec3& knuckle : motion.bones.knuckle) knuckle.y() = -knuckle.y();
  return motion;
}

std::vector<SceneObject> objects_on_side(const Demonstration& demonstration, Side hand) {
  std::vector<SceneObject> objects = demonstration.objects;
  for (SceneObject& object : objects) remove_unseen_samples(object);
  std::erase_if(objects, [](const SceneObject& object) { return object.time.empty(); });
  if (demonstration.hand != hand) mirror(objects);
  return objects;
}

}  // namespace morphe::reconstruct
