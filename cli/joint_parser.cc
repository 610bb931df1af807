#include "cli/joint_parser.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <set>

namespace tact::cli {
namespace {

constexpr const char* kJointHelp =
    "FILE is a log of the poses of a link A in a link B, one a line; - is standard input. With FILE2 they "
    "are the\n"
    "poses of A and of B in a common frame, as two tracked markers give them. Recognised are\n"
    "  time x y z qx qy qz qw            TUM\n"
    "  x y z qx qy qz qw\n"
    "  r11 r12 r13 x r21 ... r33 z       KITTI\n"
    "  time,x,y,z,qx,qy,qz,qw            a table whose header names the columns, in any order; EuRoC's and "
    "ROS' names\n"
    "  {\"time\":1.5,\"t\":[x,y,z],\"q\":[w,x,y,z]}   JSON lines\n"
    "Quaternions need not be of length one. Types: rigid, prismatic, revolute, screw, cylindrical, "
    "spherical, planar,\n"
    "two-axis. Exit status 1: the poses cannot tell the type, or leave a parameter open.\n"
    "Examples:\n"
    "  tact joint examples/joints/door.txt\n"
    "  tact joint lid.csv --unit mm --type screw --json\n"
    "  tact joint marker_on_door.txt marker_on_frame.txt -o door.html";

}  // namespace

void AddJointCommand(CLI::App& app, std::function<ExitStatus()>& run) {
  const auto options = std::make_shared<JointOptions>();
  CLI::App* parser = app.add_subcommand("joint", "Which joint a log of poses shows, where it is, how sure");
  parser->footer(kJointHelp);
  parser->add_option("FILE", options->files, "a log of poses of A in B, or two, of A and of B")
      ->required()
      ->expected(1, 2);
  parser->add_option("--type", options->type, "the type of joint; if not given it is found out")
      ->check(CLI::IsMember(std::set<std::string>{"rigid", "prismatic", "revolute", "screw", "cylindrical",
                                                  "spherical", "planar", "two-axis"}));
  parser
      ->add_option(
          "--method", options->method,
          "robust: some poses may be wrong; gaussian: all are right; least-squares: orientation first, then "
          "location; the last two with --type")
      ->check(CLI::IsMember(std::set<std::string>{"robust", "gaussian", "least-squares"}))
      ->capture_default_str();
  parser->add_option("--unit", options->unit,
                     "unit of locations: mm, cm, m or in; m if nothing says otherwise");
  parser->add_flag("--inverse", options->inverse, "the log is of B in A");
  parser->add_option("--quaternion", options->quaternion, "order in lines without names: xyzw or wxyz")
      ->check(CLI::IsMember(std::set<std::string>{"xyzw", "wxyz"}))
      ->capture_default_str();
  parser
      ->add_option("--time-limit", options->time_limit,
                   "seconds between poses of two logs at most; half the usual step if not given")
      ->check(CLI::NonNegativeNumber);
  parser->add_flag("--predict", options->predict, "predict each fifth of the poses from the others");
  parser->add_option("--seed", options->seed, "of the random samples")->capture_default_str();
  parser->add_option("-o,--output", options->page, "write a report with pictures into this HTML file");
  parser->add_flag("--json", options->json, "answer in JSON, in metre and radian");
  parser->callback([&run, options] { run = [options] { return RunJoint(*options); }; });
}

}  // namespace tact::cli
