#include "core/closure/contact.hpp"

#include <fmt/format.h>

namespace morphe::closure {

std::string validation_error(const ContactSet& set) {
  const auto& [mu, gamma_m] = set.friction;
  // The comparisons are written such that NaN fails too.
  if (!(mu >= 0 && mu < kInfinity)) return "friction must be 0 or more";
  if (!(gamma_m >= 0 && gamma_m < kInfinity)) return "torsional friction must be 0 or more";
  if (!(set.torque_scale_m > 0 && set.torque_scale_m < kInfinity))
    return "the torque scale must be above 0";
  if (!set.reference.allFinite()) return "the reference point must be finite";
  for (std::size_t k = 0; k < set.contacts.size(); ++k) {
    const Contact& contact = set.contacts[k];
    if (!contact.point.allFinite()) return fmt::format("contact {}: its point must be finite", k);
    if (!(std::abs(contact.normal.norm() - 1) < 1e-9))
      return fmt::format("contact {}: its normal is not a unit vector", k);
    if (!(contact.force_limit_share > 0 && contact.force_limit_share < kInfinity))
      return fmt::format("contact {}: its share must be above 0", k);
  }
  return "";
}

}  // namespace morphe::closure
