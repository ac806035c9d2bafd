#pragma once

#include <string>
#include <vector>

namespace morphe::imports {

/// What one of Morphe's own names stands for: "right shoulder", "left upper arm", "right index
/// tip";
/// "" for any other name. Joints are called right_shoulder, right_elbow, right_wrist, right_hip,
/// right_index_mcp, _pip, _dip, _tip (thumb: _cmc, _mcp, _ip, _tip) and left_…; markers as
/// stages/reconstruct/reconstruct.hpp says: RSHO1, RUAR1, RLAR1, RHAN1, … of clusters, RGTH, RLEP,
/// RMEP, RSPR, RSPU, RFB, RFTP, RTHUM, and L….
std::string body_part(const std::string& name);

/// Whether it names a joint, in the words above, not a marker.
bool is_joint_name(const std::string& name);

/// Joints of a finger from its base to its tip, as a side's names end: "index_mcp" … "index_tip".
std::vector<std::string> finger_joint_names(std::size_t finger);

}  // namespace morphe::imports
