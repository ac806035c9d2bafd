#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/files/csv.hpp"
#include "core/motion/geometry.hpp"

namespace morphe::imports {

/// A channel of a joint: the translation or rotation to which a number of a row applies.
struct BvhChannel {
  bool rotates = false;  ///< true for a rotation, false for a translation
  int axis = 0;          ///< 0 x, 1 y, 2 z
};

/// A joint of the hierarchy.
struct BvhJoint {
  std::string name;                  ///< an End Site is called "<parent>_end"
  int parent = -1;                   ///< -1 for the root
  Vec3 offset = Vec3::Zero();        ///< OFFSET from the parent
  std::vector<BvhChannel> channels;  ///< in the order of the row
};

/// The contents of a BVH file, in its own axes and unit, with angles in degrees.
struct BvhFile {
  files::CsvText text;
  std::vector<BvhJoint> joints;  ///< parents first
  double frame_s = 0;            ///< "Frame Time", not checked
  std::size_t frame_time_line = 0;
  int declared_frame_count = 0;  ///< "Frames"; the number of rows takes precedence
  JointRows rows;                ///< [frames, channels of all joints]
};

/// Reads a BVH file: keywords in any case, any blanks and tabs, a row of numbers per line. Throws
/// InputError for an unknown word, an unclosed bracket, a joint without OFFSET or named twice, a
/// channel named twice, a row that does not have one number per channel, and a file without rows.
BvhFile read_bvh_file(const std::filesystem::path& file);

/// The poses of all joints in the file's axes and unit.
struct BvhPoses {
  std::vector<Vec3> position;     ///< [joints]
  std::vector<Quat> orientation;  ///< [joints]
};
/// Computes the poses for one row. A joint's pose is that of its parent times T(p) R_1 R_2 R_3,
/// with rotations in the order of the channels; p is OFFSET, whose components position channels
/// replace. Without a row (nullptr) it computes the rest skeleton: p is OFFSET, there are no
/// rotations, and the root is at the origin.
void bvh_forward_kinematics(const BvhFile& bvh, const double* row, BvhPoses& poses);

}  // namespace morphe::imports
