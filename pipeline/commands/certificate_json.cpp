#include "pipeline/commands/certificate_json.hpp"

#include <string>

namespace morphe::commands {

nlohmann::json assumptions_json(const std::vector<Assumption>& assumptions) {
  nlohmann::json list = nlohmann::json::array();
  for (const Assumption& each : assumptions)
    list.push_back(
        {{"kind", name_of(each.kind)}, {"subject", each.subject}, {"value", each.value}});
  return list;
}

std::vector<Assumption> assumptions_of_json(const nlohmann::json& list) {
  std::vector<Assumption> assumptions;
  for (const nlohmann::json& each : list)
    assumptions.push_back({enum_from_name<AssumptionKind>(each.at("kind").get<std::string>())
                               .value_or(AssumptionKind::assumed),
                           each.at("subject").get<std::string>(),
                           each.at("value").get<std::string>()});
  return assumptions;
}

nlohmann::json clearances_json(const std::vector<KindClearance>& clearances) {
  nlohmann::json list = nlohmann::json::array();
  for (const KindClearance& each : clearances)
    list.push_back({{"kind", name_of(each.kind)},
                    {"clearance", each.clearance},
                    {"first", each.first},
                    {"second", each.second},
                    {"time", each.time_s}});
  return list;
}

std::vector<KindClearance> clearances_of_json(const nlohmann::json& list) {
  std::vector<KindClearance> clearances;
  for (const nlohmann::json& each : list)
    clearances.push_back({enum_from_name<ClearanceKind>(each.at("kind").get<std::string>())
                              .value_or(ClearanceKind::self),
                          each.at("clearance").get<double>(), each.at("first").get<std::string>(),
                          each.at("second").get<std::string>(), each.at("time").get<double>()});
  return clearances;
}

}  // namespace morphe::commands
