#include "core/files/item_name.hpp"

#include "core/files/printable.hpp"

namespace morphe::files {

bool is_item_name(std::string_view name) {
  return !name.empty() && name != "." && name.find('/') == std::string_view::npos &&
         is_printable(name);
}

}  // namespace morphe::files
