#include "pipeline/store/demonstration_file.hpp"

#include <fmt/format.h>

#include "pipeline/store/consistency.hpp"
#include "pipeline/store/demonstration_layout.hpp"
#include "pipeline/store/hdf5_file.hpp"
#include "pipeline/store/part_file.hpp"

namespace morphe {
namespace {

constexpr const char* kFormat = "morphe-demonstrations";
constexpr int kVersion = 1;

}  // namespace

// Members close in reverse order: groups, then the file, then what is left of it is removed.
struct DemonstrationWriter::State {
  PartFile part;
  Hdf5File file;
  Hdf5Group demonstrations;
};

DemonstrationWriter::DemonstrationWriter(const std::filesystem::path& path)
    : state_(new State{PartFile(path), {}, {}}) {
  state_->file = Hdf5File::create(state_->part.part());
  state_->file.call_it(path);
  const Hdf5Group root = state_->file.root();
  write_format(root, kFormat, kVersion);
  state_->demonstrations = root.create("demonstrations");
}

DemonstrationWriter::~DemonstrationWriter() = default;

void DemonstrationWriter::add(const Demonstration& demonstration) {
  const std::string fault = inconsistency(demonstration);
  if (!fault.empty())
    state_->demonstrations.refuse(fmt::format("{}/{}", demonstration.name, fault));
  LayoutWriter io(state_->demonstrations.create(demonstration.name));
  lay_out_demonstration(io, demonstration);
}

void DemonstrationWriter::finish() {
  state_->demonstrations = {};
  state_->file.close();
  state_->part.commit();
}

struct DemonstrationReader::State {
  Hdf5File file;
  Hdf5Group demonstrations;
};

DemonstrationReader::DemonstrationReader(const std::filesystem::path& path) : state_(new State) {
  state_->file = Hdf5File::open(path);
  const Hdf5Group root = state_->file.root();
  check_format(root, kFormat, kVersion);
  state_->demonstrations = root.open("demonstrations");
  names_ = state_->demonstrations.children();
}

DemonstrationReader::~DemonstrationReader() = default;

Demonstration DemonstrationReader::read(std::size_t index) const {
  Demonstration demonstration;
  demonstration.name = names_.at(index);
  LayoutReader io(state_->demonstrations.open(demonstration.name));
  lay_out_demonstration(io, demonstration);
  io.here().refuse(inconsistency(demonstration));
  return demonstration;
}

}  // namespace morphe
