#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/label_search.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

/// A joint, its clusters and its landmarks, as parts of the body without their side.
struct JointParts {
  const char *first, *second, *outer, *inner;
};
constexpr JointParts kJoints[] = {{"upper arm", "forearm", "elbow, outer", "elbow, inner"},
                                  {"forearm", "hand", "wrist, thumb", "wrist, little"}};

std::size_t cluster_of_part(const std::vector<RigidCluster>& clusters, const std::string& part) {
  const auto found = std::ranges::find_if(clusters, [&](const RigidCluster& cluster) {
    return cluster.part == part && !cluster.shape.empty();
  });
  return found - clusters.begin();
}

}  // namespace

LabelModel label_model(const MarkerStream& markers,
                       const std::optional<MarkerStream>& static_trial) {
  LabelModel model{rigid_clusters(markers, static_trial), {}, {}};
  for (const std::string& name : markers.names) {
    const std::string part = body_part(name);
    model.is_landmark.push_back(part.find(", ") != std::string::npos || part.ends_with("mcp"));
  }
  for (const char* side : {"right", "left"}) {
    for (const JointParts& parts : kJoints) {
      const auto landmark = [&](const char* part) {
        return static_trial ? median_of_part(*static_trial, fmt::format("{} {}", side, part))
                            : unknown_point();
      };
      const LandmarkJoint joint{
          cluster_of_part(model.clusters, fmt::format("{} {}", side, parts.first)),
          cluster_of_part(model.clusters, fmt::format("{} {}", side, parts.second)),
          (landmark(parts.outer) + landmark(parts.inner)) / 2};
      if (std::max(joint.first, joint.second) < model.clusters.size() && is_known(joint.in_static))
        model.joints.push_back(joint);
    }
  }
  return model;
}

}  // namespace morphe::imports
