#include "pipeline/explain/reason_sentence.hpp"

#include <array>

namespace morphe::explain {

std::string_view reason_sentence(Reason reason) {
  constexpr std::array<std::string_view, enum_count<Reason>()> kSentences{
      "",
      "Not planned yet.",
      "The demonstration has no complete reach, or it could not be reconstructed.",
      "The person's shoulder was never seen during the movement.",
      "No fingertip was seen, or the movement has fewer than five frames.",
      "The reconstructed arm exceeds human joint limits.",
      "The recording has a flag that the config refuses (audit.refuse).",
      "The robot collides at the first sample, in every posture found.",
      "At some time every posture found that reaches the goals collides.",
      "At some time no posture found reaches the goals, with or without obstacles.",
      "The path collides, and no detour was found.",
      "The path is collision-free, but the smooth curve through it is not.",
      "A joint would exceed its limits.",
      "The joints jump from one frame to the next, and no repair closed the gap.",
      "A fingertip is farther from its goal than the tolerance of the phase.",
      "The path to be timed is not a valid path of this robot.",
      "The path cannot be followed in the requested time.",
      "No collision-free path from the home posture to the first sample was found.",
      "No collision-free path from the last sample back to the home posture was found.",
      "An object of the scene is placed relative to something that does not exist.",
      "The independent verification rejects the trajectory: a fault of Morphe."};
  return kSentences.at(static_cast<std::size_t>(reason));
}

}  // namespace morphe::explain
