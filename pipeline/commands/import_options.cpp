#include "pipeline/commands/import_options.hpp"

#include <CLI/CLI.hpp>

#include "pipeline/commands/input_file.hpp"
#include "stages/import/folders/recording_formats.hpp"

namespace morphe::commands {

void add_import_options(CLI::App& app, imports::ImportRequest& request) {
  app.add_option("--static-trial", request.static_trial,
                 "Recording of the static trial (default: found among the recordings)")
      ->transform(input_file());
  app.add_option("--format", request.format,
                 "Format of the recordings (default: recognised from their content)")
      ->check(CLI::IsMember(imports::import_format_names()));
  app.add_option("--names", request.name_map,
                 "YAML file that maps the names in the recording to Morphe's names")
      ->transform(input_file());
  app.add_option("--axes", request.conventions.axes,
                 "Axes of the recording that point right, forward and up, such as 'x y z'");
  app.add_option_function<std::string>(
         "--forward",
         [&request](const std::string& by) {
           request.conventions.forward = *enum_from_name<imports::ForwardSource>(by);
         },
         "Forward direction: where the body faces (body, the default), or as recorded (recorded)")
      ->check(CLI::IsMember({"body", "recorded"}));
  app.add_option("--unit", request.conventions.unit,
                 "Unit of lengths: m, cm, mm, in, ft or metres per unit");
  app.add_option("--rate", request.conventions.rate_hz, "Frames per second")
      ->check(CLI::PositiveNumber);
  app.add_option("--joint-order", request.conventions.joint_order,
                 "Order of the hand joints in a clip, such as openpose or mano");
  app.add_option_function<std::string>(
         "--hand",
         [&request](const std::string& hand) {
           request.hand = enum_from_name<imports::HandSelection>(hand);
         },
         "Reaching hand: right, left or both (one demonstration per hand; default: determined from "
         "the motion)")
      ->check(CLI::IsMember({"right", "left", "both"}));
}

}  // namespace morphe::commands
