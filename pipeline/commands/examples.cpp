#include "pipeline/commands/examples.hpp"

namespace morphe::commands {
namespace {

struct CommandExamples {
  std::string_view command, lines;
};

/// The examples. tests/cli/test_help.py runs them in this order: each uses the results of the
/// preceding ones.
constexpr CommandExamples kExamples[] = {
    {"run",
     "  morphe run configs/pipelines/pa10_dlr_hit2.yaml --out outputs/first --report\n"
     "  morphe run --from outputs/first/plans.h5 --dataset outputs/first/demonstrations.h5 --out "
     "outputs/again\n"},
    {"verify", "  morphe verify outputs/first\n"},
    {"diff", "  morphe diff outputs/first outputs/again\n"},
    {"list", "  morphe list outputs/first --sort tip_error_max --only executable\n"},
    {"explain", "  morphe explain outputs/first ADL001DR2/000\n"},
    {"report",
     "  morphe report outputs/first --out outputs/first.html\n"
     "  morphe report outputs/first outputs/again --out outputs/both.html --svg "
     "outputs/pictures\n"},
    {"simulate",
     "  morphe simulate outputs/first --out outputs/physics --only ADL001DR2 --rollouts 2\n"},
    {"export",
     "  morphe export outputs/first --format csv --out outputs/csv\n"
     "  morphe export outputs/first --format robomimic --out outputs/training\n"},
    {"import",
     "  morphe import datasets/ue-adl/recordings.yaml --out outputs/adl.h5\n"
     "  morphe import datasets/ue-adl/ADL001DR2.csv --static-trial "
     "datasets/ue-adl/ADL001_static.csv "
     "--out outputs/one.h5\n"},
    {"inspect",
     "  morphe inspect datasets/ue-adl/ADL001DR2.csv\n"
     "  morphe inspect outputs/adl.h5 --config configs/pipelines/pa10_dlr_hit2.yaml\n"},
    {"merge",
     "  morphe run configs/pipelines/pa10_dlr_hit2.yaml --out outputs/shards/1 --shard 1/2\n"
     "  morphe run configs/pipelines/pa10_dlr_hit2.yaml --out outputs/shards/2 --shard 2/2\n"
     "  morphe merge outputs/shards/1 outputs/shards/2 --out outputs/merged\n"},
    {"place",
     "  morphe place configs/pipelines/iiwa14_allegro.yaml --mount side --out outputs/placed.yaml "
     "--reach-map outputs/placed.svg\n"},
    {"robot",
     "  morphe robot configs/robots/pa10_dlr_hit2.yaml --svg outputs/robot.svg --urdf "
     "outputs/robot.urdf\n"},
    {"robot setup", "  morphe robot setup outputs/robot.urdf --out outputs/new_robot.yaml\n"},
    {"synthesize",
     "  morphe synthesize configs/synthetic/reach_to_grasp.yaml --out outputs/synthetic.h5 --count "
     "3\n"},
    {"study", "  morphe study configs/studies/retime.yaml --out outputs/retime --quick\n"},
    {"schema", "  morphe schema config\n  morphe schema robot --out outputs/robot.schema.json\n"},
    {"doctor", "  morphe doctor\n"},
};

}  // namespace

std::string examples_of(std::string_view command) {
  for (const CommandExamples& one : kExamples) {
    if (one.command == command) return "Examples:\n" + std::string(one.lines);
  }
  return "";
}

}  // namespace morphe::commands
