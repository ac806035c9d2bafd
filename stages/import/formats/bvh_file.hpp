#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/files/csv.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// One number of a row: what it does to its joint.
struct BvhChannel {
  bool rotates = false;
  int axis = 0;  ///< 0 x, 1 y, 2 z
};

struct BvhJoint {
  std::string name;  ///< an End Site is called "<parent>_end"
  int parent = -1;   ///< -1 = the root
  Vec3 offset = Vec3::Zero();
  std::vector<BvhChannel> channels;  ///< in the order of the row
};

/// A BVH file as it stands there: its own axes and unit, angles in degrees.
struct BvhFile {
  files::CsvText text;
  std::vector<BvhJoint> joints;  ///< parents first
  double frame_s = 0;            ///< "Frame Time", not checked
  std::size_t frame_time_line = 0;
  std::size_t frames_said = 0;  ///< "Frames"; the rows are what counts
  JointRows rows;               ///< [frames, channels of all joints]
};

/// Keywords in any case, blanks and tabs as they come, a row of numbers a line. InputError for
/// anything else: an unknown word, a bracket left open, a joint without OFFSET or named twice, a
/// channel named twice, a row with too few or too many numbers or one that is none, no row at all.
BvhFile read_bvh_file(const std::filesystem::path& file);

/// Poses of all joints for one row, in the file's axes and unit: T(p) R_1 R_2 R_3 in the order of
/// the channels after the parent's pose, p = OFFSET, with what position channels give put in its
/// place. No row (nullptr): the rest skeleton, p = OFFSET and no rotation, the root at the origin.
struct BvhPoses {
  std::vector<Vec3> position;     ///< [joints]
  std::vector<Quat> orientation;  ///< [joints]
};
void pose_bvh(const BvhFile& bvh, const double* row, BvhPoses& poses);

}  // namespace morphe::imports
