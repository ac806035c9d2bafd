#pragma once

#include <string>
#include <vector>

#include "core/config/fields.hpp"

namespace morphe::study {

/// A pipeline config with settings "a.b=value".
struct StudyVariant {
  std::string name;
  std::vector<std::string> set;
};
template <class Fields>
void fields(Fields& f, StudyVariant& o) {
  f.required("name", o.name);
  f("set", o.set);
}

}  // namespace morphe::study
