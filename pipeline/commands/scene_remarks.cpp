#include "pipeline/commands/scene_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/motion/bounding_box.hpp"

namespace morphe::commands {
namespace {

constexpr double kMaxFloatingHeight_m = 0.02, kMaxSinkDepth_m = 0.005;

bool overlaps_horizontally(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  return (a.min().head<2>().array() < b.max().head<2>().array()).all() &&
         (b.min().head<2>().array() < a.max().head<2>().array()).all();
}

}  // namespace

std::map<std::string, std::string> scene_remarks(const Plan& plan) {
  std::map<std::string, std::string> remarks;
  const SceneObject* table = find_object(plan.scene.objects, "table");
  if (!table || !is_known(plan.reference_frames.base_from_table)) return remarks;
  const Pose table_from_base = plan.reference_frames.base_from_table.inverse();
  const auto extent = [&](const SceneObject& object) {
    return bounding_box(object, table_from_base * recorded_pose(object, plan.movement.begin_s));
  };
  const Eigen::AlignedBox3d top = extent(*table);
  for (const SceneObject& object : plan.scene.objects) {
    if (&object == table || object.name == plan.movement.target || object.time.size() > 1) continue;
    const Eigen::AlignedBox3d box = extent(object);
    if (!overlaps_horizontally(box, top)) continue;
    const double bottom_z = box.min().z();
    const bool held_up = std::ranges::any_of(plan.scene.objects, [&](const SceneObject& other) {
      const Eigen::AlignedBox3d support = extent(other);
      return &other != &object && &other != table && overlaps_horizontally(box, support) &&
             support.min().z() < bottom_z && support.max().z() > bottom_z - kMaxFloatingHeight_m;
    });
    const bool floats = bottom_z > kMaxFloatingHeight_m && !held_up;
    const bool sinks = bottom_z < -kMaxSinkDepth_m && box.max().z() > kMaxSinkDepth_m;
    if (!floats && !sinks) continue;
    remarks[object.name] = fmt::format(
        "{} is {:.0f} mm {}; to place it on the table: relative_to: table, anchor: bottom_centre, "
        "position [x, y, 0]",
        object.name, 1e3 * std::abs(bottom_z),
        floats ? "above the table without support" : "deep in the table");
  }
  return remarks;
}

}  // namespace morphe::commands
