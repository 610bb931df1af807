#include "cli/demonstration_parser.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace tact::cli {
namespace {

constexpr const char* kDemonstrationHelp =
    "FILE is a recording, told by its contents; - is standard input:\n"
    "  a pose list      No of Models: 2, the models' files, No of Scenes: N, then a line an object and "
    "scene,\n"
    "                   <flag> tx ty tz ax ay az angle (mm, axis, radian), in the camera's frame\n"
    "  two pose logs    {\"moving\":\"peg.step\",\"fixed\":\"hole.off\",\"unit\":\"mm\",\n"
    "                    \"logs\":{\"moving\":\"peg.txt\",\"fixed\":\"hole.txt\",\"unit\":\"m\"}}, logs as "
    "tact joint "
    "reads them;\n"
    "                   or \"logs\":{\"relative\":\"peg_in_hole.txt\"}\n"
    "  a demonstration  "
    "{\"moving\":...,\"fixed\":...,\"unit\":\"mm\",\"states\":[{\"name\":\"A\",\"pose\":{...}},...]}\n"
    "Models are STEP, OFF, OBJ, STL or PLY files. What it holds is printed; -o writes it as a demonstration "
    "in JSON,\n"
    "after resampling and noise: the direction of each error uniform, its size uniform up to a largest.\n"
    "Examples:\n"
    "  tact demonstration peg_in_hole.pose.list --contacts\n"
    "  tact demonstration peg_in_hole.pose.list --every 4 -o every_fourth.json\n"
    "  tact demonstration examples/peg_in_hole/demonstration.json --noise 1 --degrees 0.5 --millimetres 0.1 "
    "-o "
    "noisy.json";

}  // namespace

void AddDemonstrationCommand(CLI::App& app, std::function<ExitStatus()>& run) {
  const auto options = std::make_shared<DemonstrationOptions>();
  CLI::App* parser =
      app.add_subcommand("demonstration", "What a recording holds; resampled, made noisy, as JSON");
  parser->footer(kDemonstrationHelp);
  parser->add_option("FILE", options->file, "a recording, or - for standard input")->required();
  parser->add_option("--unit", options->unit,
                     "unit of a pose list's locations: mm, cm, m or in; mm if not given");
  CLI::Option* every =
      parser->add_option("--every", options->every, "keep only the first and each K-th scene after it")
          ->check(CLI::PositiveNumber);
  parser->add_option("--scenes", options->scenes, "N scenes at even times, poses between interpolated")
      ->check(CLI::Range(2, 1000000))
      ->excludes(every);
  CLI::Option* noise = parser->add_option("--noise", options->noise, "add noise drawn from this seed");
  parser->add_option("--degrees", options->degrees, "largest error of an orientation")
      ->needs(noise)
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  parser->add_option("--millimetres", options->millimetres, "largest error of a location")
      ->needs(noise)
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  parser->add_flag("--contacts", options->contacts, "estimate which elements touch in each scene");
  parser
      ->add_option("--threshold", options->threshold,
                   "distance below which elements may touch, in the models' unit; by the noise if not given")
      ->check(CLI::PositiveNumber);
  parser->add_option("-o,--output", options->output, "write a demonstration in JSON into this file");
  parser->add_flag("--json", options->json, "answer in JSON");
  parser->callback([&run, options] { run = [options] { return RunDemonstration(*options); }; });
}

}  // namespace tact::cli
