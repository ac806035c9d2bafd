#include "core/store/hdf5_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <type_traits>
#include <utility>

#include "core/files/item_name.hpp"
#include "core/files/printable.hpp"
#include "core/files/unfinished_path.hpp"
#include "core/store/hdf5_output.hpp"
#include "core/store/hdf5_types.hpp"

namespace morphe::store {
namespace {

static_assert(std::is_same_v<hid_t, Hdf5Id::Id> && std::is_same_v<herr_t, int>);

// Up to this number, the links or attributes of a group are stored in its object header, which is
// far smaller than the heaps and trees that HDF5 creates for more of them.
constexpr unsigned kMaxCompactEntries = 64;
constexpr unsigned kMinDenseEntries = 32;

constexpr std::size_t kMetadataCacheBytes = std::size_t{256} << 10;

/// Sets the properties that make the bytes of a new group reproducible and its links ordered.
void describe_group(hid_t properties) {
  H5Pset_obj_track_times(properties, false);
  H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_link_phase_change(properties, kMaxCompactEntries, kMinDenseEntries);
  H5Pset_attr_phase_change(properties, kMaxCompactEntries, kMinDenseEntries);
}

Hdf5Id properties(hid_t kind) { return {H5Pcreate(kind), H5Pclose}; }

/// Suppresses the error messages that HDF5 prints, which must be done in every thread.
void silence_hdf5_errors() {
  [[maybe_unused]] thread_local const bool off = H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) >= 0;
}

/// Disables external links, so that links into other files cannot be followed.
void disable_external_links() {
  [[maybe_unused]] static const bool disabled = H5Lunregister(H5L_TYPE_EXTERNAL) >= 0;
}

Hdf5Id access_properties() {
  silence_hdf5_errors();
  disable_external_links();
  Hdf5Id access = properties(H5P_FILE_ACCESS);
  // Uses checksummed headers, and no tree for a dataset of one chunk.
  H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  // Bounds the cache whatever the file's size; in memory an entry takes about 16 times its bytes.
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  H5Pget_mdc_config(access.get(), &cache);
  cache.set_initial_size = true;
  cache.initial_size = cache.min_size = cache.max_size = kMetadataCacheBytes;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  H5Pset_mdc_config(access.get(), &cache);
  return access;
}

/// A function to be called for each link, and its exception, kept until HDF5 has returned.
struct Visit {
  const std::function<void(const std::string&)>& call;
  std::exception_ptr thrown;
};

herr_t visit_link(hid_t, const char* name, const H5L_info_t*, void* data) {
  auto* const state = static_cast<Visit*>(data);
  try {
    state->call(name);
  } catch (...) {
    state->thrown = std::current_exception();
    return -1;
  }
  return 0;
}

}  // namespace

Hdf5Id::Hdf5Id(Hdf5Id&& other) noexcept
    : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}

Hdf5Id& Hdf5Id::operator=(Hdf5Id&& other) noexcept {
  if (this != &other) {
    reset();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
  }
  return *this;
}

bool Hdf5Id::reset() {
  const bool closed = !valid() || close_(id_) >= 0;
  id_ = H5I_INVALID_HID;
  return closed;
}

Hdf5File Hdf5File::create(const std::filesystem::path& path, files::Disk& disk) {
  Hdf5File file;
  const Hdf5Id access = access_properties();
  write_through_output_driver(access.get(), disk);
  // Allocates no blocks in advance, of whose unused rests HDF5 would keep a list in memory.
  H5Pset_meta_block_size(access.get(), 0);
  H5Pset_small_data_block_size(access.get(), 0);
  const Hdf5Id creation = properties(H5P_FILE_CREATE);
  describe_group(creation.get());
  file.name_ = path.string();
  const auto held = files::hold_end();
  file.id_ = {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose};
  if (!file.id_.valid()) throw InputError(fmt::format("{}: cannot be created", file.name_));
  return file;
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  Hdf5File file;
  file.name_ = path.string();
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || ::access(path.c_str(), R_OK) != 0)
    throw InputError(fmt::format("{}: cannot be opened: {}", file.name_, std::strerror(errno)));
  if (!S_ISREG(status.st_mode)) throw InputError(file.name_ + ": is not a regular file");
  const Hdf5Id access = access_properties();
  file.id_ = {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose};
  if (!file.id_.valid()) throw InputError(file.name_ + ": is not a readable HDF5 file");
  file.opened_ = file.state();
  return file;
}

Hdf5Group Hdf5File::root() const {
  Hdf5Id id(H5Gopen2(id_.get(), "/", H5P_DEFAULT), H5Gclose);
  if (!id.valid()) throw InputError(fmt::format("{}: is not a readable HDF5 file", name_));
  return {std::move(id), name_, ""};
}

Hdf5File::State Hdf5File::state() const {
  void* handle = nullptr;
  struct stat now {};
  if (H5Fget_vfd_handle(id_.get(), H5P_DEFAULT, &handle) < 0 ||
      ::fstat(*static_cast<const int*>(handle), &now) != 0)
    throw InputError(fmt::format("{}: cannot be read", name_));
  return {now.st_size, now.st_mtim.tv_sec, now.st_mtim.tv_nsec};
}

