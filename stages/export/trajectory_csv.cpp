#include "stages/export/trajectory_csv.hpp"

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "stages/export/table/csv_cell.hpp"

namespace morphe::exports {

std::string trajectory_csv(const JointGroup& group, const Trajectory& t) {
  std::string text = "time_s,demonstration_time_s,phase";
  for (const auto& [quantity, per] :
       {std::pair{"position", ""}, std::pair{"velocity", "_s"}, std::pair{"acceleration", "_s2"}}) {
    for (int j = 0; j < std::ssize(group.names); ++j) {
      text +=
          "," + csv_cell(fmt::format("{}_{}_{}{}", group.names[j], quantity, group.units[j], per));
    }
  }
  text += "\n";
  for (int i = 0; i < std::ssize(t.time); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{}", t.time[i], t.demonstration_time[i],
                   name_of(t.phase[i]));
    for (const JointRows* rows : {&t.position, &t.velocity, &t.acceleration}) {
      for (const double value : rows->row(i))
        fmt::format_to(std::back_inserter(text), ",{}", value);
    }
    text += "\n";
  }
  return text;
}

}  // namespace morphe::exports
