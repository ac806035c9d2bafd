#include "pipeline/store/plan_header.hpp"

#include <fmt/format.h>

namespace morphe {
namespace {

// A file whose groups link in circles ends here.
constexpr int kMostInputs = 10000;
constexpr int kDeepest = 64;

void write_input(const Hdf5Group& folder, const std::string& path, const std::string& text) {
  const std::size_t slash = path.find('/');
  const std::string first = path.substr(0, slash);
  if (first.empty()) folder.fail(fmt::format("'{}' is not a relative path of a file", path));
  if (slash == std::string::npos) {
    if (first == ".") folder.fail("'.' is not a path of a file");
    folder.write_text(first, text);
  } else if (first == ".") {
    write_input(folder, path.substr(slash + 1), text);
  } else {
    const bool there = folder.has(first) && folder.is_group(first);
    write_input(there ? folder.open(first) : folder.create(first), path.substr(slash + 1), text);
  }
}

/// `left` is how many members may still be visited.
void read_inputs(const Hdf5Group& folder, const std::string& prefix, int depth, int& left,
                 std::vector<PlanFileHeader::Input>& inputs) {
  if (depth > kDeepest) folder.fail("lies too deep");
  for (const std::string& name : folder.children()) {
    if (--left < 0) folder.fail("holds too many files");
    if (folder.is_group(name)) {
      read_inputs(folder.open(name), prefix + name + "/", depth + 1, left, inputs);
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
  root.set("robot", robot_name);
  const Hdf5Group inputs = root.create("inputs");
  for (const PlanFileHeader::Input& input : header.inputs)
    write_input(inputs, input.path, input.text);
}

PlanFileHeader read_plan_header(const Hdf5Group& root) {
  PlanFileHeader header;
  root.get("config", header.config);
  root.get("config_sha256", header.config_sha256);
  root.get("dataset_sha256", header.dataset_sha256);
  root.get("software", header.software);
  int left = kMostInputs;
  read_inputs(root.open("inputs"), "", 0, left, header.inputs);
  return header;
}

}  // namespace morphe
