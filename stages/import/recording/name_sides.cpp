#include "stages/import/recording/name_sides.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

using AllNames = std::set<std::string_view>;

/// A letter of a side, the letter of the opposite side, and the letter beside which it means a side
/// of a joint instead.
struct SideLetter {
  char letter, opposite, joint_partner;
  Side body;
  PointSide joint, partner;
};
constexpr SideLetter kLetters[] = {
    {'l', 'r', 'm', Side::left, PointSide::lateral, PointSide::medial},
    {'r', 'l', 'u', Side::right, PointSide::radial, PointSide::ulnar}};

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Returns true if all names contain this one with another letter, of the same case, at the index.
bool exists_with(const std::string& name, std::size_t index, char letter, const AllNames& all) {
  std::string other = name;
  const bool capital = std::isupper(static_cast<unsigned char>(name[index])) != 0;
  other[index] =
      capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
  return all.contains(other);
}

/// Returns the side of a joint that the letter at an index means.
PointSide joint_side_at(const std::string& name, std::size_t index, const AllNames& all) {
  for (const SideLetter& side : kLetters) {
    const char c = lower(name[index]);
    if (c == side.letter && exists_with(name, index, side.joint_partner, all) &&
        !exists_with(name, index, side.opposite, all)) {
      return side.joint;
    }
    if (c == side.joint_partner && exists_with(name, index, side.letter, all) &&
        !exists_with(name, index, side.opposite, all)) {
      return side.partner;
    }
  }
  return PointSide::unstated;
}

std::optional<Side> side_of_letter(char letter) {
  for (const SideLetter& side : kLetters) {
    if (lower(letter) == side.letter) return side.body;
  }
  return std::nullopt;
}

std::optional<Side> side_of_word(const std::string& word) {
  if (word.size() == 1) return side_of_letter(word[0]);
  for (const Side side : {Side::left, Side::right}) {
    const bool found = std::ranges::any_of(side_words(side), [&](std::string_view known) {
      return word == known || (static_cast<unsigned char>(known[0]) >= 0x80 &&
                               word.starts_with(known));  // 左肩 is one word
    });
    if (found) return side;
  }
  return std::nullopt;
}

/// Returns the side of the letter at an index of a name if one of all names has the opposite letter
/// there, or if it begins a name in capitals of at least three letters.
std::optional<Side> side_of_letter_at(const std::string& name, std::size_t index, bool first,
                                      const AllNames& all) {
  for (const SideLetter& side : kLetters) {
    if (lower(name[index]) != side.letter) continue;
    const bool capitals = first && name.size() - index > 2 &&
                          std::none_of(name.begin() + index, name.end(), [](char c) {
                            return std::islower(static_cast<unsigned char>(c)) != 0;
                          });
    if (capitals || exists_with(name, index, side.opposite, all)) return side.body;
  }
  return std::nullopt;
}

NameSide side_of_name(const std::string& name, const AllNames& all) {
  const std::size_t begin = name.rfind(':') + 1;  // npos + 1 is 0
  const std::string_view own = std::string_view(name).substr(begin);
  NameSide side;
  if (own.empty()) return side;
  const std::size_t last = name.size() - 1;
  const PointSide at_end = joint_side_at(name, last, all),
                  at_begin = joint_side_at(name, begin, all);
  const bool last_taken = at_end != PointSide::unstated;
  const bool first_taken = at_begin != PointSide::unstated;
  side.joint = last_taken ? at_end : at_begin;
  for (const NameWord& word : split_name(own)) {
    const bool letter = word.text.size() == 1;
    if (letter && ((last_taken && word.end == own.size()) || (first_taken && word.end == 1)))
      continue;
    if ((side.body = side_of_word(word.text))) return side;
  }
  if (!first_taken) side.body = side_of_letter_at(name, begin, true, all);
  if (!side.body && !last_taken) side.body = side_of_letter_at(name, last, false, all);
  return side;
}

}  // namespace

std::vector<NameSide> sides_of_names(const std::vector<std::string>& names) {
  const AllNames all(names.begin(), names.end());
  std::vector<NameSide> sides;
  for (const std::string& name : names) sides.push_back(side_of_name(name, all));
  return sides;
}

const std::vector<std::string_view>& side_words(Side side) {
  static const std::vector<std::string_view> kLeft = {
      "left",   "lt",        "lft",       "links",    "linke",    "linker",
      "gauche", "izquierda", "izquierdo", "sinistra", "sinistro", "左"};
  static const std::vector<std::string_view> kRight = {
      "right",  "rt",      "rgt",     "rechts", "rechte", "rechter", "droit",
      "droite", "derecha", "derecho", "destra", "destro", "右"};
  return side == Side::left ? kLeft : kRight;
}

}  // namespace morphe::imports