void Hdf5File::expect_unchanged() const {
  if (state() != opened_)
    throw InputError(fmt::format("{}: was changed by another process while being read", name_));
}

void Hdf5File::expect_written(int error) const {
  if (error != 0)
    throw InputError(fmt::format("{}: cannot be written: {}", name_, std::strerror(error)));
}

void Hdf5File::expect_written() const { expect_written(hdf5_output_error(id_.get())); }

void Hdf5File::close() {
  int error = 0;
  report_hdf5_output_error(id_.get(), error);
  if (!id_.reset()) throw InputError(fmt::format("{}: cannot be written", name_));
  expect_written(error);
}

Hdf5Group Hdf5Group::create(const std::string& name) const {
  silence_hdf5_errors();
  if (!files::is_item_name(name))
    fail(fmt::format("'{}' is not a valid name: {}", name, files::kItemNameError));
  if (has(name)) fail(name, "already exists");
  const Hdf5Id creation = properties(H5P_GROUP_CREATE);
  describe_group(creation.get());
  Hdf5Id id(H5Gcreate2(id_.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
            H5Gclose);
  if (!id.valid()) fail(name, "cannot be written");
  return {std::move(id), file_, path_ + "/" + name};
}

bool Hdf5Group::has(const std::string& name) const {
  return H5Lexists(id_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5Group::is_group(const std::string& name) const {
  const Hdf5Id id(H5Oopen(id_.get(), name.c_str(), H5P_DEFAULT), H5Oclose);
  return id.valid() && H5Iget_type(id.get()) == H5I_GROUP;
}

Hdf5Group Hdf5Group::open(const std::string& name) const {
  silence_hdf5_errors();
  if (is_external_link(id_.get(), name)) fail(name, "is a link into another file");
  if (!has(name)) fail(name, "is missing");
  Hdf5Id id(H5Gopen2(id_.get(), name.c_str(), H5P_DEFAULT), H5Gclose);
  if (!id.valid()) fail(name, "is not a readable group");
  return {std::move(id), file_, path_ + "/" + name};
}

std::vector<std::string> Hdf5Group::children() const {
  std::vector<std::string> names;
  each_child([&](const std::string& name) { names.push_back(name); });
  return names;
}

void Hdf5Group::each_child(const std::function<void(const std::string&)>& visit) const {
  unsigned order = 0;
  const Hdf5Id creation(H5Gget_create_plist(id_.get()), H5Pclose);
  if (creation.valid()) H5Pget_link_creation_order(creation.get(), &order);
  const H5_index_t index = (order & H5P_CRT_ORDER_TRACKED) ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
  const std::function<void(const std::string&)> checked_visit = [&](const std::string& name) {
    if (!files::is_printable(name))
      fail(fmt::format("'{}' is not a valid name: it contains control characters", name));
    visit(name);
  };
  Visit state{checked_visit, nullptr};
  const herr_t status = H5Literate(id_.get(), index, H5_ITER_INC, nullptr, visit_link, &state);
  if (state.thrown) std::rethrow_exception(state.thrown);
  if (status < 0) fail("is not a readable group");
}

void Hdf5Group::fail(const std::string& message) const {
  throw InputError(
      fmt::format("{}:{}: {}", file_, path_.empty() ? "/" : path_, files::make_printable(message)));
}

void Hdf5Group::fail(const std::string& name, const std::string& message) const {
  throw InputError(fmt::format("{}: {}", where(name), files::make_printable(message)));
}

void Hdf5Group::throw_if_fault(const std::string& fault) const {
  if (!fault.empty()) throw InputError(where(fault));
}

std::string Hdf5Group::where(const std::string& name) const {
  return fmt::format("{}:{}/{}", file_, path_, files::make_printable(name));
}

std::size_t Hdf5Group::file_bytes() const {
  const Hdf5Id file(H5Iget_file_id(id_.get()), H5Fclose);
  hsize_t bytes = 0;
  if (!file.valid() || H5Fget_filesize(file.get(), &bytes) < 0) return 0;
  return bytes;
}

void write_format(const Hdf5Group& root, const std::string& format, int version) {
  root.set("format", format);
  root.set("version", std::int32_t{version});
}

namespace {

/// Returns a clause about the use of a file of a known format, "" for another.
std::string advice_for(const std::string& format) {
  if (format == "morphe-plans")
    return ": it is a plans.h5, the result of a run; give the recording or its demonstrations.h5";
  if (format == "morphe-demonstrations")
    return ": it has recordings, already imported; give the plans.h5 of a run";
  return "";
}

}  // namespace

void check_format(const Hdf5Group& root, const std::string& format, int version) {
  if (!root.has_attribute("format")) root.fail("@format is missing; must be " + format);
  std::string found;
  root.get("format", found);
  if (found != format)
    root.fail(fmt::format("is '{}', not '{}'{}", found, format, advice_for(found)));
  std::int32_t stored = 0;
  root.get("version", stored);
  if (stored != version)
    root.fail(fmt::format("@version is {}; this program reads only version {}", stored, version));
}

}  // namespace morphe::store
