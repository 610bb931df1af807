#include "cli/knot_parser.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace tact::cli {
namespace {

constexpr const char* kKnotHelp =
    "P-DATA is a file, - for standard input, the name of an example, or the text itself, in any of these "
    "forms:\n"
    "  4 5 6 1 2 3 / 3 4 3 4 3 4                     the thesis' three rows or the last two, on lines or "
    "between /\n"
    "  {\"sigma\":[4,5,6,1,2,3],\"attr\":[3,4,3,4,3,4]}\n"
    "  O1+ U2+ O3+ U1+ O2+ U3+                       a signed Gauss code: over, under, number, sign\n"
    "  1 -2 3 -1 2 -3 +++                            the same: numbers, negative under, then the signs\n"
    "  PD[X[3,1,4,0],X[1,5,2,4],X[5,3,6,2]]          a PD code of an open rope, arcs 0..n\n"
    "  /                                             the straight rope\n"
    "  0 0 0                                         points of a rope in space, x y z, each on a line of its "
    "own;\n"
    "  1 0 1/2                                       --- on a line begins another curve (recognize)\n"
    "Attributes: 1 over/-, 2 under/-, 3 over/+, 4 under/+; + where the upper strand passes from left to "
    "right "
    "of the\n"
    "lower one. Columns, segments and faces are counted from 1.\n"
    "Example: tact knot faces '{\"sigma\":[4,5,6,1,2,3],\"attr\":[3,4,3,4,3,4]}'";

// A subcommand in the making.
class Maker {
 public:
  Maker(CLI::App& knot, std::function<ExitStatus()>& run, const char* name, const char* summary,
        const char* footer, ExitStatus (*command)(const KnotOptions&))
      : options_(std::make_shared<KnotOptions>()), app_(*knot.add_subcommand(name, summary)) {
    app_.footer(footer);
    app_.callback(
        [&run, command, options = options_] { run = [command, options] { return command(*options); }; });
    app_.add_flag("--json", options_->json, "answer in JSON");
  }
  CLI::Option* Inputs(const char* name, const char* what) {
    app_.add_option("--view", options_->view,
                    "from where curves are seen: X,Y,Z, or auto, where they have the fewest intersections")
        ->capture_default_str();
    return app_.add_option(name, options_->inputs, what)->required();
  }
  CLI::Option* Flag(const char* name, bool KnotOptions::*member, const char* what) {
    return app_.add_flag(name, (*options_).*member, what);
  }
  template <typename T>
  CLI::Option* Option(const char* name, T KnotOptions::*member, const char* what) {
    return app_.add_option(name, (*options_).*member, what);
  }

 private:
  std::shared_ptr<KnotOptions> options_;
  CLI::App& app_;
};

}  // namespace

