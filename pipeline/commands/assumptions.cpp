#include "pipeline/commands/assumptions.hpp"

#include <fmt/format.h>

#include <cctype>
#include <set>

namespace morphe::commands {
namespace {

std::string without_numbers(const std::string& sentence) {
  std::string text;
  for (const char c : sentence) {
    if (!std::isdigit(static_cast<unsigned char>(c))) text += c;
  }
  return text;
}

}  // namespace

void Assumptions::add(const Demonstration& demonstration) {
  std::set<std::size_t> here;
  for (const std::string& sentence : demonstration.import_notes) {
    const auto [at, is_new] = at_.emplace(without_numbers(sentence), said_.size());
    if (is_new) said_.push_back({demonstration.name, sentence, 0});
    if (here.insert(at->second).second) ++said_[at->second].recordings;
  }
}

std::string Assumptions::text() const {
  std::string text;
  for (const Line& said : said_) {
    const std::string others =
        said.recordings > 1 ? fmt::format(" and {} more", said.recordings - 1) : "";
    text += fmt::format("  {}{}: {}\n", said.name, others, said.sentence);
  }
  return text;
}

}  // namespace morphe::commands
