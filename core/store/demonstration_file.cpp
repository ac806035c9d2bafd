#include "core/store/demonstration_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/files/atomic_file.hpp"
#include "core/store/consistency.hpp"
#include "core/store/demonstration_layout.hpp"
#include "core/store/hdf5_file.hpp"

namespace morphe::store {
namespace {

constexpr const char* kDemonstrationFormat = "morphe-demonstrations";
constexpr int kDemonstrationVersion = 3;

}  // namespace

// Members are destroyed in reverse order: `output` after `file`, to remove an unfinished file.
struct DemonstrationWriter::State {
  files::AtomicFile output;
  Hdf5File file;
  Hdf5Group demonstrations;
};

DemonstrationWriter::DemonstrationWriter(const std::filesystem::path& path)
    : state_(new State{files::AtomicFile(path), {}, {}}) {
  state_->file = Hdf5File::create(state_->output.part());
  state_->file.set_display_name(path);
  const Hdf5Group root = state_->file.root();
  write_format(root, kDemonstrationFormat, kDemonstrationVersion);
  state_->demonstrations = root.create("demonstrations");
}

DemonstrationWriter::~DemonstrationWriter() = default;

void DemonstrationWriter::add(const Demonstration& demonstration) {
  const std::string fault = inconsistency(demonstration);
  if (!fault.empty())
    state_->demonstrations.throw_if_fault(fmt::format("{}/{}", demonstration.name, fault));
  LayoutWriter io(state_->demonstrations.create(demonstration.name));
  lay_out_demonstration(io, demonstration);
  state_->file.expect_written();
}

void DemonstrationWriter::finish() {
  state_->demonstrations = {};
  state_->file.close();
  state_->output.commit();
}

struct DemonstrationReader::State {
  Hdf5File file;
  Hdf5Group demonstrations;
  std::optional<std::vector<std::string>> names;
};

DemonstrationReader::DemonstrationReader(const std::filesystem::path& path) : state_(new State) {
  state_->file = Hdf5File::open(path);
  const Hdf5Group root = state_->file.root();
  check_format(root, kDemonstrationFormat, kDemonstrationVersion);
  state_->demonstrations = root.open("demonstrations");
}

DemonstrationReader::~DemonstrationReader() = default;

void DemonstrationReader::each_name(const std::function<void(const std::string&)>& visit) const {
  state_->demonstrations.each_child(visit);
}

const std::vector<std::string>& DemonstrationReader::names() const {
  if (!state_->names) state_->names = state_->demonstrations.children();
  return *state_->names;
}

Demonstration DemonstrationReader::read(const std::string& name) const {
  Demonstration demonstration;
  demonstration.name = name;
  LayoutReader io(state_->demonstrations.open(name));
  lay_out_demonstration(io, demonstration);
  state_->file.expect_unchanged();
  io.current_group().throw_if_fault(inconsistency(demonstration));
  return demonstration;
}

void DemonstrationReader::expect_unchanged() const { state_->file.expect_unchanged(); }

std::size_t DemonstrationReader::longest_stream_samples(const std::string& name) const {
  const Hdf5Group demonstration = state_->demonstrations.open(name);
  std::size_t max = 0;
  for (const char* stream : {"markers", "sensors", "skeleton", "arm_angles", "hand"})
    if (demonstration.has(stream)) max = std::max(max, demonstration.open(stream).length("time"));
  return max;
}

}  // namespace morphe::store
