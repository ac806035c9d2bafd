#pragma once

#include <string_view>

namespace morphe::files {

/// The error of a name for which is_item_name() is false.
inline constexpr const char* kItemNameError =
    "must not be empty or contain '/' or control characters";

/// Returns true if a name can be that of an item in Morphe's files: of an object, for example,
/// whose name becomes an HDF5 link and is printed.
bool is_item_name(std::string_view name);

}  // namespace morphe::files
