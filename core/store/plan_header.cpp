#include "core/store/plan_header.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <sstream>
#include <utility>

#include "core/files/sha256.hpp"
#include "core/files/text_encoding.hpp"
#include "core/store/assumption_layout.hpp"

namespace morphe::store {
namespace {

// Limits the reading of files whose groups link in circles.
constexpr int kMaxInputCount = 10000;
constexpr int kMaxFolderDepth = 64;
constexpr const char* kInputsGroup = "inputs";

void write_input(const Hdf5Group& folder, const PlanFileHeader::Input& input) {
  if (input.text.find('\0') == input.text.npos && files::is_utf8(input.text))
    return folder.write_text(input.path, input.text);
  folder.write<std::uint8_t>(input.path,
                             {{input.text.size()}, {input.text.begin(), input.text.end()}});
}

std::string read_input(const Hdf5Group& folder, const std::string& name) {
  if (folder.type_of(name) == "text") return folder.read_text(name);
  const std::vector<std::uint8_t> bytes = folder.read<std::uint8_t>(name, {kAnyLength}).values;
  return {bytes.begin(), bytes.end()};
}

/// Returns the settings, each followed by a line feed.
std::string lines_of(const std::vector<std::string>& settings) {
  std::string lines;
  for (const std::string& setting : settings) lines += setting + '\n';
  return lines;
}

std::vector<std::string> settings_of(const std::string& lines) {
  std::vector<std::string> settings;
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) settings.push_back(line);
  return settings;
}

/// Lays out the root attributes that the header has.
template <class Io, class T>
void lay_out_header_attributes(Io& io, T& header) {
  io.attribute("config", header.config);
  io.attribute("config_sha256", header.config_sha256);
  io.attribute("dataset_sha256", header.dataset_sha256);
  io.attribute("software", header.software);
  io.optional_attribute("built_with", header.built_with);
  std::string settings = lines_of(header.settings);
  io.optional_attribute("settings", settings);
  if constexpr (Io::reading) header.settings = settings_of(settings);
  io.optional_attribute("inputs_sha256", header.inputs_sha256);
}

/// Writes the inputs of a folder, in an order that reading and writing them again preserves.
void write_inputs(const Hdf5Group& folder, std::vector<PlanFileHeader::Input> inputs) {
  for (PlanFileHeader::Input& input : inputs) {
    while (input.path.starts_with("./")) input.path.erase(0, 2);
    if (input.path.empty() || input.path == "." || input.path.front() == '/')
      folder.fail(fmt::format("'{}' is not a relative file path", input.path));
  }
  while (!inputs.empty()) {
    const PlanFileHeader::Input input = inputs.front();
    const std::size_t slash = input.path.find('/');
    if (slash == std::string::npos) {
      write_input(folder, input);
      inputs.erase(inputs.begin());
      continue;
    }
    const std::string prefix = input.path.substr(0, slash + 1);
    std::vector<PlanFileHeader::Input> inside, others;
    for (const PlanFileHeader::Input& other : inputs) {
      const bool is_inside = other.path.starts_with(prefix);
      (is_inside ? inside : others).push_back(other);
      if (is_inside) inside.back().path.erase(0, prefix.size());
    }
    write_inputs(folder.create(prefix.substr(0, slash)), std::move(inside));
    inputs = std::move(others);
  }
}

/// Appends the inputs of a folder; `visits_left` files and folders may still be visited.
void read_inputs(const Hdf5Group& folder, const std::string& prefix, int depth, int& visits_left,
                 std::vector<PlanFileHeader::Input>& inputs) {
  if (depth > kMaxFolderDepth) folder.fail("is nested too deeply");
  for (const std::string& name : folder.children()) {
    if (--visits_left < 0) folder.fail("has too many files");
    if (folder.is_group(name)) {
      read_inputs(folder.open(name), prefix + name + "/", depth + 1, visits_left, inputs);
    } else {
      inputs.push_back({prefix + name, read_input(folder, name)});
    }
  }
}

/// Compares the files of a folder, whose names are free.
void compare_inputs(LayoutContract& folder) {
  const Hdf5Group& group = folder.current_group();
  for (const std::string& name : group.children()) {
    if (group.is_group(name)) {
      folder.group(name, [](LayoutContract& inner) { compare_inputs(inner); });
    } else {
      folder.file(name);
    }
  }
}

}  // namespace

std::string inputs_hash(const PlanFileHeader& header) {
  std::map<std::string, std::string> hashes;
  for (const PlanFileHeader::Input& input : header.inputs)
    hashes[input.path] = files::sha256(input.text);
  std::string lines = files::sha256(lines_of(header.settings)) + "  settings\n";
  for (const auto& [path, hash] : hashes) lines += fmt::format("{}  inputs/{}\n", hash, path);
  return files::sha256(lines + header.dataset_sha256 + "  dataset\n");
}

void write_plan_header(Hdf5Group root, PlanFileHeader header, const std::string& robot_name) {
  for (const std::string& setting : header.settings) {
    if (setting.find('\n') != setting.npos)
      root.fail("@settings", fmt::format("'{}' must be a single line", setting));
  }
  header.inputs_sha256 = inputs_hash(header);
  LayoutWriter io(std::move(root));
  lay_out_header_attributes(io, header);
  io.attribute("robot", robot_name);
  write_inputs(io.current_group().create(kInputsGroup), header.inputs);
  lay_out_assumptions(io, header.assumptions);
}

PlanFileHeader read_plan_header(Hdf5Group root) {
  PlanFileHeader header;
  LayoutReader io(std::move(root));
  lay_out_header_attributes(io, header);
  int visits_left = kMaxInputCount;
  read_inputs(io.current_group().open(kInputsGroup), "", 0, visits_left, header.inputs);
  lay_out_assumptions(io, header.assumptions);
  return header;
}

void compare_plan_header(LayoutContract& io, const PlanFileHeader& header,
                         const std::string& robot_name) {
  lay_out_header_attributes(io, header);
  io.attribute("robot", robot_name);
  io.group(kInputsGroup, [&](LayoutContract& in) { compare_inputs(in); });
  lay_out_assumptions(io, header.assumptions);
}

}  // namespace morphe::store
