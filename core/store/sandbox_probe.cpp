#include "core/store/sandbox_probe.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <new>
#include <string>
#include <system_error>

#include "core/files/read_in_child.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/hdf5_file.hpp"
#include "core/store/hdf5_signature.hpp"

namespace morphe::store {
namespace {

/// Calls `read` and ignores errors in the file, which the file's reader reports.
template <class Read>
void ignore_input_errors(const Read& read) {
  try {
    read();
  } catch (const InputError&) {
  }
}

void read_object(const Hdf5Group& root, const std::string& name, bool is_dataset) {
  if (is_dataset) ignore_input_errors([&] { root.value(name); });
  ignore_input_errors([&] {
    for (const std::string& attribute : root.attributes(name.c_str()))
      ignore_input_errors([&] { root.value_of_attribute(attribute, name.c_str()); });
  });
}

struct VisitState {
  const Hdf5Group& root;
  bool out_of_memory = false;
};

template <class Info>
herr_t visit_object(hid_t, const char* name, const Info* info, void* state) {
  auto& visit = *static_cast<VisitState*>(state);
  try {
    read_object(visit.root, name, info->type == H5O_TYPE_DATASET);
  } catch (const std::bad_alloc&) {
    visit.out_of_memory = true;
    return -1;
  }
  return 0;
}

/// Reads every object of a file once, however many paths lead to the object.
void read_everything(const std::filesystem::path& path) {
  const Hdf5File file = Hdf5File::open(path);
  const Hdf5Group root = file.root();
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // The file is already open, and HDF5 opens it again only with the same close degree.
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  const Hdf5Id id(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose);
  VisitState state{root};
#if H5_VERSION_GE(1, 12, 0)
  H5Ovisit3(id.get(), H5_INDEX_NAME, H5_ITER_NATIVE, visit_object<H5O_info2_t>, &state,
            H5O_INFO_BASIC);
#else
  H5Ovisit2(id.get(), H5_INDEX_NAME, H5_ITER_NATIVE, visit_object<H5O_info_t>, &state,
            H5O_INFO_BASIC);
#endif
  if (state.out_of_memory) throw std::bad_alloc();
}

}  // namespace

void probe_in_sandbox(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || !has_hdf5_signature(file)) return;
  const std::string fault = files::child_read_error(file, [&] { read_everything(file); });
  if (!fault.empty()) throw InputError(fmt::format("{}: cannot be read: {}", file.string(), fault));
}

}  // namespace morphe::store
