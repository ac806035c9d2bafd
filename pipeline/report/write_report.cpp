#include <fmt/format.h>

#include <cassert>
#include <fstream>
#include <memory>
#include <set>

#include "core/files/atomic_file.hpp"
#include "core/files/base64.hpp"
#include "core/files/sha256.hpp"
#include "core/motion/input_error.hpp"
#include "core/motion/version.hpp"
#include "core/parallel/ordered_parallel_map.hpp"
#include "pipeline/explain/reasons.hpp"
#include "pipeline/report/json_text.hpp"
#include "pipeline/report/opened_run.hpp"
#include "pipeline/report/page_files.hpp"
#include "pipeline/report/plan_block.hpp"
#include "pipeline/report/robot_meshes.hpp"
#include "pipeline/report/row_json.hpp"
#include "pipeline/report/simulation_summary_json.hpp"

namespace morphe::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The page as an output stream. A write error is thrown as InputError by block() or finish().
class PageWriter {
 public:
  explicit PageWriter(const files::AtomicFile& page)
      : file_(page.part()), stream_(page.open_stream()) {
    check();
  }
  void add(std::string_view text) { stream_ << text; }
  void block(const std::string& id, const std::string& text) {
    add(fmt::format("<script type=\"application/octet-stream\" id=\"{}\">{}</script>\n", id, text));
    check();
  }
  void finish() {
    stream_.close();
    check();
  }

 private:
  void check() {
    if (!stream_) throw InputError(fmt::format("{}: cannot be written", file_.string()));
  }
  fs::path file_;
  std::ofstream stream_;
};

std::string block_id(int run, int plan) { return fmt::format("plan-{}-{}", run, plan); }

std::string hash_source(std::string_view text) {
  return fmt::format("'sha256-{}'", files::encode_base64(files::sha256_bytes(text)));
}

/// The contents that replace the comments of the same names in index.html.
struct PageParts {
  std::string style, modules;

  PageParts()
      : style(fmt::format("{}{}", page_file("dygraph.min.css"), page_file("style.css"))),
        modules(bundle_page_modules()) {}
  std::string policy() const {
    return fmt::format(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src {} "
        "{} {}; style-src {}; style-src-attr 'unsafe-inline'; img-src data: blob:\">\n",
        hash_source(page_file("three.min.js")), hash_source(page_file("dygraph.min.js")),
        hash_source(modules), hash_source(style));
  }
  std::string scripts() const {
    return fmt::format("<script>{}</script>\n<script>{}</script>\n<script>{}</script>\n",
                       page_file("three.min.js"), page_file("dygraph.min.js"), modules);
  }
};

Json run_json(const OpenedRun& run, const std::vector<FrameMesh>& meshes) {
  const PlanFileHeader& header = run.reader->header();
  Json json;
  json["name"] = run.request.name;
  json["file"] = run.request.plans.filename().string();
  json["sha256"] = files::sha256_of_file(run.request.plans);
  json["robot_name"] = run.robot.name;
  json["software"] = header.software;
  json["built_with"] = header.built_with;
  json["config_sha256"] = header.config_sha256;
  json["dataset_sha256"] = header.dataset_sha256;
  json["config"] = header.config;
  json["assumptions"] = Json::array();
  for (const Assumption& each : header.assumptions)
    json["assumptions"].push_back(assumption_json(each));
  json["not_verified"] = run.request.not_verified;
  json["plans"] = run.reader->size();
  json["shown"] = run.selected.plans.size();
  json["left_out"] = run.selected.left_out;
  json["robot"] = robot_json(run.robot);
  if (!meshes.empty()) json["robot"]["meshes"] = Json::array();
  for (const FrameMesh& mesh : meshes)
    json["robot"]["meshes"].push_back({{"frame", mesh.frame}, {"block", mesh.block}});
  return json;
}

void write_rows(const std::vector<OpenedRun>& runs, const ReportRequest& request, PageWriter& page,
                std::vector<std::string>& notes) {
  page.add("<script type=\"application/json\" id=\"rows\">[");
  const char* separator = "\n";
  for (int r = 0; r < std::ssize(runs); ++r) {
    for (const int k : runs[r].selected.plans) {
      Json row;
      row["run"] = r;
      row["block"] = block_id(r, k);
      const Plan plan = runs[r].reader->read(k);
      row.update(row_json(runs[r].robot, plan, runs[r].reader->plan_paths()[k]));
      row["physics"] = simulation_summary_json(
          simulation_folders(request.physics, runs[r].request.plans), runs[r].robot, plan, notes);
      page.add(separator);
      page.add(json_text(row));
      separator = ",\n";
    }
  }
  page.add("\n]</script>\n");
}

struct NamedBlock {
  std::string id, text;
};

