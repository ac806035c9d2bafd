// morphe_mutants TARGET SEEDS DICTIONARY FIRST COUNT: gives a target the mutants (mutate.hpp) of
// the files in a folder, from number FIRST on. `list` instead: the targets, and which read in a
// child process. Exit 1: one crashes, throws what is no InputError, works for ten minutes or takes
// more than 2 GB; its number stands on standard error, and SEEDS.found holds the file.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "core/motion/input_error.hpp"
#include "mutate.hpp"
#include "targets.hpp"

namespace morphe::fuzz {
namespace {

constexpr rlim_t kMost_s = 600, kMostMemory = rlim_t{2} << 30;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> seeds_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> seeds;
  for (const auto& file : files) seeds.push_back(bytes_of(file));
  if (seeds.empty()) seeds.emplace_back();
  return seeds;
}

char* sentence = nullptr;  ///< of the mutant that is being read
std::size_t sentence_length = 0;

extern "C" void tell_and_end(int signal) {
  std::signal(signal, SIG_DFL);
  if (::write(STDERR_FILENO, sentence, sentence_length) >= 0) std::raise(signal);
}

/// Of a crash there is no time to say more than what was written before.
void on_crash_tell(std::string& text) {
  sentence = text.data();
  sentence_length = text.size();
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU})
    std::signal(signal, tell_and_end);
}

void limit(decltype(RLIMIT_CPU) what, rlim_t most) {
  const rlimit limits{most, RLIM_INFINITY};
  ::setrlimit(what, &limits);
}

int read_mutants(const Target& target, const std::filesystem::path& folder,
                 const std::string& dictionary, std::uint64_t first, std::uint64_t count) {
  const std::vector<std::string> seeds = seeds_in(folder), words = words_of(bytes_of(dictionary));
  const std::string found = folder.string() + ".found";
  limit(RLIMIT_CPU, kMost_s);
#ifndef __SANITIZE_ADDRESS__
  limit(RLIMIT_DATA, kMostMemory);
#endif
  for (std::uint64_t number = first; number < first + count; ++number) {
    const std::string bytes = mutant(seeds, words, target.name, number);
    std::ofstream(found, std::ios::binary) << bytes;
    std::string text =
        fmt::format("{}: mutant {} ends in a crash: {}\n", target.name, number, found);
    on_crash_tell(text);
    try {
      target.read(bytes);
    } catch (const InputError&) {
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}: mutant {} throws '{}': {}\n", target.name, number, error.what(),
                 found);
      return 1;
    }
  }
  std::filesystem::remove(found);
  return 0;
}

int run(int count, char** arguments) {
  const std::vector<std::string> words(arguments, arguments + count);
  if (count == 2 && words[1] == "list") {
    for (const Target& target : all_targets())
      fmt::print("{}{}\n", target.name, target.in_child ? " child" : "");
    return 0;
  }
  const std::optional<Target> target = count == 6 ? target_named(words[1]) : std::nullopt;
  if (!target) {
    fmt::print(stderr, "morphe_mutants TARGET SEEDS DICTIONARY FIRST COUNT | list\n");
    return 2;
  }
  return read_mutants(*target, words[2], words[3], std::stoull(words[4]), std::stoull(words[5]));
}

}  // namespace
}  // namespace morphe::fuzz

int main(int count, char** arguments) { return morphe::fuzz::run(count, arguments); }