void AddKnotCommand(CLI::App& app, std::function<ExitStatus()>& run) {
  CLI::App& knot = *app.add_subcommand("knot", "Knots of a rope with two ends: P-data, faces, moves, tying");
  knot.footer(kKnotHelp);
  knot.require_subcommand(0, 1);
  knot.callback([&knot] {
    if (!knot.get_subcommands().empty()) return;
    throw CLI::RequiredError("expected what to do with a knot, got none; tact knot --help lists it",
                             CLI::ExitCodes::RequiredError);
  });
  {
    Maker make(knot, run, "convert", "P-data in another notation",
               "FORM: rows, json, gauss, extended-gauss (Knoto-ID), pd, dt (of a closed knot). What is lost "
               "is said on "
               "standard\nerror; rows, json, gauss, extended-gauss and pd of an open rope lose nothing and "
               "read back.\n"
               "Example: tact knot convert '4 5 6 1 2 3 / 3 4 3 4 3 4' --to gauss",
               RunKnotConvert);
    make.Inputs("P-DATA", "what is converted")->expected(1);
    make.Option("--to", &KnotOptions::to, "the form")->capture_default_str();
    make.Option("--close", &KnotOptions::close, "join the ends by an arc over or under everything");
  }
  {
    Maker make(knot, run, "check", "Is it P-data, does a sphere hold it, what is it made of",
               "Example: tact knot check '4 5 6 1 2 3 / 3 4 3 4 3 4'", RunKnotCheck);
    make.Inputs("P-DATA", "what is checked")->expected(1);
  }
  {
    Maker make(knot, run, "faces", "The faces of a diagram", "Example: tact knot faces overhand",
               RunKnotFaces);
    make.Inputs("P-DATA", "the diagram")->expected(1);
  }
  {
    Maker make(knot, run, "moves", "The moves that turn A into B, or all that A admits",
               "Segments are counted in the P-data with fewer intersections.\n"
               "Example: tact knot moves '2 1 / 3 4' '4 3 2 1 / 3 3 4 4' --json",
               RunKnotMoves);
    make.Inputs("P-DATA", "A, or A and B")->expected(1, 2);
  }
  {
    Maker make(
        knot, run, "apply", "What a move makes of a P-data",
        "MOVE is what tact knot moves --json prints of one, or a file of it. Keys that are null may be left "
        "out.\n"
        "Example: tact knot apply '2 1 / 3 4' "
        "'{\"kind\":\"R1\",\"direction\":\"add\",\"segments\":[2],\"attr\":3}'",
        RunKnotApply);
    make.Inputs("P-DATA", "A")->expected(1)->allow_extra_args(false);
    make.Option("MOVE", &KnotOptions::move, "the move, in JSON")->required();
  }
  {
    Maker make(knot, run, "draw", "A picture of a rope, as SVG or PNG",
               "The selective end is a dot, the other an arrowhead; colours run from blue to red along the "
               "rope. The drawing\n"
               "is read back before it is shown. --json and --certificate give the exact drawing: the points "
               "of a rope in\n"
               "space, [X,Y,Z,W] for (X,Y,Z)/W, which seen along z is the P-data; tact-check reads it back.\n"
               "Examples: tact knot draw figure_eight -o figure_eight.png --labels\n"
               "          tact knot draw '2 1 / 3 4' --certificate loop.json",
               RunKnotDraw);
    make.Inputs("P-DATA", "what is drawn")->expected(1);
    make.Option("-o,--output", &KnotOptions::output,
                "FILE.svg or FILE.png; SVG on standard output if not given");
    make.Option("--outer", &KnotOptions::outer,
                "the face outside, counted as tact knot faces does; one that makes it even if not given");
    make.Flag("--exact", &KnotOptions::exact, "draw the exact drawing's straight edges");
    make.Flag("--labels", &KnotOptions::labels, "number the segments and the columns of intersections");
    make.Option("--certificate", &KnotOptions::certificate, "file for the exact drawing");
  }
  {
    Maker make(knot, run, "recognize", "Movement primitives of a sequence of P-data",
               "A file with a P-data in JSON a line or with many curves, or many files or texts. Where a "
               "P-data was read "
               "off from\nthe wrong end of the rope, that is found out and said.\n"
               "Example: tact knot recognize examples/knots/overhand_tied.jsonl",
               RunKnotRecognize);
    make.Inputs("P-DATA", "the sequence");
  }
  {
    Maker make(knot, run, "tie", "A shortest sequence of movement primitives that ties a knot",
               "Example: tact knot tie '4 5 6 1 2 3 / 3 4 3 4 3 4' --hold selective -o overhand_steps",
               RunKnotTie);
    make.Inputs("P-DATA", "the knot")->expected(1);
    make.Option("--moves", &KnotOptions::moves, "moves that may be used")->capture_default_str();
    make.Option("--hold", &KnotOptions::hold, "the end that is held and crosses nothing: selective or other");
    make.Option("--limit", &KnotOptions::limit, "steps at most");
    make.Option("-o,--output", &KnotOptions::output, "folder for index.html and steps.json");
  }
}

}  // namespace tact::cli
