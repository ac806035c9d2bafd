#include "pipeline/run/plans_print.hpp"

#include <algorithm>

#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"
#include "core/store/plan_file.hpp"

namespace morphe::run {

std::string plans_print(const PlanFileHeader& header) {
  PlanFileHeader sorted = header;  // a file keeps its inputs as a tree of folders
  std::ranges::sort(sorted.inputs, {}, &PlanFileHeader::Input::path);
  return files::sha256(store::bytes_of(sorted));
}

std::string plans_print(const std::filesystem::path& plans) {
  try {
    return plans_print(store::PlanReader(plans).header());
  } catch (const InputError&) {
    return "";
  }
}

}  // namespace morphe::run
