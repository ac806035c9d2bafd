#include "pipeline/setup/edited_chains.hpp"

#include "core/config/node.hpp"
#include "pipeline/setup/merge_sections.hpp"

namespace morphe::setup {

void follow_edited_chains(const std::string& before, SetupRequest& request) {
  const auto edited = edited_sections(before);
  const auto chains = edited.find("chains");
  if (chains == edited.end()) return;
  const config::ConfigNode root = config::ConfigNode::parse(chains->second, request.out.string());
  if (!root.is_map() || !root.has("chains")) return;
  for (const config::ConfigNode& chain : root["chains"].items()) {
    if (chain["name"].text() != "arm") continue;
    if (chain.has("first")) request.first = chain["first"].text();
    if (chain.has("last")) request.last = chain["last"].text();
  }
}

}  // namespace morphe::setup
