#include "cli/recognize_parser.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace tact::cli {
namespace {

constexpr const char* kRecognizeHelp =
    "DEMO holds two models and the poses of the moving one, or contact relations:\n"
    "  {\"moving\":\"peg.off\",\"fixed\":\"slot.off\",\"unit\":\"mm\",\"tolerance\":0,\n"
    "   \"states\":[{\"name\":\"A\",\"pose\":{\"t\":[0,0,3],\"q\":[1,0,0,0]}},...]}\n"
    "  {\"relations\":[{\"name\":\"A\",\"contacts\":[...]},...]}\n"
    "whose poses are exact, or it is a recording with a tracker's errors:\n"
    "  No of Models: 2 ...               a pose list, two models and their poses scene after scene\n"
    "  {\"moving\":\"peg.off\",\"fixed\":\"slot.off\",\"unit\":\"mm\",\n"
    "   \"logs\":{\"moving\":\"peg.txt\",\"fixed\":\"slot.txt\",\"unit\":\"m\"}}\n"
    "Of a recording the most plausible sequence of contact relations is found, each with an exact pose that "
    "has "
    "it.\n"
    "Examples:\n"
    "  tact recognize examples/peg_in_hole/demonstration.json\n"
    "  tact recognize peg_in_hole.pose.list -o scenes.html --states states.json";

}  // namespace

void AddRecognizeCommand(CLI::App& app, std::function<ExitStatus()>& run) {
  const auto options = std::make_shared<RecognizeOptions>();
  CLI::App* parser =
      app.add_subcommand("recognize", "A demonstration's contact relations, transitions and sub-skills");
  parser->footer(kRecognizeHelp);
  parser->add_option("DEMO", options->file, "a demonstration or a recording; - is standard input")
      ->required();
  parser->add_flag("--noisy", options->noisy, "the poses carry a tracker's errors, whatever the form");
  parser
      ->add_option("--noise", options->noise,
                   "standard deviation of the errors a component, DEGREES LENGTH; estimated if not given")
      ->expected(2);
  parser->add_option("--unit", options->unit,
                     "unit of a pose list's locations: mm, cm, m or in; mm if not given");
  parser->add_option("--states", options->states,
                     "write a demonstration with one exact state a relation, for tact plan");
  parser->add_option("-o,--output", options->page,
                     "write a page with pictures of the scenes into this HTML file");
  parser->add_flag("--json", options->json, "answer in JSON");
  parser->callback([&run, options] { run = [options] { return RunRecognize(*options); }; });
}

}  // namespace tact::cli
