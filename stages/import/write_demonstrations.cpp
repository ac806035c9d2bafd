#include "pipeline/store/demonstration_file.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {

Imported write_demonstrations(const ImportRequest& request, const std::filesystem::path& out,
                              const std::function<void(const Demonstration&)>& seen) {
  store::DemonstrationWriter writer(out);
  Imported imported = import_recordings(request, [&](Demonstration&& demonstration) {
    writer.add(demonstration);
    if (seen) seen(demonstration);
  });
  writer.finish();
  return imported;
}

}  // namespace morphe::imports
