#include "pipeline/study/cluster_angles.hpp"

#include <cmath>

#include "stages/reconstruct/marker_body.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::study {

ClusterAngles cluster_angles(const Demonstration& demonstration,
                             const reconstruct::ReconstructOptions& options) {
  if (demonstration.hand == Side::left)
    return cluster_angles(reconstruct::mirror_image(demonstration), options);
  if (!demonstration.streams.markers) return {};
  const MarkerStream& markers = *demonstration.streams.markers;
  reconstruct::MarkerTrial trial{
      markers, reconstruct::StaticTrial(demonstration.calibration.markers),
      reconstruct::make_time_grid({&markers.time}, options.rate_hz), options};
  HumanMotion ignored_problems;  // reconstruct() reports problems of the clusters
  const auto body = [&](const char* cluster) {
    return reconstruct::make_marker_body(trial, cluster, true, ignored_problems);
  };
  const reconstruct::MarkerBody girdle = body("RSHO"), upper_arm = body("RUAR"),
                                forearm = body("RLAR");
  const Vec3 across = trial.static_trial.mean("RLEP", ignored_problems.reconstruction_notes) -
                      trial.static_trial.mean("RMEP", ignored_problems.reconstruction_notes);
  if (!girdle.in_static || !upper_arm.in_static || !forearm.in_static || !is_known(across))
    return {};
  const Vec3 x = across.normalized(), y = (Vec3::UnitY() - x * x.y()).normalized();
  Eigen::Matrix3d elbow_axes;
  elbow_axes << x, y, x.cross(y);

  ClusterAngles angles;
  for (int i = 0; i < trial.clock.count; ++i) {
    const Eigen::Matrix3d upper = upper_arm.world_from_body[i].linear();
    const Eigen::Matrix3d shoulder = girdle.world_from_body[i].linear().transpose() * upper;
    const Eigen::Matrix3d elbow = elbow_axes.transpose() * upper.transpose() *
                                  forearm.world_from_body[i].linear() * elbow_axes;
    angles.horizontal.push_back(std::atan2(-shoulder(0, 1), shoulder(1, 1)));
    angles.flexion.push_back(std::asin(shoulder(2, 1)));
    angles.rotation.push_back(std::atan2(-shoulder(2, 0), shoulder(2, 2)));
    angles.elbow.push_back(std::atan2(elbow(2, 1), elbow(1, 1)));
    angles.pronation.push_back(std::atan2(elbow(0, 2), elbow(0, 0)));
  }
  return angles;
}

}  // namespace morphe::study
