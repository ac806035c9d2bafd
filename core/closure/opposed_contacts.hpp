#pragma once

#include "core/closure/contact.hpp"

namespace morphe::closure {

/// Returns true if two contacts are opposed (antipodal): their points are apart, and the line
/// between them is inside both friction cones,
///   n_a · d ≥ cos(atan mu) and n_b · (-d) ≥ cos(atan mu), with d the direction from a to b.
/// They can then press against each other with any force without slipping. Two soft fingers have
/// force closure exactly if they are opposed, not on the cones' boundaries.
bool are_opposed(const Contact& a, const Contact& b, double friction_coefficient);

/// Returns true if two contacts of the set are opposed.
bool has_opposed_contacts(const ContactSet& set);

}  // namespace morphe::closure
