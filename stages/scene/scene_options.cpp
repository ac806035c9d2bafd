#include <fmt/format.h>

#include <set>

#include "pipeline/config/fields.hpp"
#include "stages/scene/build_scene.hpp"

namespace morphe {
namespace {

struct SceneFile {
  std::vector<ConfiguredObject> objects;
};
template <class Fields>
void fields(Fields& f, SceneFile& o) {
  f.required("objects", o.objects);
}

std::size_t numbers_of(Shape shape) {
  switch (shape) {
    case Shape::sphere:
      return 1;
    case Shape::box:
      return 3;
    default:
      return 2;
  }
}

}  // namespace

std::string check(const ConfiguredObject& o) {
  Shape shape = Shape::box;
  if (o.name.empty()) return "name: must not be empty";
  if (o.name == "table") return "name: 'table' is the table of scene.table";
  if (!parse_shape(o.shape, shape) || shape == Shape::mesh) {
    return fmt::format("shape: must be sphere, box, cylinder or capsule, not '{}'", o.shape);
  }
  if (o.size.size() != numbers_of(shape)) {
    return fmt::format("size: a {} needs {} numbers, not {}", o.shape, numbers_of(shape),
                       o.size.size());
  }
  for (const double length : o.size) {
    if (!(length > 0)) return fmt::format("size: must be positive, not {}", length);
  }
  return "";
}

std::string check(const TableOptions& o) {
  if (o.size.size() != 2) return fmt::format("size: needs x and y, not {} numbers", o.size.size());
  for (const double length : o.size) {
    if (!(length > 0)) return fmt::format("size: must be positive, not {}", length);
  }
  if (!(o.thickness > 0)) return fmt::format("thickness: must be positive, not {}", o.thickness);
  if (o.tip_clearance < 0) return "tip_clearance: must not be negative";
  if (o.low_percentile < 0 || o.low_percentile > 100) {
    return fmt::format("low_percentile: must be in [0, 100], not {}", o.low_percentile);
  }
  if (o.side_margin < 0) return "side_margin: must not be negative";
  return "";
}

std::string check(const TargetOptions& o) {
  if (o.name.empty() || o.name == "table") return "name: must not be empty or 'table'";
  if (!(o.height > 0)) return fmt::format("height: must be positive, not {}", o.height);
  if (!(o.min_radius > 0)) return fmt::format("min_radius: must be positive, not {}", o.min_radius);
  if (o.max_radius < o.min_radius) return "max_radius: must not be below min_radius";
  if (o.radius && !(*o.radius > 0)) {
    return fmt::format("radius: must be positive, not {}", *o.radius);
  }
  if (o.pad_depth < 0) return "pad_depth: must not be negative";
  if (o.rim < 0) return "rim: must not be negative";
  return "";
}

std::string check(const SceneOptions& o) {
  std::set<std::string> names;
  if (o.target.infer) names.insert(o.target.name);
  for (const auto* list : {&o.objects, &o.file_objects}) {
    for (const ConfiguredObject& object : *list) {
      if (!names.insert(object.name).second) {
        return fmt::format("objects: the name '{}' is taken", object.name);
      }
    }
  }
  return "";
}

void load_scene_file(SceneOptions& options, const std::filesystem::path& folder) {
  options.file_objects.clear();
  if (options.file.empty()) return;
  const ConfigNode node = ConfigNode::load(folder / options.file);
  SceneFile file;
  read_options(node, file);
  node.expect_all_read();
  options.file_objects = std::move(file.objects);
  if (const std::string wrong = check(options); !wrong.empty()) node.fail(wrong);
}

SceneOptions read_scene(const ConfigNode& node) {
  SceneOptions options;
  read_options(node, options);
  load_scene_file(options, node.folder());
  return options;
}

}  // namespace morphe
