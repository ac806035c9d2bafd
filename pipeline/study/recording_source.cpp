#include "pipeline/study/recording_source.hpp"

#include "pipeline/synthesize/synthesize.hpp"
#include "stages/import/import.hpp"

namespace morphe::study {
namespace {

std::vector<Demonstration> import_source(const std::filesystem::path& path, int count) {
  std::vector<Demonstration> all;
  imports::ImportRequest request;
  request.paths = {path};
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    if (std::ssize(all) < count) all.push_back(std::move(demonstration));
  });
  return all;
}

std::vector<Demonstration> synthesize_source(const std::filesystem::path& config,
                                             std::uint64_t seed, int count) {
  std::vector<Demonstration> all;
  synthesize::SynthesizeOptions options;
  const config::ConfigNode node = config::ConfigNode::load(config);
  config::read_document(node, options);
  for (int i = 0; i < count; ++i) all.push_back(synthesize::synthesize(options, seed, i).recorded);
  return all;
}

}  // namespace

std::string validation_error(const RecordingSource& o) {
  if (o.manifest.empty() == o.synthetic.empty()) return "needs `manifest` or `synthetic`";
  return "";
}

std::vector<Demonstration> load_recordings(const RecordingSource& source, const StudyRun& run) {
  const std::filesystem::path folder = run.config.parent_path();
  const int count = run.quick ? source.quick_count : source.count;
  return source.synthetic.empty()
             ? import_source(folder / source.manifest, count)
             : synthesize_source(folder / source.synthetic, source.seed, count);
}

}  // namespace morphe::study
