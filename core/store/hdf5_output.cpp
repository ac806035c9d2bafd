#include "core/store/hdf5_output.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

// HDF5 1.14 moved drivers out of hdf5.h, and gave them a version and a number.
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

namespace morphe::store {
namespace {

constexpr const char* kDriverName = "morphe-output";
constexpr haddr_t kMaxFileBytes = (haddr_t{1} << 62) - 1;

/// The file type of the driver; the part that HDF5 knows must come first.
struct Output {
  H5FD_t hdf5_part;
  int descriptor;
  int error;
  files::Disk* disk;
  int* closing_error;  ///< receives the error in close_file(), or null
  haddr_t end_of_address, end_of_file;
};

Output* output(H5FD_t* file) { return reinterpret_cast<Output*>(file); }
const Output* output(const H5FD_t* file) { return reinterpret_cast<const Output*>(file); }

/// The driver's part of the access properties.
struct Access {
  files::Disk* disk;
};

H5FD_t* open_file(const char* name, unsigned flags, hid_t properties, haddr_t) {
  const auto* const access = static_cast<const Access*>(H5Pget_driver_info(properties));
  if (!(flags & H5F_ACC_CREAT) || !access) return nullptr;
  const int descriptor = ::open(name, O_RDWR | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor < 0) return nullptr;
  auto* const file = new (std::nothrow) Output{{}, descriptor, 0, access->disk, nullptr, 0, 0};
  if (!file) ::close(descriptor);
  return file ? &file->hdf5_part : nullptr;
}

/// Closes the file and reports its first error, which may be that of closing itself.
herr_t close_file(H5FD_t* file) {
  Output& out = *output(file);
  if (::close(out.descriptor) != 0 && out.error == 0) out.error = errno;
  if (out.closing_error) *out.closing_error = out.error;
  delete &out;
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  return output(a)->descriptor - output(b)->descriptor;
}

herr_t query(const H5FD_t*, unsigned long* features) {
  *features = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
              H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_POSIX_COMPAT_HANDLE |
              H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t get_end_of_address(const H5FD_t* file, H5FD_mem_t) { return output(file)->end_of_address; }
herr_t set_end_of_address(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  output(file)->end_of_address = address;
  return 0;
}
haddr_t get_end_of_file(const H5FD_t* file, H5FD_mem_t) { return output(file)->end_of_file; }

herr_t get_handle(H5FD_t* file, hid_t, void** handle) {
  *handle = &output(file)->descriptor;
  return 0;
}

/// Reads bytes; parts that were never written, or did not reach the disk, read as zeros.
herr_t read_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t count, void* buffer) {
  auto* to = static_cast<char*>(buffer);
  while (count > 0) {
    const ssize_t read = ::pread(output(file)->descriptor, to, count, static_cast<off_t>(address));
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) break;
    to += read;
    address += static_cast<haddr_t>(read);
    count -= read;
  }
  std::memset(to, 0, count);
  return 0;
}

herr_t write_bytes(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t count,
                   const void* buffer) {
  Output& out = *output(file);
  const auto* from = static_cast<const char*>(buffer);
  out.end_of_file = std::max(out.end_of_file, address + count);
  while (count > 0 && out.error == 0) {
    const std::int64_t written =
        out.disk->write(out.descriptor, from, count, static_cast<std::int64_t>(address));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      out.error = errno;
      break;
    }
    from += written;
    address += static_cast<haddr_t>(written);
    count -= written;
  }
  return 0;
}

herr_t truncate_file(H5FD_t* file, hid_t, hbool_t) {
  Output& out = *output(file);
  if (out.end_of_address == out.end_of_file) return 0;
  if (out.error == 0 &&
      out.disk->truncate(out.descriptor, static_cast<std::int64_t>(out.end_of_address)) != 0)
    out.error = errno;
  out.end_of_file = out.end_of_address;
  return 0;
}

const H5FD_class_t& driver_class() {
  static const H5FD_class_t driver = [] {
    H5FD_class_t d{};
#ifdef H5FD_CLASS_VERSION
    d.version = H5FD_CLASS_VERSION;
    d.value = H5_VFD_RESERVED;
#endif
    d.name = kDriverName;
    d.maxaddr = kMaxFileBytes;
    d.fc_degree = H5F_CLOSE_WEAK;
    d.fapl_size = sizeof(Access);
    d.open = open_file;
    d.close = close_file;
    d.cmp = compare;
    d.query = query;
    d.get_eoa = get_end_of_address;
    d.set_eoa = set_end_of_address;
    d.get_eof = get_end_of_file;
    d.get_handle = get_handle;
    d.read = read_bytes;
    d.write = write_bytes;
    d.truncate = truncate_file;
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), d.fl_map);
    return d;
  }();
  return driver;
}

/// Returns the driver's file. HDF5 only gives the handle: a pointer to the member `descriptor`.
Output* output_of(hid_t file) {
  void* handle = nullptr;
  if (H5Fget_vfd_handle(file, H5P_DEFAULT, &handle) < 0) return nullptr;
  return reinterpret_cast<Output*>(static_cast<char*>(handle) - offsetof(Output, descriptor));
}

}  // namespace

void write_through_output_driver(std::int64_t access, files::Disk& disk) {
  static const hid_t driver = H5FDregister(&driver_class());
  const Access driver_info{&disk};
  H5Pset_driver(access, driver, &driver_info);
}

int hdf5_output_error(std::int64_t file) {
  const Output* const out = output_of(file);
  return out ? out->error : EIO;
}

void report_hdf5_output_error(std::int64_t file, int& error) {
  if (Output* const out = output_of(file)) out->closing_error = &error;
}

}  // namespace morphe::store