/// Returns a block for each object of a scene, empty unless it is a mesh. Blocks are named by the
/// hash of their content, so that plans share them.
std::vector<NamedBlock> object_blocks(const Scene& scene) {
  constexpr std::size_t kHashLength = 16;
  std::vector<NamedBlock> blocks;
  for (const SceneObject& object : scene.objects) {
    if (object.shape != Shape::mesh) {
      blocks.push_back({});
      continue;
    }
    const std::string text = mesh_block(object.vertices, object.triangles).to_base64();
    blocks.push_back({"object-" + files::sha256(text).substr(0, kHashLength), text});
  }
  return blocks;
}

/// Returns the block of a plan, preceded by the blocks to which it refers.
std::vector<NamedBlock> blocks_of(const OpenedRun& run, const std::string& id, const Plan& plan) {
  std::vector<NamedBlock> blocks = object_blocks(plan.scene);
  std::vector<std::string> ids;
  for (const NamedBlock& block : blocks) ids.push_back(block.id);
  const PlanView view = make_plan_view(run.robot, run.world_from_base, plan, run.advice);
  blocks.push_back({id, plan_block(run.robot, plan, view, ids).to_base64()});
  return blocks;
}

void write_plans(const OpenedRun& run, int r, int jobs, std::set<std::string>& written,
                 PageWriter& page) {
  struct Item {
    int index;
    Plan plan;
  };
  parallel::OrderedParallelMap<Item, std::vector<NamedBlock>> map;
  map.next = [&, next = 0]() mutable -> std::unique_ptr<Item> {
    if (next == std::ssize(run.selected.plans)) return nullptr;
    const int index = run.selected.plans[next++];
    return std::make_unique<Item>(Item{index, run.reader->read(index)});
  };
  map.work = [&](const Item& item) {
    return std::make_unique<std::vector<NamedBlock>>(
        blocks_of(run, block_id(r, item.index), item.plan));
  };
  map.write = [&](const std::vector<NamedBlock>& blocks) {
    for (const NamedBlock& block : blocks) {
      if (!block.id.empty() && written.insert(block.id).second) page.block(block.id, block.text);
    }
  };
  parallel::run(map, jobs);
}

/// Removes the text before a comment, and the comment, from `rest`. Returns the text.
std::string_view take_until(std::string_view& rest, std::string_view comment) {
  const std::size_t position = rest.find(comment);
  assert(position != std::string_view::npos);
  const std::string_view before = rest.substr(0, position);
  rest.remove_prefix(position + comment.size());
  return before;
}

}  // namespace

ReportSummary write_report(const ReportRequest& request, const fs::path& file) {
  const std::vector<OpenedRun> runs = open_runs(request);
  ReportSummary summary;
  Json report = {{"software", software()},
                 {"angle_error", Resolution::kAngle_rad / 2},
                 {"hz", kDisplayRate_hz}};
  for (std::size_t k = 1; k < enum_count<Reason>(); ++k) {
    const auto reason = static_cast<Reason>(k);
    report["reasons"][std::string(name_of(reason))] = explain::explanation_of(reason).sentence;
  }
  report["runs"] = Json::array();
  std::vector<NamedBlock> robot_blocks;
  for (int r = 0; r < std::ssize(runs); ++r) {
    FoundMeshes found;
    if (!request.meshes.empty()) found = find_meshes(runs[r].robot, request.meshes);
    for (int k = 0; k < std::ssize(found.meshes); ++k) {
      FrameMesh& mesh = found.meshes[k];
      mesh.block = fmt::format("robot-{}-{}", r, k);
      robot_blocks.push_back({mesh.block, mesh_block(mesh.vertices, mesh.triangles).to_base64()});
    }
    summary.notes.insert(summary.notes.end(), found.notes.begin(), found.notes.end());
    report["runs"].push_back(run_json(runs[r], found.meshes));
    summary.shown += runs[r].selected.plans.size();
    const std::string& left_out = runs[r].selected.left_out;
    if (!left_out.empty()) summary.notes.push_back(left_out);
  }

  files::AtomicFile finished(file);
  PageWriter page(finished);
  const PageParts parts;
  std::string_view rest = page_file("index.html");
  page.add(take_until(rest, "<!--policy-->"));
  page.add(parts.policy());
  page.add(take_until(rest, "<!--style-->"));
  page.add(fmt::format("<style>{}</style>\n", parts.style));
  page.add(take_until(rest, "<!--licences-->"));
  page.add(page_file("licences.txt"));
  page.add(take_until(rest, "<!--report-->"));
  page.add(fmt::format("<script type=\"application/json\" id=\"report\">{}</script>\n",
                       json_text(report)));
  page.add(take_until(rest, "<!--rows-->"));
  write_rows(runs, request, page, summary.notes);
  page.add(take_until(rest, "<!--scripts-->"));
  page.add(parts.scripts());
  page.add(take_until(rest, "<!--blocks-->"));
  for (const NamedBlock& block : robot_blocks) page.block(block.id, block.text);
  std::set<std::string> written;
  for (int r = 0; r < std::ssize(runs); ++r) write_plans(runs[r], r, request.jobs, written, page);
  page.add(rest);
  page.finish();
  finished.commit();
  return summary;
}

}  // namespace morphe::report
