#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "core/motion/assumption.hpp"
#include "core/motion/clearance_kind.hpp"

namespace morphe::commands {

/// Returns [{kind, subject, value}].
nlohmann::json assumptions_json(const std::vector<Assumption>& assumptions);
/// Returns the assumptions of that JSON. Throws nlohmann::json::exception if it is another one.
std::vector<Assumption> assumptions_of_json(const nlohmann::json& list);

/// Returns [{kind, clearance, first, second, time}] [m, s].
nlohmann::json clearances_json(const std::vector<KindClearance>& clearances);
/// Returns the clearances of that JSON. Throws nlohmann::json::exception if it is another one.
std::vector<KindClearance> clearances_of_json(const nlohmann::json& list);

}  // namespace morphe::commands
