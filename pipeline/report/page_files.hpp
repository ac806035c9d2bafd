#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphe::report {

/// Returns an embedded file of page/ or of a JavaScript library, such as index.html, data.js and
/// three.min.js. Asserts that there is a file of that name.
std::string_view page_file(std::string_view name);

/// Returns the modules named in modules.txt as one script: they are concatenated inside a function,
/// without import lines and without `export ` in front of declarations.
std::string bundle_page_modules();
/// Bundles the given module texts in the same way, in order.
std::string bundle_modules(const std::vector<std::string_view>& modules);

}  // namespace morphe::report
