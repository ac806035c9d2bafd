#include "stages/import/guess/finger_joint.hpp"

#include <vector>

#include "core/motion/human_motion.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {

std::string finger_joint_of(const RecordedName& name, std::size_t finger_index) {
  using enum BodyTerm;
  const std::vector<std::string> joints = finger_joint_names(finger_index);
  const bool thumb_joints = finger_index == kThumb;
  if (name.has(tip)) return joints[3];
  if (name.has(metacarpal) || name.has(cmc)) return thumb_joints ? joints[0] : "";
  if (name.has(mcp) || name.has(proximal)) return joints[thumb_joints ? 1 : 0];
  if (name.has(ip) || (thumb_joints && (name.has(distal) || name.has(dip)))) return joints[2];
  if (name.has(pip) || name.has(intermediate)) return thumb_joints ? "" : joints[1];
  if (name.has(dip) || name.has(distal)) return joints[2];
  if (name.numbers.empty()) return joints[3];
  const int number = name.numbers.back();
  return number >= 1 && number <= 4 ? joints[number - 1] : "";
}

}  // namespace morphe::imports
