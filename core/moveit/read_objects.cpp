#include <fmt/format.h>

#include "core/files/item_name.hpp"
#include "core/moveit/planning_scene.hpp"
#include "core/moveit/read_messages.hpp"

namespace morphe::moveit {

Pose FixedFrames::pose_of(const config::ConfigNode& owner) const {
  const bool stated = owner.has("header") && owner["header"].has("frame_id");
  const std::string name = stated ? owner["header"]["frame_id"].text() : "";
  const auto found = base_from.find(name);
  if (found == base_from.end())
    owner["header"]["frame_id"].fail(fmt::format("there is no fixed frame '{}'", name));
  return found->second;
}

FixedFrames read_frames(const config::ConfigNode& scene, const std::string& root_link,
                        const Pose& base_from_world) {
  FixedFrames frames;
  frames.base_from[""] = frames.base_from["world"] = base_from_world;
  for (const config::ConfigNode& item : items_of(scene, "fixed_frame_transforms")) {
    const Pose base_from_parent = frames.pose_of(item);
    frames.base_from[item["child_frame_id"].text()] =
        base_from_parent * read_transform(item["transform"]);
  }
  if (!root_link.empty()) frames.base_from[root_link] = Pose::Identity();
  return frames;
}

Scene read_objects(const config::ConfigNode& scene, const FixedFrames& frames) {
  Scene result;
  const config::ConfigNode world = scene["world"];
  if (world.has("octomap") && world["octomap"].has("octomap"))
    refuse(world["octomap"]["octomap"], "data", "an octomap is not supported");
  const auto taken = [&](const std::string& name) { return find_object(result.objects, name); };
  for (const config::ConfigNode& item : items_of(world, "collision_objects")) {
    const std::string id = item["id"].text();
    if (!files::is_item_name(id)) item["id"].fail(files::kItemNameError);
    if (taken(id)) item["id"].fail(fmt::format("an object '{}' already exists", id));
    refuse(item, "planes", "planes are not supported");
    if (item.has("operation") && item["operation"].text() != "0")
      item["operation"].fail("must be 0 (ADD)");
    Pose base_from_object = frames.pose_of(item);
    if (item.has("pose")) base_from_object = base_from_object * read_pose(item["pose"]);
    int count = 0;  // of shapes, and beyond it, because names that exist are skipped
    for (SceneObject& shape : read_shapes(item, base_from_object)) {
      ++count;
      do {
        shape.name = count == 1 ? id : fmt::format("{}_{}", id, count);
      } while (count > 1 && taken(shape.name) && ++count);
      result.objects.push_back(std::move(shape));
    }
  }
  return result;
}

Scene read_moveit_scene(const std::filesystem::path& scene_file, const files::GivenFiles* given) {
  const config::ConfigNode scene = config::ConfigNode::load(scene_file, given);
  return read_objects(scene, read_frames(scene, "", Pose::Identity()));
}

}  // namespace morphe::moveit
