#pragma once

#include <string>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::study {

/// A variant of a pipeline config, given by settings "a.b=value".
struct StudyVariant {
  std::string name;
  std::vector<std::string> set;
};
/// Maps the keys of the config to the fields.
template <class Fields>
void fields(Fields& f, StudyVariant& o) {
  f.required("name", o.name);
  f("set", o.set);
}

}  // namespace morphe::study
