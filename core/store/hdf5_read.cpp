#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>

#include "core/store/hdf5_file.hpp"
#include "core/store/hdf5_types.hpp"

namespace morphe::store {
namespace {

// A dataset may not have more bytes than this multiple of its stored ones: deflate's limit is 1032.
constexpr double kMaxCompressionRatio = 1100;

/// Returns true if elements of an HDF5 class can be read as the type of the first argument.
bool fits(double, H5T_class_t kind) { return kind == H5T_FLOAT || kind == H5T_INTEGER; }
bool fits(std::int32_t, H5T_class_t kind) { return kind == H5T_INTEGER; }
bool fits(std::uint8_t, H5T_class_t kind) { return kind == H5T_INTEGER; }
std::string kind_name(double) { return "numbers"; }
std::string kind_name(std::int32_t) { return "integers"; }
std::string kind_name(std::uint8_t) { return "integers"; }
const char* attribute_kind(double) { return "a single number"; }
const char* attribute_kind(std::int32_t) { return "a single integer"; }
const char* attribute_kind(std::uint8_t) { return "a single integer"; }
const char* attribute_kind(const std::string&) { return "text"; }
const char* attribute_kind(const std::vector<double>&) { return "numbers"; }
const char* attribute_kind(const std::vector<std::string>&) { return "texts"; }

/// Returns the name of an HDF5 type: "float64", "int32", "uint8", "text", or "other" for compounds
/// and the like.
std::string type_name(hid_t type) {
  const std::size_t bits = 8 * H5Tget_size(type);
  switch (H5Tget_class(type)) {
    case H5T_STRING:
      return "text";
    case H5T_FLOAT:
      return fmt::format("float{}", bits);
    case H5T_INTEGER:
      return fmt::format("{}int{}", H5Tget_sign(type) == H5T_SGN_NONE ? "u" : "", bits);
    default:
      return "other";
  }
}

struct Extent {
  Hdf5Shape dims;
  double count = 1;  ///< number of elements; a double cannot overflow
  /// Returns the count, once it is known to be in bounds.
  std::size_t size() const { return static_cast<std::size_t>(count); }
};

Extent extent_of(hid_t space) {
  Extent extent;
  if (H5Sget_simple_extent_type(space) == H5S_NULL) return {{0}, 0};
  const int rank = std::max(0, H5Sget_simple_extent_ndims(space));
  std::vector<hsize_t> sizes(rank);
  if (rank > 0) H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  extent.dims.assign(sizes.begin(), sizes.end());
  for (const std::size_t size : extent.dims) extent.count *= static_cast<double>(size);
  return extent;
}

struct OpenDataset {
  Hdf5Id id, type;
  Extent extent;
};

/// Opens a dataset; fails with the reason if its elements cannot be read.
OpenDataset open_dataset(const Hdf5Group& group, hid_t group_id, const std::string& name,
                         std::size_t file_bytes) {
  OpenDataset data;
  if (is_external_link(group_id, name)) group.fail(name, "is a link into another file");
  if (!group.has(name)) group.fail(name, "is missing");
  data.id = {H5Dopen2(group_id, name.c_str(), H5P_DEFAULT), H5Dclose};
  const Hdf5Id space(data.id.valid() ? H5Dget_space(data.id.get()) : H5I_INVALID_HID, H5Sclose);
  const Hdf5Id layout(data.id.valid() ? H5Dget_create_plist(data.id.get()) : H5I_INVALID_HID,
                      H5Pclose);
  if (!space.valid() || !layout.valid()) group.fail(name, "is not a readable dataset");
  data.type = {H5Dget_type(data.id.get()), H5Tclose};
  data.extent = extent_of(space.get());
  if (H5Pget_layout(layout.get()) == H5D_VIRTUAL || H5Pget_external_count(layout.get()) != 0)
    group.fail(name, "stores its values in another file");
  const double packed = static_cast<double>(H5Dget_storage_size(data.id.get()));
  const double unpacked = data.extent.count * static_cast<double>(H5Tget_size(data.type.get()));
  if (packed > static_cast<double>(file_bytes) || unpacked > packed * kMaxCompressionRatio)
    group.fail(name, "has more values than the file can contain");
  return data;
}

std::string shape_text(const Hdf5Shape& shape) {
  std::vector<std::string> parts;
  for (const auto size : shape) parts.push_back(size == kAnyLength ? "*" : std::to_string(size));
  return fmt::format("[{}]", fmt::join(parts, ","));
}

/// Reads strings of fixed or variable length with `read(type, buffer)`; returns false on failure.
template <class Read>
bool strings_of(hid_t in_file, hid_t space, std::size_t count, const Read& read,
                std::vector<std::string>& out) {
  out.assign(count, "");
  if (count == 0) return true;
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_cset(type.get(),
              H5Tget_cset(in_file));  // HDF5 does not convert between character sets
  if (H5Tis_variable_str(in_file) > 0) {
    H5Tset_size(type.get(), H5T_VARIABLE);
    std::vector<char*> pointers(count, nullptr);
    const bool succeeded = read(type.get(), static_cast<void*>(pointers.data()));
    for (std::size_t i = 0; succeeded && i < count; ++i)
      if (pointers[i]) out[i] = pointers[i];
    H5Dvlen_reclaim(type.get(), space, H5P_DEFAULT, pointers.data());
    return succeeded;
  }
  const std::size_t length = H5Tget_size(in_file);
  H5Tset_size(type.get(), length);
  H5Tset_strpad(type.get(), H5Tget_strpad(in_file));
  std::vector<char> buffer(count * length);
  if (!read(type.get(), static_cast<void*>(buffer.data()))) return false;
  const char padding = H5Tget_strpad(in_file) == H5T_STR_SPACEPAD ? ' ' : '\0';
  for (std::size_t i = 0; i < count; ++i) {
    const char* begin = buffer.data() + i * length;
    std::size_t size = length;
    if (H5Tget_strpad(in_file) == H5T_STR_NULLTERM) size = strnlen(begin, length);
    while (size > 0 && begin[size - 1] == padding) --size;
    out[i].assign(begin, size);
  }
  return true;
}

struct Attribute {
  Hdf5Id id, type, space;
  Extent extent;
};

/// Opens an attribute; the id is invalid if the attribute is missing or larger than the file.
Attribute open_attribute(hid_t group, const char* object, const std::string& name,
                         std::size_t file_bytes) {
  Attribute found;
  if (H5Aexists_by_name(group, object, name.c_str(), H5P_DEFAULT) <= 0) return found;
  found.id = {H5Aopen_by_name(group, object, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
  if (!found.id.valid()) return found;
  found.type = {H5Aget_type(found.id.get()), H5Tclose};
  found.space = {H5Aget_space(found.id.get()), H5Sclose};
  found.extent = extent_of(found.space.get());
  const double bytes = found.extent.count * static_cast<double>(H5Tget_size(found.type.get()));
  if (bytes > static_cast<double>(file_bytes)) found.id.reset();
  return found;
}

template <class T>
bool attribute_values(const Attribute& found, std::vector<T>& values) {
  if (!found.id.valid() || !fits(T{}, H5Tget_class(found.type.get()))) return false;
  values.assign(found.extent.size(), T{});
  return values.empty() || H5Aread(found.id.get(), memory_type(T{}), values.data()) >= 0;
}

bool attribute_values(const Attribute& found, std::vector<std::string>& values) {
  if (!found.id.valid() || H5Tget_class(found.type.get()) != H5T_STRING) return false;
  const auto read = [&](hid_t type, void* out) { return H5Aread(found.id.get(), type, out) >= 0; };
  return strings_of(found.type.get(), found.space.get(), found.extent.size(), read, values);
}

template <class T>
bool attribute_values(const Attribute& found, T& value) {
  std::vector<T> values;
  if (!attribute_values(found, values) || values.size() != 1) return false;
  value = std::move(values.front());
  return true;
}

}  // namespace

bool has_shape(const Hdf5Shape& dims, const Hdf5Shape& required) {
  return std::ranges::equal(dims, required, [](std::size_t size, std::size_t required_size) {
    return required_size == kAnyLength || required_size == size;
  });
}

template <class T>
Hdf5Array<T> Hdf5Group::read(const std::string& name, const Hdf5Shape& shape) const {
  const OpenDataset data = open_dataset(*this, id_.get(), name, file_bytes());
  if (!fits(T{}, H5Tget_class(data.type.get()))) fail(name, "must contain " + kind_name(T{}));
  if (!has_shape(data.extent.dims, shape))
    fail(name,
         fmt::format("has shape {}, must be {}", shape_text(data.extent.dims), shape_text(shape)));
  Hdf5Array<T> array;
  array.dims = data.extent.dims;
  array.values.resize(data.extent.size());
  if (!array.values.empty() && H5Dread(data.id.get(), memory_type(T{}), H5S_ALL, H5S_ALL,
                                       H5P_DEFAULT, array.values.data()) < 0)
    fail(name, "is damaged, or memory is short: its values cannot be read");
  return array;
}

template Hdf5Array<double> Hdf5Group::read(const std::string&, const Hdf5Shape&) const;
template Hdf5Array<std::int32_t> Hdf5Group::read(const std::string&, const Hdf5Shape&) const;
template Hdf5Array<std::uint8_t> Hdf5Group::read(const std::string&, const Hdf5Shape&) const;

std::size_t Hdf5Group::length(const std::string& name) const {
  const OpenDataset data = open_dataset(*this, id_.get(), name, file_bytes());
  return data.extent.dims.empty() ? 1 : data.extent.dims.front();
}

std::vector<std::string> Hdf5Group::read_strings(const std::string& name) const {
  const OpenDataset data = open_dataset(*this, id_.get(), name, file_bytes());
  if (H5Tget_class(data.type.get()) != H5T_STRING) fail(name, "must contain strings");
  if (data.extent.dims.size() > 1)
    fail(name, fmt::format("has shape {}, must be [*]", shape_text(data.extent.dims)));
  const Hdf5Id space(H5Dget_space(data.id.get()), H5Sclose);
  const auto read = [&](hid_t type, void* out) {
    return H5Dread(data.id.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out) >= 0;
  };
  std::vector<std::string> values;
  if (!strings_of(data.type.get(), space.get(), data.extent.size(), read, values))
    fail(name, "is damaged, or memory is short: its values cannot be read");
  return values;
}

std::string Hdf5Group::read_text(const std::string& name) const {
  const std::vector<std::string> values = read_strings(name);
  if (values.size() != 1) fail(name, "must contain one text");
  return values.front();
}

std::string Hdf5Group::type_of(const std::string& name) const {
  return type_name(open_dataset(*this, id_.get(), name, file_bytes()).type.get());
}

std::string Hdf5Group::type_of_attribute(const std::string& name) const {
  const Attribute found = open_attribute(id_.get(), ".", name, file_bytes());
  if (!found.id.valid()) fail("@" + name, "cannot be read");
  return type_name(found.type.get());
}

Hdf5Value Hdf5Group::value(const std::string& name) const {
  const OpenDataset data = open_dataset(*this, id_.get(), name, file_bytes());
  Hdf5Value value;
  value.dims = data.extent.dims;
  value.is_text = H5Tget_class(data.type.get()) == H5T_STRING;
  if (value.is_text) {
    value.texts = read_strings(name);
  } else {
    value.numbers = read<double>(name, value.dims).values;
  }
  return value;
}

std::vector<std::string> Hdf5Group::attributes(const char* dataset) const {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  if (H5Aiterate_by_name(id_.get(), dataset, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names,
                         H5P_DEFAULT) < 0)
    fail(dataset, "has no readable attributes");
  std::ranges::sort(names);
  return names;
}

Hdf5Value Hdf5Group::value_of_attribute(const std::string& name, const char* dataset) const {
  const Attribute found = open_attribute(id_.get(), dataset, name, file_bytes());
  Hdf5Value value;
  value.dims = found.extent.dims;
  value.is_text = found.id.valid() && H5Tget_class(found.type.get()) == H5T_STRING;
  if (value.is_text ? !attribute_values(found, value.texts)
                    : !attribute_values(found, value.numbers))
    fail("@" + name, "cannot be read");
  return value;
}

bool Hdf5Group::has_attribute(const std::string& name) const {
  return H5Aexists_by_name(id_.get(), ".", name.c_str(), H5P_DEFAULT) > 0;
}

template <class T>
void Hdf5Group::get(const std::string& name, T& value, const char* dataset) const {
  if (!attribute_values(open_attribute(id_.get(), dataset, name, file_bytes()), value))
    fail("@" + name, fmt::format("is missing or not {}", attribute_kind(value)));
}

template void Hdf5Group::get(const std::string&, double&, const char*) const;
template void Hdf5Group::get(const std::string&, std::int32_t&, const char*) const;
template void Hdf5Group::get(const std::string&, std::uint8_t&, const char*) const;
template void Hdf5Group::get(const std::string&, std::string&, const char*) const;
template void Hdf5Group::get(const std::string&, std::vector<double>&, const char*) const;
template void Hdf5Group::get(const std::string&, std::vector<std::string>&, const char*) const;

}  // namespace morphe::store
