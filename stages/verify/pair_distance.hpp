#pragma once

#include <vector>

#include "stages/verify/attached_object.hpp"
#include "stages/verify/contact.hpp"
#include "stages/verify/mesh.hpp"
#include "stages/verify/separation.hpp"

namespace morphe::verify {

/// The bodies of a plan, robot and scene, at one instant.
class BodyDistances {
 public:
  /// Prepares the bodies; both arguments must outlive them.
  BodyDistances(const RobotModel& robot, const Plan& plan);

  /// Moves all bodies to where they are at a posture and a demonstration time.
  void move_to(const JointVector& q, double time_s);
  /// Returns a pair's exact distance if it is below `enough`, otherwise a bound from `enough` on.
  double distance(const ContactPair& pair, double enough) const;

  const RobotModel& robot() const { return robot_; }
  const AttachedObject& attached() const { return attached_; }
  /// Returns one mesh for each object, empty if the object is none.
  const std::vector<Mesh>& meshes() const { return meshes_; }

 private:
  const RobotModel& robot_;
  const Plan& plan_;
  std::vector<Mesh> meshes_;
  AttachedObject attached_;
  std::vector<Pose> base_from_frame_, object_from_base_;
  std::vector<Segment> axes_;  ///< of the capsules, in the base frame
};

}  // namespace morphe::verify
