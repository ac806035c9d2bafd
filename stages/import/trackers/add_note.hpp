#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace morphe::imports {

/// Formats a sentence with its values and appends it to the notes of an import.
template <class... Values>
void add_note(std::vector<std::string>& notes, fmt::format_string<Values...> sentence,
              Values&&... values) {
  notes.push_back(fmt::format(sentence, std::forward<Values>(values)...));
}

}  // namespace morphe::imports
