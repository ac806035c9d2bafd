#include "mutate.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "core/math/random_stream.hpp"

namespace morphe::fuzz {
namespace {

constexpr std::size_t kMostBytes = 65536, kLongestPart = 64;

constexpr std::array<std::string_view, 20> kNumbers = {
    "0",    "-0",  "1",          "-1",    "1e-300", "1e300",     "1e12",
    "-1e9", "nan", "inf",        "-.inf", "1e999",  "65535",     "1.5",
    "1e-9", "256", "4294967296", "",      "0x10",   "2147483648"};

class Mutation {
 public:
  Mutation(const std::vector<std::string>& seeds, const std::vector<std::string>& words,
           const std::string& target, std::uint64_t number)
      : seeds_(seeds), words_(words), random_(number, target), bytes_(seeds[below(seeds.size())]) {}

  std::string run() {
    for (std::size_t left = 1 + below(16) * below(2); left > 0; --left) change();
    if (bytes_.size() > kMostBytes) bytes_.resize(kMostBytes);
    return std::move(bytes_);
  }

 private:
  /// 0 of none.
  std::size_t below(std::size_t count) {
    return std::min(static_cast<std::size_t>(random_.uniform() * static_cast<double>(count)),
                    count > 0 ? count - 1 : 0);
  }
  /// Where a part begins, and how long it is.
  std::pair<std::size_t, std::size_t> part(const std::string& of) {
    const std::size_t from = below(of.size());
    return {from, 1 + below(std::min(kLongestPart, of.size() - from))};
  }

  void change() {
    const std::size_t kind = below(9);
    if (bytes_.empty() || kind == 0)
      return put(words_.empty() ? "0" : words_[below(words_.size())]);
    const auto [from, length] = part(bytes_);
    switch (kind) {
      case 1:
        bytes_[from] = static_cast<char>(bytes_[from] ^ (1 << below(8)));
        break;
      case 2:
        bytes_[from] = static_cast<char>(below(256));
        break;
      case 3:
        bytes_.erase(from, length);
        break;
      case 4:
        bytes_.insert(from, bytes_.substr(from, length));
        break;
      case 5:
        put(bytes_.substr(from, length));
        break;
      case 6: {
        const std::string& other = seeds_[below(seeds_.size())];
        if (other.empty()) break;
        const auto [begin, size] = part(other);
        put(other.substr(begin, size));
        break;
      }
      case 7:
        if (below(8) == 0) bytes_.resize(from);
        break;
      default:
        replace_number(from);
    }
  }

  void put(std::string_view text) { bytes_.insert(below(bytes_.size() + 1), text); }

  /// The first from a place on.
  void replace_number(std::size_t from) {
    constexpr std::string_view kDigits = "0123456789";
    const std::size_t begin = bytes_.find_first_of(kDigits, from);
    if (begin == std::string::npos) return;
    const std::size_t end = bytes_.find_first_not_of("0123456789.eE+-", begin);
    bytes_.replace(begin, end == std::string::npos ? end : end - begin,
                   kNumbers[below(kNumbers.size())]);
  }

  const std::vector<std::string>& seeds_;
  const std::vector<std::string>& words_;
  math::RandomStream random_;
  std::string bytes_;
};

}  // namespace

std::string mutant(const std::vector<std::string>& seeds, const std::vector<std::string>& words,
                   const std::string& target, std::uint64_t number) {
  return Mutation(seeds, words, target, number).run();
}

std::vector<std::string> words_of(const std::string& dictionary) {
  std::vector<std::string> words;
  std::istringstream lines(dictionary);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < 2 || line.front() != '"' || line.back() != '"') continue;
    std::string word;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (line[i] != '\\') {
        word += line[i];
      } else if (line[i + 1] == 'x') {
        word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
        i += 3;
      } else {
        word += line[++i];
      }
    }
    words.push_back(word);
  }
  return words;
}

}  // namespace morphe::fuzz
