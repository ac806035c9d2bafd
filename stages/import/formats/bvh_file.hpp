#pragma once

#include <array>
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

/// The contents of a BVH file: its own axes and unit, angles in degrees.
struct BvhFile {
  files::CsvText text;                   ///< lines of the file
  std::vector<BvhJoint> joints;          ///< parents first
  double frame_s = 0;                    ///< "Frame Time", not checked
  std::size_t frame_time_line = 0;       ///< line of "Frame Time"
  std::size_t declared_frame_count = 0;  ///< "Frames"; the number of rows takes precedence
  JointRows rows;                        ///< [frames, channels of all joints]
};

/// Reads a BVH file: keywords in any case, any blanks and tabs, a row of numbers per line. Throws
/// InputError for any error: an unknown word, an unclosed bracket, a joint without OFFSET or named
/// twice, a channel named twice, a row with too few or too many numbers or another word, or no
/// rows.
BvhFile read_bvh_file(const std::filesystem::path& file);

/// The poses of all joints in the file's axes and unit.
struct BvhPoses {
  std::vector<Vec3> position;     ///< [joints]
  std::vector<Quat> orientation;  ///< [joints]
};
/// Computes the poses for one row: T(p) R_1 R_2 R_3 in the order of the channels after the parent's
/// pose, with p = OFFSET, replaced by the values of position channels. Without a row (nullptr) it
/// computes the rest skeleton: p = OFFSET and no rotation, the root at the origin.
void bvh_forward_kinematics(const BvhFile& bvh, const double* row, BvhPoses& poses);

}  // namespace morphe::imports
