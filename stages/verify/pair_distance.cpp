#include "stages/verify/pair_distance.hpp"

#include "stages/verify/frame_poses.hpp"

namespace morphe::verify {

BodyDistances::BodyDistances(const RobotModel& robot, const Plan& plan)
    : robot_(robot), plan_(plan), attached_(find_attached_object(robot, plan, plan.trajectory)) {
  for (const SceneObject& object : plan.scene.objects)
    meshes_.push_back(object.shape == Shape::mesh ? make_mesh(object) : Mesh());
}

void BodyDistances::move_to(const JointVector& q, double time_s) {
  frame_poses(robot_, q, base_from_frame_);
  axes_.clear();
  for (const RobotModel::Capsule& capsule : robot_.capsules)
    axes_.push_back({to_base_frame(base_from_frame_, capsule.frame, capsule.from),
                     to_base_frame(base_from_frame_, capsule.frame, capsule.to)});
  object_from_base_.clear();
  for (const SceneObject& object : plan_.scene.objects)
    object_from_base_.push_back(recorded_pose(object, time_s).inverse());
  if (attached_.is_attached(time_s)) {
    object_from_base_[attached_.object] =
        (base_from_frame_[attached_.frame] * attached_.frame_from_object).inverse();
  } else if (attached_.is_released(time_s)) {
    object_from_base_[attached_.object] = attached_.base_from_released_object.inverse();
  }
}

double BodyDistances::distance(const ContactPair& pair, double enough) const {
  const Segment& axis = axes_[pair.capsule];
  if (pair.is_object) {
    const Pose& object_from_base = object_from_base_[pair.other];
    const Segment in_object{object_from_base * axis.from, object_from_base * axis.to};
    const SceneObject& object = plan_.scene.objects[pair.other];
    const double enough_for_axis = enough + pair.radius_sum;
    return (object.shape == Shape::mesh
                ? segment_mesh_distance(meshes_[pair.other], in_object, enough_for_axis)
                : segment_solid_distance(object, in_object, enough_for_axis)) -
           pair.radius_sum;
  }
  const Segment& other = axes_[pair.other];
  const double balls = 0.5 * ((axis.from + axis.to - other.from - other.to).norm() -
                              (axis.to - axis.from).norm() - (other.to - other.from).norm()) -
                       pair.radius_sum;
  return balls >= enough ? balls : segment_distance(axis, other) - pair.radius_sum;
}

}  // namespace morphe::verify
