#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>

#include <algorithm>
#include <cstring>

#include "core/store/hdf5_file.hpp"
#include "core/store/hdf5_types.hpp"

namespace morphe::store {
namespace {

// No supported filter compresses more (deflate's limit is 1032), so a file cannot request more
// memory than this multiple of its size.
constexpr double kMaxCompressionRatio = 1100;

bool fits(double, H5T_class_t kind) { return kind == H5T_FLOAT || kind == H5T_INTEGER; }
bool fits(std::int32_t, H5T_class_t kind) { return kind == H5T_INTEGER; }
bool fits(std::uint8_t, H5T_class_t kind) { return kind == H5T_INTEGER; }
const char* kind_name(double) { return "numbers"; }
const char* kind_name(std::int32_t) { return "integers"; }
const char* kind_name(std::uint8_t) { return "integers"; }

struct Extent {
  std::vector<std::size_t> dims;
  double count = 1;  ///< number of elements; a double cannot overflow
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

/// The properties of a dataset in a file; `problem` is empty if its elements can be read.
struct OpenDataset {
  Hdf5Id id, type;
  Extent extent;
  std::string problem;
};

OpenDataset open_dataset(hid_t group, const std::string& name, std::size_t file_bytes) {
  OpenDataset data;
  if (is_external_link(group, name)) {
    data.problem = "is a link into another file";
    return data;
  }
  if (H5Lexists(group, name.c_str(), H5P_DEFAULT) <= 0) {
    data.problem = "is missing";
    return data;
  }
  data.id = {H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose};
  const Hdf5Id space(data.id.valid() ? H5Dget_space(data.id.get()) : H5I_INVALID_HID, H5Sclose);
  const Hdf5Id layout(data.id.valid() ? H5Dget_create_plist(data.id.get()) : H5I_INVALID_HID,
                      H5Pclose);
  if (!space.valid() || !layout.valid()) {
    data.problem = "is not a readable dataset";
    return data;
  }
  data.type = {H5Dget_type(data.id.get()), H5Tclose};
  data.extent = extent_of(space.get());
  if (H5Pget_layout(layout.get()) == H5D_VIRTUAL || H5Pget_external_count(layout.get()) != 0) {
    data.problem = "stores its values in another file";
    return data;
  }
  const double stored = static_cast<double>(H5Dget_storage_size(data.id.get()));
  const double asked = data.extent.count * static_cast<double>(H5Tget_size(data.type.get()));
  if (stored > static_cast<double>(file_bytes) || asked > stored * kMaxCompressionRatio)
    data.problem = "has more values than the file can contain";
  return data;
}

std::string shape_text(const Hdf5Shape& shape) {
  std::vector<std::string> parts;
  for (const std::size_t size : shape)
    parts.push_back(size == kAnyLength ? "*" : std::to_string(size));
  return fmt::format("[{}]", fmt::join(parts, ","));
}

bool agrees(const Hdf5Shape& dims, const Hdf5Shape& shape) {
  return std::equal(
      dims.begin(), dims.end(), shape.begin(), shape.end(),
      [](std::size_t is, std::size_t asked) { return asked == kAnyLength || asked == is; });
}

/// Reads strings of fixed or variable length with `read(type, buffer)`; returns false on failure.
template <class Read>
bool strings_of(hid_t stored, hid_t space, std::size_t count, const Read& read,
                std::vector<std::string>& out) {
  out.assign(count, "");
  if (count == 0) return true;
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_cset(type.get(), H5Tget_cset(stored));  // HDF5 does not convert between character sets
  if (H5Tis_variable_str(stored) > 0) {
    H5Tset_size(type.get(), H5T_VARIABLE);
    std::vector<char*> pointers(count, nullptr);
    const bool done = read(type.get(), static_cast<void*>(pointers.data()));
    for (std::size_t i = 0; done && i < count; ++i)
      if (pointers[i]) out[i] = pointers[i];
    H5Dvlen_reclaim(type.get(), space, H5P_DEFAULT, pointers.data());
    return done;
  }
  const std::size_t length = H5Tget_size(stored);
  H5Tset_size(type.get(), length);
  H5Tset_strpad(type.get(), H5Tget_strpad(stored));
  std::vector<char> buffer(count * length);
  if (!read(type.get(), static_cast<void*>(buffer.data()))) return false;
  const char padding = H5Tget_strpad(stored) == H5T_STR_SPACEPAD ? ' ' : '\0';
  for (std::size_t i = 0; i < count; ++i) {
    const char* begin = buffer.data() + i * length;
    std::size_t size = length;
    if (H5Tget_strpad(stored) == H5T_STR_NULLTERM) size = strnlen(begin, length);
    while (size > 0 && begin[size - 1] == padding) --size;
    out[i].assign(begin, size);
  }
  return true;
}

struct Attribute {
  Hdf5Id id, type, space;
  Extent extent;
};

/// Returns an invalid id if there is no such attribute, or if it is larger than the file.
Attribute open_attribute(hid_t group, const char* object, const std::string& name,
                         std::size_t file_bytes) {
  Attribute found;
  if (H5Aexists_by_name(group, object, name.c_str(), H5P_DEFAULT) <= 0) return found;
  found.id = {H5Aopen_by_name(group, object, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose};
  if (!found.id.valid()) return found;
  found.type = {H5Aget_type(found.id.get()), H5Tclose};
  found.space = {H5Aget_space(found.id.get()), H5Sclose};
  found.extent = extent_of(found.space.get());
  const double asked = found.extent.count * static_cast<double>(H5Tget_size(found.type.get()));
  if (asked > static_cast<double>(file_bytes)) found.id.reset();
  return found;
}

template <class T>
bool attribute_values(const Attribute& found, std::vector<T>& values) {
  if (!found.id.valid() || !fits(T{}, H5Tget_class(found.type.get()))) return false;
  values.assign(static_cast<std::size_t>(found.extent.count), T{});
  return values.empty() || H5Aread(found.id.get(), memory_type(T{}), values.data()) >= 0;
}

template <class T>
bool attribute_value(const Attribute& found, T& value) {
  std::vector<T> values;
  if (!attribute_values(found, values) || values.size() != 1) return false;
  value = values.front();
  return true;
}

bool attribute_strings(const Attribute& found, std::vector<std::string>& values) {
  if (!found.id.valid() || H5Tget_class(found.type.get()) != H5T_STRING) return false;
  const auto read = [&](hid_t type, void* out) { return H5Aread(found.id.get(), type, out) >= 0; };
  return strings_of(found.type.get(), found.space.get(),
                    static_cast<std::size_t>(found.extent.count), read, values);
}

}  // namespace

template <class T>
Hdf5Array<T> Hdf5Group::read(const std::string& name, const Hdf5Shape& shape) const {
  const OpenDataset data = open_dataset(id_.get(), name, file_bytes());
  if (!data.problem.empty()) fail(name, data.problem);
  if (!fits(T{}, H5Tget_class(data.type.get())))
    fail(name, fmt::format("must contain {}", kind_name(T{})));
  if (!agrees(data.extent.dims, shape))
    fail(name,
         fmt::format("has shape {}, must be {}", shape_text(data.extent.dims), shape_text(shape)));
  Hdf5Array<T> array;
  array.dims = data.extent.dims;
  array.values.resize(static_cast<std::size_t>(data.extent.count));
  if (!array.values.empty() && H5Dread(data.id.get(), memory_type(T{}), H5S_ALL, H5S_ALL,
                                       H5P_DEFAULT, array.values.data()) < 0)
    fail(name, "is damaged: its values cannot be read");
  return array;
}

template Hdf5Array<double> Hdf5Group::read(const std::string&, const Hdf5Shape&) const;
template Hdf5Array<std::int32_t> Hdf5Group::read(const std::string&, const Hdf5Shape&) const;
template Hdf5Array<std::uint8_t> Hdf5Group::read(const std::string&, const Hdf5Shape&) const;

std::size_t Hdf5Group::length(const std::string& name) const {
  const OpenDataset data = open_dataset(id_.get(), name, file_bytes());
  if (!data.problem.empty()) fail(name, data.problem);
  return data.extent.dims.empty() ? 1 : data.extent.dims.front();
}

std::vector<std::string> Hdf5Group::read_strings(const std::string& name) const {
  const OpenDataset data = open_dataset(id_.get(), name, file_bytes());
  if (!data.problem.empty()) fail(name, data.problem);
  if (H5Tget_class(data.type.get()) != H5T_STRING) fail(name, "must contain strings");
  if (data.extent.dims.size() > 1)
    fail(name, fmt::format("has shape {}, must be [*]", shape_text(data.extent.dims)));
  const Hdf5Id space(H5Dget_space(data.id.get()), H5Sclose);
  const auto read = [&](hid_t type, void* out) {
    return H5Dread(data.id.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out) >= 0;
  };
  std::vector<std::string> values;
  if (!strings_of(data.type.get(), space.get(), static_cast<std::size_t>(data.extent.count), read,
                  values))
    fail(name, "is damaged: its values cannot be read");
  return values;
}

std::string Hdf5Group::read_text(const std::string& name) const {
  const std::vector<std::string> values = read_strings(name);
  if (values.size() != 1) fail(name, "must contain one text");
  return values.front();
}

Hdf5Value Hdf5Group::value(const std::string& name) const {
  const OpenDataset data = open_dataset(id_.get(), name, file_bytes());
  if (!data.problem.empty()) fail(name, data.problem);
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
  std::sort(names.begin(), names.end());
  return names;
}

Hdf5Value Hdf5Group::value_of_attribute(const std::string& name, const char* dataset) const {
  const Attribute found = open_attribute(id_.get(), dataset, name, file_bytes());
  Hdf5Value value;
  value.dims = found.extent.dims;
  value.is_text = found.id.valid() && H5Tget_class(found.type.get()) == H5T_STRING;
  if (value.is_text ? !attribute_strings(found, value.texts)
                    : !attribute_values(found, value.numbers))
    fail("@" + name, "cannot be read");
  return value;
}

bool Hdf5Group::has_attribute(const std::string& name) const {
  return H5Aexists_by_name(id_.get(), ".", name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5Group::get(const std::string& name, std::string& text, const char* dataset) const {
  std::vector<std::string> values;
  if (!attribute_strings(open_attribute(id_.get(), dataset, name, file_bytes()), values) ||
      values.size() != 1)
    fail("@" + name, "is missing or not text");
  text = values.front();
}

void Hdf5Group::get(const std::string& name, double& value) const {
  if (!attribute_value(open_attribute(id_.get(), ".", name, file_bytes()), value))
    fail("@" + name, "is missing or not a single number");
}

void Hdf5Group::get(const std::string& name, std::int32_t& value) const {
  if (!attribute_value(open_attribute(id_.get(), ".", name, file_bytes()), value))
    fail("@" + name, "is missing or not a single integer");
}

void Hdf5Group::get(const std::string& name, std::uint8_t& value) const {
  if (!attribute_value(open_attribute(id_.get(), ".", name, file_bytes()), value))
    fail("@" + name, "is missing or not a single integer");
}

void Hdf5Group::get(const std::string& name, std::vector<double>& values) const {
  if (!attribute_values(open_attribute(id_.get(), ".", name, file_bytes()), values))
    fail("@" + name, "is missing or not numbers");
}

void Hdf5Group::get(const std::string& name, std::vector<std::string>& values) const {
  if (!attribute_strings(open_attribute(id_.get(), ".", name, file_bytes()), values))
    fail("@" + name, "is missing or not texts");
}

}  // namespace morphe::store
