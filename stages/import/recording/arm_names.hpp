#pragma once

#include <string>
#include <vector>

namespace morphe::imports {

/// Returns the body part denoted by one of Morphe's own names, such as "right shoulder", "left
/// upper arm", "right index tip"; "" for any other name. Joints are named right_shoulder,
/// right_elbow, right_wrist, right_hip, right_index_mcp, _pip, _dip, _tip (thumb: _cmc, _mcp, _ip,
/// _tip) and left_…; markers as in stages/reconstruct/reconstruct.hpp: RSHO1, RUAR1, RLAR1, RHAN1,
/// … of clusters, RGTH, RLEP, RMEP, RSPR, RSPU, RFB, RFTP, RTHUM, and L….
std::string body_part(const std::string& name);

/// Returns true if it names a joint, in the words above, not a marker.
bool is_joint_name(const std::string& name);

/// Returns the suffixes of the joints of a finger from its base to its tip: "index_mcp" …
/// "index_tip".
std::vector<std::string> finger_joint_names(std::size_t finger);

}  // namespace morphe::imports
