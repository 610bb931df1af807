// Reads the arguments, runs a command, and is the one place that catches.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <functional>
#include <iostream>
#include <new>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/demonstration_parser.h"
#include "cli/joint_parser.h"
#include "cli/knot_parser.h"
#include "cli/recognize_parser.h"

namespace tact::cli {
namespace {

constexpr const char* kRelationHelp =
    "FILE holds a contact relation in JSON, or many, one a line; - is standard input.\n"
    "A contact is a point and its planes, each a normal to the legal side:\n"
    "  {\"contacts\":[{\"point\":[0,0,0],\"planes\":[[0,0,1]]},{\"point\":[2,0,0],\"planes\":[[0,0,1]]}]}\n"
    "or two CAD models in place, with the elements that touch (or without: all contacts are found):\n"
    "  "
    "{\"moving\":\"peg.off\",\"fixed\":\"hole.off\",\"unit\":\"mm\",\"pose\":{\"t\":[0,0,5],\"q\":[1,0,0,0]},"
    "\n"
    "   \"contacts\":[{\"moving\":{\"vertex\":3},\"fixed\":{\"face\":5}}]}\n"
    "Numbers are exact; strings such as \"1/3\" are numbers too.\n";

constexpr const char* kContactsHelp =
    "The models are STEP, OFF, OBJ, STL or PLY files of closed surfaces. The pose is that of MOVING in the "
    "frame "
    "of FIXED:\n"
    "a JSON text or a file of it, {\"t\":[x,y,z],\"q\":[w,x,y,z]} (exact; q need not be unit), or with "
    "\"axis\" and\n"
    "\"angle\", or with \"matrix\". With --json the answer is a contact relation file for tact dof and tact "
    "modes.\n"
    "Example: tact contacts peg.off slot.off --unit mm --pose '{\"t\":[0,0,-5],\"q\":[1,0,0,0]}'";

constexpr const char* kPlanHelp =
    "DEMO holds two models and two or more exact poses of the moving one, as for tact recognize. Each pair "
    "of\n"
    "neighbouring states is a transition: first the turns about constant axes, then a straight line, while "
    "the\n"
    "contact relation that restricts less is maintained; then the same by Ipopt, side by side. "
    "docs/plans.md\n"
    "explains the cases, the failures and the JSON. Exit status 1: some transition cannot be planned.\n"
    "Examples: tact plan examples/peg_in_hole/demonstration.json\n"
    "          tact plan examples/peg_in_hole/turned.json --samples 100 -o plan.html\n"
    "          tact plan examples/peg_in_hole/turned.json --reverse --closed-form --json";

constexpr const char* kPartsHelp =
    "Each SCAN is a text of points, x y z a line: the surface of one object of two rigid parts, nothing "
    "else, "
    "seen from\n"
    "about the same side, each time in another state. Lengths are in the unit of the scans, angles in JSON "
    "in "
    "radian.\n"
    "Points near the axis, which either part's motion explains, stay undecided (? in JSON).\n"
    "Example: tact parts examples/plier/*.xyz --svg plier.svg";

constexpr const char* kVerifyHelp =
    "Puts every claim of the ledger on trial and writes a folder with index.html for people, ledger.json "
    "for\n"
    "programs and certificates/, which tact-check re-checks on its own.\n"
    "Example: tact verify --only 'thesis.2.8.2.*' -o peg_report";

constexpr const char* kEnumerateHelp =
    "Enumerates all kinds of something, with a count and a smallest witness of each. A run can be cut short "
    "at any\n"
    "moment: with -o DIR the same command goes on where it was. Parts of it may run elsewhere, too:\n"
    "  tact enumerate dof-classes --world cube --contacts 9 -o part1 --shard 1/2\n"
    "  tact enumerate dof-classes --world cube --contacts 9 -o part2 --shard 2/2\n"
    "  tact enumerate dof-classes --world cube --contacts 9 -o all --from part1 --from part2\n"
    "Whatever the shards, threads and interruptions, the results are the same, byte for byte.\n"
    "Example: tact enumerate dof-classes --json";

constexpr const char* kDofClassesHelp =
    "The motion DOFs that contact relations can have, for each choice of indices that tell two relations "
    "apart.\n"
    "What cannot occur is excluded by proof; for what can, a witness is searched among all sets of at most "
    "so\n"
    "many contacts of a small world:\n"
    "  corner    chosen to have a witness of every class\n"
    "  cube      corners of a cube, normals along the axes\n"
    "  axis      points of {-1, 0, 1}^3, normals along the axes\n"
    "  diagonal  the same points, normals of entries -1, 0, 1\n"
    "DIR gets index.html, classes.json and classes.csv; its folder work keeps what is computed.\n"
    "Example: tact enumerate dof-classes --world cube --contacts 8 -o classes";

constexpr const char* kDofTransitionsHelp =
    "Steps between contact relations when something more touches; read backwards, when something parts:\n"
    "  - between the ten kinds in translation, by what counts as a step;\n"
    "  - between the DOF classes of all sets of fewer than so many contacts of a small world (as in tact\n"
    "    enumerate dof-classes), each with every contact, edge and face of the world more;\n"
    "  - the thirty DOF-transitions, in translation and in rotation, shown by solids and exact motions.\n"
    "DIR gets index.html, transitions.json and transitions.csv; its folder work keeps what is computed.\n"
    "JSON: "
    "{\"translation_steps\":[{\"definition\",\"pairs\",\"list\"}],\"class_steps\":[{\"added\",\"steps\",\n"
    "  "
    "\"definitions\":[{\"name\",\"indices\",\"pairs\",\"within\",\"list\":[{\"from\",\"to\",\"count\","
    "\"witness\"}]}]}],\n"
    "  \"maintaining_to_constraining\":[{\"added\",\"motion\",\"steps\",\"witness\"}],\n"
    "  \"dof_transitions\":[{\"motion\",\"from\",\"to\",\"practical\",\"occurs\",\"forced_by_counts\","
    "\"witness\"}],...}\n"
    "Example: tact enumerate dof-transitions --world cube --contacts 5 -o transitions";

constexpr const char* kPDataHelp =
    "All planar P-data with N intersections, over and under forgotten: codes (who crosses whom, and which "
    "way).\n"
    "They are visited one by one, in an order that does not vary, and counted by what they are; how many "
    "there\n"
    "are is compared with a second method, which follows the rope and remembers only what is unexplored.\n"
    "JSON: {\"crossings\",\"codes\",\"p_data\",\"pairings\",\"irreducible\":{\"codes\",\"p_data\"},\n"
    "  \"up_to_reversal\",\"up_to_mirror\",\"up_to_both\",\"ends_on_one_face\"}: P-data are a code with each "
    "choice\n"
    "  of over and under, pairings forget the crossing signs too, up_to_ and ends_on_one_face are of codes.\n"
    "With --list every code is printed, a line each: {\"sigma\":[mates],\"turn\":[+1: the other strand "
    "passes from\n"
    "right to left, -1]}. With --codes only the number of codes is found, by the second method: to 20.\n"
    "Examples: tact enumerate p-data --crossings 8\n"
    "          tact enumerate p-data --crossings 4 --list | head\n"
    "          tact enumerate p-data --crossings 14 --codes";

constexpr const char* kMovesHelp =
    "The move graph: all P-data of a sphere with at most so many intersections, as read off from one end,\n"
    "joined by the four movement primitives. Distances and classes are those of the graph: on the way there\n"
    "are never more intersections than N. Six take 20 seconds and 200 MB.\n"
    "JSON: {\"crossings\",\"p_data\",\"levels\":[{\"crossings\",\"p_data\",\"self_equivalent\",\"steps\",\n"
    "  "
    "\"straight_class\",\"straight_bracket\"}],\"edges\":[{\"kind\",\"from\",\"to\",\"moves\",\"pairs\"}],\n"
    "  \"pairs\",\"pairs_by_kinds\":[{\"kinds\",\"pairs\"}],\"pairs_with_several_kinds\",\n"
    "  \"pairs_with_several_moves\",\"without_cross\":{\"classes\",\"brackets\"}}; steps[d] counts P-data at "
    "d\n"
    "  steps from the straight rope; an edge is an addition (the removals are as many) or an R3 (both "
    "ways).\n"
    "Example: tact enumerate moves --crossings 4";

std::string CommandNames(const CLI::App& app) {
  std::string names;
  for (const CLI::App* command : app.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

bool IsCommand(const CLI::App& app, const std::string& word) {
  const auto commands = app.get_subcommands({});
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* c) { return c->get_name() == word; });
}

// What was asked for: every command's options, and the command to run with them.
struct Request {
  FileOptions file;
  ContactsOptions contacts;
  PlanOptions plan;
  PartsOptions parts;
  VerifyOptions verify;
  EnumerateOptions classes;
  EnumerateOptions transitions;
  PDataOptions p_data;
  MoveGraphOptions moves;
  std::function<ExitStatus()> run;
};

void AddFileCommand(CLI::App& app, Request& request, const char* name, const char* summary,
                    const char* argument, const std::string& footer, ExitStatus (*run)(const FileOptions&)) {
  CLI::App* parser = app.add_subcommand(name, summary);
  parser->footer(footer);
  parser->add_option(argument, request.file.file, "a file, or - for standard input")->required();
  parser->add_flag("--json", request.file.json, "answer in JSON");
  parser->callback([&request, run] { request.run = [&request, run] { return run(request.file); }; });
}

void AddContactsCommand(CLI::App& app, Request& request) {
  ContactsOptions& options = request.contacts;
  CLI::App* parser = app.add_subcommand("contacts", "The contact relation of two CAD models in a pose");
  parser->footer(kContactsHelp);
  parser->add_option("MOVING", options.moving, "the moving model")->required();
  parser->add_option("FIXED", options.fixed, "the fixed model")->required();
  parser->add_option("--pose", options.pose, "pose of MOVING in the frame of FIXED")->required();
  parser->add_option("--unit", options.unit,
                     "unit of both models and the pose: mm, cm, m or in (a mesh names none)");
  parser
      ->add_option("--tolerance", options.tolerance,
                   "gap or overlap that still counts as contact, millimetres")
      ->capture_default_str();
  parser->add_option("--svg", options.svg, "draw the models and their contacts into this file");
  parser->add_flag("--json", options.json, "answer with a contact relation in JSON");
  parser->callback([&request] { request.run = [&request] { return RunContacts(request.contacts); }; });
}

void AddPlanCommand(CLI::App& app, Request& request) {
  PlanOptions& options = request.plan;
  CLI::App* parser = app.add_subcommand("plan", "Optimal trajectories between a demonstration's states");
  parser->footer(kPlanHelp);
  parser->add_option("DEMO", options.file, "a file, or - for standard input")->required();
  parser->add_option("--samples", options.samples, "samples of a turn or a line")->capture_default_str();
  parser->add_flag("--reverse", options.reverse, "from the last state to the first");
  parser->add_flag("--closed-form", options.closed_form, "without Ipopt");
  parser->add_option("-o,--output", options.page, "write a page with pictures into this file");
  parser->add_flag("--json", options.json, "answer in JSON");
  parser->callback([&request] { request.run = [&request] { return RunPlan(request.plan); }; });
}

void AddPartsCommand(CLI::App& app, Request& request) {
  PartsOptions& options = request.parts;
  CLI::App* parser =
      app.add_subcommand("parts", "A linkage's two parts and its axis, from scans of its states");
  parser->footer(kPartsHelp);
  parser->add_option("SCAN", options.scans, "files of points, two or more")->required();
  parser->add_option("--svg", options.svg, "draw the first scan's parts and the axis into this file");
  parser->add_flag("--json", options.json, "answer in JSON");
  parser->callback([&request] { request.run = [&request] { return RunParts(request.parts); }; });
}

void AddVerifyCommand(CLI::App& app, Request& request) {
  VerifyOptions& options = request.verify;
  CLI::App* parser = app.add_subcommand("verify", "Put the ledger of claims on trial and write the report");
  parser->footer(kVerifyHelp);
  CLI::Option* quick = parser->add_flag("--quick", options.quick, "smaller bounds, for a look");
  parser->add_flag("--full", options.full, "the largest bounds")->excludes(quick);
  parser->add_option("--only", options.only, "claims whose id matches: globs with * and ?");
  parser->add_option("-o,--output", options.directory, "folder of the report")->capture_default_str();
  parser->callback([&request] { request.run = [&request] { return RunVerify(request.verify); }; });
}

// What every run in units takes.
void AddRunOptions(CLI::App& parser, UnitRunOptions& options) {
  const CLI::Validator named(
      [](const std::string& folder) { return folder.empty() ? "expected a folder, got no name" : ""; }, "");
  parser.add_option("-o,--output", options.directory, "folder of the run and its results")->check(named);
  parser.add_option("--threads", options.threads, "threads; as many as there are cores if not given");
  parser.add_option("--shard", options.shard, "compute only part i of n, written i/n")->capture_default_str();
  parser.add_option("--from", options.from, "folder of the same run whose finished units are taken over")
      ->allow_extra_args(false)
      ->check(named);
  parser.add_flag("--yes", options.yes, "start however long it takes");
}

void AddEnumeration(CLI::App& enumerate, Request& request, EnumerateOptions& options, const char* name,
                    const char* summary, const char* footer, ExitStatus (*run)(const EnumerateOptions&)) {
  CLI::App* parser = enumerate.add_subcommand(name, summary);
  parser->footer(footer);
  parser->add_option("--world", options.world, "where witnesses are searched: corner, cube, axis or diagonal")
      ->capture_default_str();
  parser->add_option("--contacts", options.contacts, "contacts in a relation, at most")
      ->capture_default_str();
  CLI::Option* json = parser->add_flag("--json", options.json, "answer in JSON");
  parser->add_flag("--csv", options.csv, "answer with a line a class, or a pair of classes")->excludes(json);
  AddRunOptions(*parser, options);
  parser->callback([&request, &options, run] { request.run = [&options, run] { return run(options); }; });
}

void AddPDataCommand(CLI::App& enumerate, Request& request) {
  PDataOptions& options = request.p_data;
  CLI::App* parser = enumerate.add_subcommand("p-data", "All planar P-data: counts, or every code");
  parser->footer(kPDataHelp);
  parser->add_option("--crossings", options.crossings, "intersections")->capture_default_str();
  CLI::Option* json = parser->add_flag("--json", options.json, "answer in JSON");
  CLI::Option* list = parser->add_flag("--list", options.list, "print every code")->excludes(json);
  parser->add_flag("--codes", options.codes, "only how many codes there are")->excludes(list);
  AddRunOptions(*parser, options);
  parser->callback([&request] { request.run = [&request] { return RunEnumeratePData(request.p_data); }; });
}

void AddEnumerateCommand(CLI::App& app, Request& request) {
  CLI::App* parser =
      app.add_subcommand("enumerate", "All kinds of something, each with a count and a smallest witness");
  parser->footer(kEnumerateHelp);
  parser->require_subcommand(0, 1);
  parser->callback([parser] {
    if (!parser->get_subcommands().empty()) return;
    throw CLI::RequiredError("expected what to enumerate, one of " + CommandNames(*parser) + ", got none",
                             CLI::ExitCodes::RequiredError);
  });
  AddEnumeration(*parser, request, request.classes, "dof-classes",
                 "The motion DOFs that contact relations can have: an exact list", kDofClassesHelp,
                 RunEnumerateDofClasses);
  request.transitions.contacts = 6;  // a few seconds' work
  AddEnumeration(*parser, request, request.transitions, "dof-transitions",
                 "Steps between contact relations, and the thirty DOF-transitions as solids that move",
                 kDofTransitionsHelp, RunEnumerateDofTransitions);
  AddPDataCommand(*parser, request);
  CLI::App* moves = parser->add_subcommand("moves", "The move graph of all P-data with few intersections");
  moves->footer(kMovesHelp);
  moves->add_option("--crossings", request.moves.crossings, "intersections, at most")->capture_default_str();
  moves->add_flag("--json", request.moves.json, "answer in JSON");
  moves->callback([&request] { request.run = [&request] { return RunEnumerateMoves(request.moves); }; });
}

void AddCommands(CLI::App& app, Request& request) {
  AddFileCommand(app, request, "dof", "Motion DOFs of contact relations", "FILE",
                 std::string(kRelationHelp) + "Example: tact dof edge_on_face.json --json", RunDof);
  AddFileCommand(app, request, "modes", "Contact modes: every face of the legal cone", "FILE",
                 std::string(kRelationHelp) + "Example: tact modes edge_on_face.json --json", RunModes);
  AddContactsCommand(app, request);
  AddRecognizeCommand(app, request.run);
  AddPlanCommand(app, request);
  AddDemonstrationCommand(app, request.run);
  AddJointCommand(app, request.run);
  AddPartsCommand(app, request);
  AddVerifyCommand(app, request);
  AddEnumerateCommand(app, request);
  AddKnotCommand(app, request.run);
}

int ReportUsage(const std::string& message, const std::string& command = "") {
  std::cerr << "tact: " << message << "; tact " << command << (command.empty() ? "" : " ")
            << "--help says more\n";
  return kBadInput;
}

// The command whose arguments are wrong, if one was named.
std::string NamedCommand(const CLI::App& app) {
  const auto named = app.get_subcommands();
  if (named.empty()) return "";
  const std::string further = NamedCommand(*named.front());
  return named.front()->get_name() + (further.empty() ? "" : " " + further);
}

int Run(int argc, char** argv) {
  CLI::App app(
      "tact: exact contact kinematics\nExit status: 0 answered, 1 undecided, 2 bad input, 3 a bug of tact",
      "tact");
  app.set_version_flag("--version", "tact " TACT_VERSION);
  Request request;
  AddCommands(app, request);
  if (argc > 1 && argv[1][0] != '-' && !IsCommand(app, argv[1])) {
    return ReportUsage("expected a command, one of " + CommandNames(app) + ", got '" + std::string(argv[1]) +
                       "'");
  }
  if (argc > 2 && argv[2][0] != '-') {
    const CLI::App& command = *app.get_subcommand(argv[1]);
    if (!command.get_subcommands({}).empty() && !IsCommand(command, argv[2])) {
      return ReportUsage(
          "expected " +
              std::string(argv[1] == std::string("knot") ? "what to do with a knot" : "what to enumerate") +
              ", one of " + CommandNames(command) + ", got '" + std::string(argv[2]) + "'",
          argv[1]);
    }
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return ReportUsage(error.what(), NamedCommand(app));
  }
  if (!request.run) return ReportUsage("expected a command, one of " + CommandNames(app) + ", got none");
  return request.run();
}

}  // namespace
}  // namespace tact::cli

int main(int argc, char** argv) {
  using namespace tact;
  std::signal(SIGXFSZ, SIG_IGN);  // a file over its limit is a write that fails
  std::ios::sync_with_stdio(false);
  try {
    return cli::Run(argc, argv);
  } catch (const InputError& error) {
    std::cerr << "tact: " << error.what() << "\n";
    return cli::kBadInput;
  } catch (const BudgetError& error) {
    std::cerr << "tact: undecided: " << error.what() << "\n";
    return cli::kUndecided;
  } catch (const std::bad_alloc&) {
    std::cerr << "tact: expected to hold the input in memory, got no more of it\n";
    return cli::kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "tact: a bug of tact, please report it with the input: " << error.what() << "\n";
    return cli::kOurBug;
  }
}
