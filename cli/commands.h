/// @file
/// The commands of `tact`, one a file; main.cc reads their arguments and catches their errors.
/// Errors  InputError for bad input and for output that cannot be written.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tact::cli {

/// Exit statuses.
enum ExitStatus : int { kAnswered = 0, kUndecided = 1, kBadInput = 2, kOurBug = 3 };

struct FileOptions {
  std::string file;   // "-" is standard input
  bool json = false;  // one JSON object a line
};

struct ContactsOptions {
  std::string moving, fixed;    // mesh files
  std::string pose;             // of the moving model in the fixed one's frame, in JSON or a file of it
  std::string tolerance = "0";  // millimetres
  std::string unit;             // of both models and of the pose
  std::string svg;              // a file for a drawing; empty: none
  bool json = false;
};

struct VerifyOptions {
  bool quick = false, full = false;
  std::vector<std::string> only;  // globs of claim ids; none: every claim
  std::string directory = "report";
};

/// Of runs in units.
struct UnitRunOptions {
  bool json = false;
  std::string directory;             // of the run and its results; empty: nothing is kept
  std::optional<long long> threads;  // none: as many as there are cores
  std::string shard = "1/1";         // which part of the run: i/n
  std::vector<std::string> from;     // directories of the same run whose units are taken over
  bool yes = false;                  // however long it takes
};

struct EnumerateOptions : UnitRunOptions {
  std::string world = "corner";  // enumerators::WorldNames
  long long contacts = 7;        // in a relation, at most
  bool csv = false;
};

struct PDataOptions : UnitRunOptions {
  long long crossings = 6;
  bool list = false;   // every code, instead of counts
  bool codes = false;  // only how many codes there are, by transfer
};

struct MoveGraphOptions {
  long long crossings = 4;  // intersections, at most
  bool json = false;
};

struct PartsOptions {
  std::vector<std::string> scans;  // files of points
  std::string svg;                 // a file for a drawing; empty: none
  bool json = false;
};

struct PlanOptions {
  std::string file;          // "-" is standard input
  long long samples = 50;    // a segment
  bool reverse = false;      // from the last state to the first
  bool closed_form = false;  // without Ipopt
  std::string page;          // a file for the report; empty: none
  bool json = false;
};

/// Of the commands `tact knot ...`; each uses some.
struct KnotOptions {
  std::vector<std::string> inputs;       // P-data or curves: files, examples or texts
  std::string view = "0,0,1";            // from where curves are seen: "X,Y,Z" or "auto"
  std::string move;                      // apply: in JSON
  std::string to = "rows";               // convert: the form that is written
  std::string close;                     // convert: "over" or "under"; empty: the rope stays open
  std::string output;                    // tie: a folder; draw: a picture
  std::optional<long long> outer;        // draw: the face outside, from 1
  bool exact = false, labels = false;    // draw
  std::string certificate;               // draw: a file
  std::string moves = "R1,R2,R3,Cross";  // tie: what may be used
  std::string hold;                // tie: "selective" or "other", the end that does not cross; empty: neither
  std::optional<long long> limit;  // tie: steps at most
  bool json = false;
};

struct JointOptions {
  std::vector<std::string> files;    // one log of A in B, or one of A and one of B in a common frame
  std::string type;                  // empty: to be found out
  std::string method = "robust";     // or, with a type, "gaussian", "least-squares"
  std::string unit;                  // of locations; empty: as a header says, else m
  std::string quaternion = "xyzw";   // the order where no names tell
  bool inverse = false;              // the log is of B in A
  std::optional<double> time_limit;  // second, between poses of two logs
  bool predict = false;              // hold poses back and predict them
  std::uint64_t seed = 1;
  std::string page;  // a file for the report; empty: none
  bool json = false;
};

struct RecognizeOptions {
  std::string file;  // "-" is standard input
  bool noisy = false;
  std::vector<double> noise;  // degrees and the models' unit, or nothing: estimated
  std::string unit;           // of a pose list's locations; empty: mm
  std::string states;         // a demonstration's file to write; empty: none
  std::string page;           // an HTML file to write; empty: none
  bool json = false;
};

struct DemonstrationOptions {
  std::string file;                      // a recording; "-" is standard input
  std::string unit;                      // of a pose list's locations; empty: mm
  std::optional<long long> every;        // keep each so-manieth scene
  std::optional<long long> scenes;       // so many at even times
  std::optional<std::uint64_t> noise;    // a seed; none: no noise is added
  double degrees = 5, millimetres = 10;  // largest errors
  bool contacts = false;                 // estimate them, scene by scene
  std::optional<double> threshold;       // in the models' unit
  std::string output;                    // a JSON file; empty: none
  bool json = false;
};

/// Motion DOFs of each contact relation of a file.
ExitStatus RunDof(const FileOptions& options);
/// Contact modes of each contact relation of a file.
ExitStatus RunModes(const FileOptions& options);
/// The contact relation of two models in a pose.
ExitStatus RunContacts(const ContactsOptions& options);
/// Contact relations, transitions, sub-skills and critical transitions of a demonstration.
ExitStatus RunRecognize(const RecognizeOptions& options);
/// Optimal trajectories between a demonstration's neighbouring states, in closed form and by Ipopt; kUndecided if one fails.
ExitStatus RunPlan(const PlanOptions& options);
/// What a recording holds; resampled, made noisy, written as JSON.
ExitStatus RunDemonstration(const DemonstrationOptions& options);
/// Which joint a log of poses shows, where it is, how sure.
ExitStatus RunJoint(const JointOptions& options);
/// Two parts of a linkage, divided by scans of it in different states, and the axis about which they turn.
ExitStatus RunParts(const PartsOptions& options);
/// The ledger of claims on trial; writes the report.
ExitStatus RunVerify(const VerifyOptions& options);
/// The exact list of DOF classes, with witnesses from a finite world.
ExitStatus RunEnumerateDofClasses(const EnumerateOptions& options);
/// Steps between contact relations, and the DOF-transitions that solids show.
ExitStatus RunEnumerateDofTransitions(const EnumerateOptions& options);
/// Planar P-data counted by what they are, or all codes listed.
ExitStatus RunEnumeratePData(const PDataOptions& options);
/// The move graph of all P-data with few intersections.
ExitStatus RunEnumerateMoves(const MoveGraphOptions& options);
/// P-data in another notation.
ExitStatus RunKnotConvert(const KnotOptions& options);
/// Whether a text is P-data, whether a sphere holds it, what it is made of.
ExitStatus RunKnotCheck(const KnotOptions& options);
/// The faces of a diagram.
ExitStatus RunKnotFaces(const KnotOptions& options);
/// The moves that explain a transition, or all that a P-data admits.
ExitStatus RunKnotMoves(const KnotOptions& options);
/// What a move makes of a P-data.
ExitStatus RunKnotApply(const KnotOptions& options);
/// A picture of a rope.
ExitStatus RunKnotDraw(const KnotOptions& options);
/// Movement primitives of a sequence of P-data.
ExitStatus RunKnotRecognize(const KnotOptions& options);
/// A shortest sequence of movement primitives that ties a knot.
ExitStatus RunKnotTie(const KnotOptions& options);

}  // namespace tact::cli
