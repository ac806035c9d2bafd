#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/robot/files/mjcf_model.hpp"
#include "core/robot/files/mjcf_source.hpp"

namespace morphe::robot {

/// A mesh of an MJCF. A vertex v of the file is at scale · R(reference)ᵀ (v - reference).
struct MjcfMesh {
  std::filesystem::path file;
  Vec3 scale = Vec3::Ones();
  Pose reference = Pose::Identity();
};

/// Reads the meshes of all `asset` sections, by name. Meshes without a file have an empty path.
std::map<std::string, MjcfMesh> read_mjcf_meshes(const MjcfSource& source);

/// Reads a geom; returns no value, with a note, for planes and other shapes that cannot be bodies
/// of a robot. An ellipsoid becomes the capsule around it.
std::optional<MjcfGeom> read_mjcf_geom(const MjcfElement& element,
                                       const std::map<std::string, MjcfMesh>& meshes,
                                       std::vector<std::string>& notes);

/// Reads a hinge or slide; its name may be missing. A range without `limited` limits the joint.
MjcfJoint read_mjcf_joint(const MjcfElement& element, std::vector<std::string>& notes);

/// Reads the mass, centre and inertia of a body.
UrdfInertia read_mjcf_inertial(const MjcfElement& element);

/// The joints of a model by name.
using MjcfJointIndex = std::map<std::string, MjcfJoint*>;
/// Returns the index of the model's joints.
MjcfJointIndex joints_by_name(MjcfModel& model);

/// Sets the couplings of joints by `equality`, adds the loops that `connect` closes, and notes the
/// equalities that a URDF cannot express.
void read_mjcf_equalities(const MjcfSource& source, MjcfModel& model);

/// Sets the efforts of joints by `actuator`, and notes actuators and tendons that move several
/// joints or command less than a joint's range.
void read_mjcf_actuators(const MjcfSource& source, MjcfModel& model);

/// Returns true if an actuator moves the joint, perhaps through couplings in either direction;
/// `driven` are the names of the joints that actuators move.
bool is_driven(const MjcfModel& model, const MjcfJoint& joint, const std::set<std::string>& driven);

/// Couples the passive joints of each loop to the only driven joint in it: the gap is closed, of
/// the postures that close it the one with the least energy of springs within the limits is taken,
/// and a straight line is fitted to the path of each joint. Notes the loops that are left open.
void close_mjcf_loops(const std::set<std::string>& driven, MjcfModel& model);

}  // namespace morphe::robot
