#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

namespace morphe::setup {

/// A link of a small robot: a box of `size` at `centre` of its frame, on a joint about `axis` at
/// `origin` of the link before. [m, rad]
struct BoxLink {
  std::string name, origin, axis;
  double lower, upper;
  std::string centre, size;  ///< "" for no shape
};

/// Returns the URDF of a chain of boxes on a base of a box.
inline std::string chain_of_boxes(const std::string& base_size, const std::vector<BoxLink>& links) {
  const auto shape = [](const std::string& centre, const std::string& size) {
    return size.empty() ? std::string()
                        : fmt::format(
                              "<collision><origin xyz=\"{}\"/><geometry><box size=\"{}\"/>"
                              "</geometry></collision>",
                              centre, size);
  };
  std::string text =
      fmt::format("<robot name=\"boxes\"><link name=\"base\">{}</link>", shape("0 0 0", base_size));
  std::string before = "base";
  for (const BoxLink& link : links) {
    text += fmt::format(
        "<link name=\"{0}\">{1}</link><joint name=\"j_{0}\" type=\"revolute\"><parent "
        "link=\"{2}\"/><child link=\"{0}\"/><origin xyz=\"{3}\"/><axis xyz=\"{4}\"/><limit "
        "lower=\"{5}\" upper=\"{6}\" velocity=\"2\" effort=\"1\"/></joint>",
        link.name, shape(link.centre, link.size), before, link.origin, link.axis, link.lower,
        link.upper);
    before = link.name;
  }
  return text + "</robot>";
}

}  // namespace morphe::setup
