#include "pipeline/run/plans_fingerprint.hpp"

#include <algorithm>

#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/store/bytes.hpp"
#include "core/store/plan_file.hpp"

namespace morphe::run {

std::string plans_fingerprint(const PlanFileHeader& header) {
  PlanFileHeader sorted = header;  // a file stores its inputs as a tree of groups
  std::ranges::sort(sorted.inputs, {}, &PlanFileHeader::Input::path);
  return files::sha256(store::bytes_of(sorted));
}

std::string plans_fingerprint(const std::filesystem::path& plans) {
  try {
    return plans_fingerprint(store::PlanReader(plans).header());
  } catch (const InputError&) {
    return "";
  }
}

}  // namespace morphe::run
