#include "pipeline/run/serialize_summary.hpp"

#include <nlohmann/json.hpp>

#include "core/motion/input_error.hpp"

namespace morphe::run {

std::string serialize_summary(const BatchSummary& s) {
  return nlohmann::json{{"demonstrations", s.demonstrations},
                        {"movements", s.movements},
                        {"executable", s.executable},
                        {"approximate", s.approximate},
                        {"infeasible", s.infeasible},
                        {"repaired", s.repaired},
                        {"failed", s.failed},
                        {"reasons", s.reasons},
                        {"stage_cpu_s", s.stage_cpu_s},
                        {"mapped", s.mapped},
                        {"frames", s.frames},
                        {"goals", s.goals},
                        {"out_of_reach", s.out_of_reach}}
      .dump();
}

BatchSummary deserialize_summary(const std::string& text) {
  BatchSummary s;
  try {
    const nlohmann::json json = nlohmann::json::parse(text);
    json.at("demonstrations").get_to(s.demonstrations);
    json.at("movements").get_to(s.movements);
    json.at("executable").get_to(s.executable);
    s.approximate = json.value("approximate", 0);  // absent in journals of earlier versions
    json.at("infeasible").get_to(s.infeasible);
    json.at("repaired").get_to(s.repaired);
    json.at("failed").get_to(s.failed);
    json.at("reasons").get_to(s.reasons);
    json.at("stage_cpu_s").get_to(s.stage_cpu_s);
    s.mapped = json.value("mapped", std::int64_t{0});  // absent there as well
    s.frames = json.value("frames", std::int64_t{0});
    json.at("goals").get_to(s.goals);
    json.at("out_of_reach").get_to(s.out_of_reach);
  } catch (const nlohmann::json::exception&) {
    throw InputError("is not a summary of a demonstration");
  }
  return s;
}

}  // namespace morphe::run
