#pragma once

#include <string>
#include <vector>

namespace morphe::imports {

/// Returns the body part that one of Morphe's own names denotes, such as "left upper arm", "right
/// index tip"; "" for any other name. Joints: right_shoulder, right_elbow, right_wrist, right_hip,
/// right_index_mcp, _pip, _dip, _tip (thumb: _cmc, _mcp, _ip, _tip), left_…. Markers, as in
/// stages/reconstruct/reconstruct.hpp: RSHO1, RUAR1, RLAR1, RHAN1, … of clusters, RGTH, RLEP, RMEP,
/// RSPR, RSPU, RFB, RFTP, RTHUM, L….
std::string body_part(const std::string& name);

/// Returns true if the name is one of Morphe's names of joints, listed above.
bool is_joint_name(const std::string& name);

/// Returns the joints of kFingerNames[finger] from base to tip: "index_mcp" … "index_tip".
std::vector<std::string> finger_joint_names(std::size_t finger);

}  // namespace morphe::imports
