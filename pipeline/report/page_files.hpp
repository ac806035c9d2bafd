#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace morphe::report {

/// A file of page/, or a library's, as it was when the program was built: index.html, style.css,
/// data.js, three.min.js … An assertion if there is none of that name.
std::string_view page_file(std::string_view name);

/// The modules named in modules.txt as one script: one after the other, each import line and each
/// `export ` before a declaration left out, in a function of their own.
std::string bundled_modules();
/// The same of modules' texts in order.
std::string bundled(const std::vector<std::string_view>& modules);

}  // namespace morphe::report
