#include "stages/reconstruct/static_trial.hpp"

#include <fmt/format.h>

namespace morphe::reconstruct {

StaticTrial::StaticTrial(const std::optional<MarkerStream>& trial) : given_(trial.has_value()) {
  for (std::size_t k = 0; given_ && k < trial->names.size(); ++k) {
    Eigen::AlignedBox3d box;
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (std::size_t i = 0; i < trial->position.rows; ++i) {
      const Vec3& point = trial->position(i, k);
      if (!is_known(point)) continue;
      sum += point;
      box.extend(point);
      ++count;
    }
    if (count > 0) markers_[trial->names[k]] = {sum / count, box.diagonal().norm()};
  }
}

Vec3 StaticTrial::at(const std::string& marker, std::vector<std::string>& problems) {
  // Breathing and drift of the quiet trials: 1 to 5 mm.
  constexpr double kMaxMarkerMotion_m = 0.010;
  const auto found = markers_.find(marker);
  if (found == markers_.end()) return unknown_point();
  double& moved_m = found->second.moved_m;
  if (moved_m > kMaxMarkerMotion_m) {
    problems.push_back(fmt::format("static trial: {} moves by {:.1f} mm", marker, 1000 * moved_m));
    moved_m = 0;
  }
  return found->second.mean;
}

}  // namespace morphe::reconstruct
