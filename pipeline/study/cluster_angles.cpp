#include "pipeline/study/cluster_angles.hpp"

#include <cmath>

#include "stages/reconstruct/marker_body.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::study {

ClusterAngles cluster_angles(const Demonstration& demonstration,
                             const reconstruct::ReconstructOptions& options) {
  if (demonstration.hand == Side::left)
    return cluster_angles(reconstruct::mirrored(demonstration), options);
  if (!demonstration.streams.markers) return {};
  const MarkerStream& markers = *demonstration.streams.markers;
  reconstruct::MarkerTrial trial{
      markers, reconstruct::StaticTrial(demonstration.calibration.markers),
      reconstruct::clock_over({&markers.time}, options.rate_hz), options};
  HumanMotion said;  // what is wrong with a cluster, reconstruct() says
  const reconstruct::MarkerBody girdle = reconstruct::body_of(trial, "RSHO", true, said);
  const reconstruct::MarkerBody upper_arm = reconstruct::body_of(trial, "RUAR", true, said);
  const reconstruct::MarkerBody forearm = reconstruct::body_of(trial, "RLAR", true, said);
  const Vec3 across = trial.still.at("RLEP", said.problems) - trial.still.at("RMEP", said.problems);
  if (!girdle.in_static || !upper_arm.in_static || !forearm.in_static || !seen(across)) return {};
  const Vec3 x = across.normalized(), y = (Vec3::UnitY() - x * x.y()).normalized();
  Eigen::Matrix3d elbow_axes;
  elbow_axes << x, y, x.cross(y);

  ClusterAngles angles;
  for (std::size_t i = 0; i < trial.clock.count; ++i) {
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
