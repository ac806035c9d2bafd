#include "core/store/plan_header.hpp"

#include <fmt/format.h>

#include "core/store/assumption_layout.hpp"

namespace morphe::store {
namespace {

// Limits the reading of files whose groups link in circles.
constexpr int kMaxInputCount = 10000;
constexpr int kMaxFolderDepth = 64;

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
      folder.write_text(input.path, input.text);
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
      inputs.push_back({prefix + name, folder.read_text(name)});
    }
  }
}

}  // namespace

void write_plan_header(const Hdf5Group& root, const PlanFileHeader& header,
                       const std::string& robot_name) {
  root.set("config", header.config);
  root.set("config_sha256", header.config_sha256);
  root.set("dataset_sha256", header.dataset_sha256);
  root.set("software", header.software);
  root.set("built_with", header.built_with);
  root.set("robot", robot_name);
  write_inputs(root.create("inputs"), header.inputs);
  if (header.assumptions.empty()) return;
  LayoutWriter io(root.create(kAssumptionsGroup));
  lay_out_assumption_rows(io, header.assumptions);
}

PlanFileHeader read_plan_header(const Hdf5Group& root) {
  PlanFileHeader header;
  root.get("config", header.config);
  root.get("config_sha256", header.config_sha256);
  root.get("dataset_sha256", header.dataset_sha256);
  root.get("software", header.software);
  if (root.has_attribute("built_with")) root.get("built_with", header.built_with);
  int visits_left = kMaxInputCount;
  read_inputs(root.open("inputs"), "", 0, visits_left, header.inputs);
  if (root.has(kAssumptionsGroup)) {
    LayoutReader io(root.open(kAssumptionsGroup));
    lay_out_assumption_rows(io, header.assumptions);
  }
  return header;
}

}  // namespace morphe::store
