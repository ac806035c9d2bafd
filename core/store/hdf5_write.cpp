#include <hdf5.h>

#include <algorithm>
#include <utility>

#include "core/store/hdf5_file.hpp"
#include "core/store/hdf5_types.hpp"

namespace morphe::store {
namespace {

constexpr std::size_t kMaxChunkBytes = std::size_t{16} << 20;

hid_t file_type(double) { return H5T_IEEE_F64LE; }
hid_t file_type(std::int32_t) { return H5T_STD_I32LE; }
hid_t file_type(std::uint8_t) { return H5T_STD_U8LE; }

/// Strings as they are written: UTF-8 of one length, padded with zeros. Those of variable length
/// would be in a heap without checksums, in which a flipped bit crashes the library when reading.
struct PaddedStrings {
  Hdf5Id type;
  std::size_t length = 1;
  std::string bytes;
};

PaddedStrings pad_strings(const std::vector<std::string>& values) {
  PaddedStrings strings;
  for (const std::string& value : values) strings.length = std::max(strings.length, value.size());
  for (const std::string& value : values) {
    strings.bytes += value;
    strings.bytes.append(strings.length - value.size(), '\0');
  }
  strings.type = {H5Tcopy(H5T_C_S1), H5Tclose};
  H5Tset_size(strings.type.get(), strings.length);
  H5Tset_cset(strings.type.get(), H5T_CSET_UTF8);
  H5Tset_strpad(strings.type.get(), H5T_STR_NULLPAD);
  return strings;
}

Hdf5Id scalar_space() { return {H5Screate(H5S_SCALAR), H5Sclose}; }

Hdf5Id simple_space(const Hdf5Shape& dims) {
  const std::vector<hsize_t> sizes(dims.begin(), dims.end());
  return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose};
}

/// Returns the properties of a new dataset: chunks with a checksum, of whole rows up to 16 MiB.
Hdf5Id dataset_properties(const Hdf5Shape& dims, std::size_t element_bytes) {
  Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(creation.get(), false);
  std::size_t row_bytes = element_bytes;
  for (std::size_t axis = 1; axis < dims.size(); ++axis) row_bytes *= dims[axis];
  if (dims.empty() || dims[0] == 0 || row_bytes == 0) return creation;
  std::vector<hsize_t> chunk(dims.begin(), dims.end());
  chunk[0] = std::clamp<hsize_t>(kMaxChunkBytes / row_bytes, 1, chunk[0]);
  H5Pset_chunk(creation.get(), static_cast<int>(chunk.size()), chunk.data());
  H5Pset_fletcher32(creation.get());
  return creation;
}

void write_attribute(const Hdf5Group& group, hid_t id, const char* object, const std::string& name,
                     hid_t on_disk, hid_t in_ram, const Hdf5Id& space, const void* values) {
  const Hdf5Id attribute(H5Acreate_by_name(id, object, name.c_str(), on_disk, space.get(),
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  if (!attribute.valid() || (H5Sget_simple_extent_npoints(space.get()) != 0 &&
                             H5Awrite(attribute.get(), in_ram, values) < 0))
    group.fail("@" + name, "cannot be written");
}

void write_dataset(const Hdf5Group& group, hid_t id, const std::string& name, hid_t on_disk,
                   hid_t in_ram, const Hdf5Id& space, const Hdf5Id& creation, const void* values) {
  if (group.has(name)) group.fail(name, "already exists");
  const Hdf5Id data(
      H5Dcreate2(id, name.c_str(), on_disk, space.get(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
      H5Dclose);
  if (!data.valid() || (H5Sget_simple_extent_npoints(space.get()) != 0 &&
                        H5Dwrite(data.get(), in_ram, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0))
    group.fail(name, "cannot be written");
}

}  // namespace

template <class T>
void Hdf5Group::write(const std::string& name, const Hdf5Array<T>& array) const {
  write_dataset(*this, id_.get(), name, file_type(T{}), memory_type(T{}), simple_space(array.dims),
                dataset_properties(array.dims, sizeof(T)), array.values.data());
}

template void Hdf5Group::write(const std::string&, const Hdf5Array<double>&) const;
template void Hdf5Group::write(const std::string&, const Hdf5Array<std::int32_t>&) const;
template void Hdf5Group::write(const std::string&, const Hdf5Array<std::uint8_t>&) const;

void Hdf5Group::write_strings(const std::string& name,
                              const std::vector<std::string>& values) const {
  const PaddedStrings strings = pad_strings(values);
  write_dataset(*this, id_.get(), name, strings.type.get(), strings.type.get(),
                simple_space({values.size()}), dataset_properties({values.size()}, strings.length),
                strings.bytes.data());
}

void Hdf5Group::write_text(const std::string& name, const std::string& text) const {
  const PaddedStrings strings = pad_strings({text});
  write_dataset(*this, id_.get(), name, strings.type.get(), strings.type.get(), scalar_space(),
                dataset_properties({}, strings.length), strings.bytes.data());
}

void Hdf5Group::set(const std::string& name, const std::string& text, const char* dataset) const {
  const PaddedStrings strings = pad_strings({text});
  write_attribute(*this, id_.get(), dataset, name, strings.type.get(), strings.type.get(),
                  scalar_space(), strings.bytes.data());
}

void Hdf5Group::set(const std::string& name, const std::vector<std::string>& values) const {
  const PaddedStrings strings = pad_strings(values);
  write_attribute(*this, id_.get(), ".", name, strings.type.get(), strings.type.get(),
                  simple_space({values.size()}), strings.bytes.data());
}

template <class T>
requires(std::is_arithmetic_v<T>) void Hdf5Group::set(const std::string& name, T value) const {
  write_attribute(*this, id_.get(), ".", name, file_type(value), memory_type(value), scalar_space(),
                  &value);
}

template void Hdf5Group::set(const std::string&, double) const;
template void Hdf5Group::set(const std::string&, std::int32_t) const;
template void Hdf5Group::set(const std::string&, std::uint8_t) const;

void Hdf5Group::set(const std::string& name, const std::vector<double>& values) const {
  write_attribute(*this, id_.get(), ".", name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE,
                  simple_space({values.size()}), values.data());
}

}  // namespace morphe::store
