// [thesis, 5.4.2]: a bowline and a bow, watched while they are tied. The figures are lost; the curves of examples/knots are
// made after the text.
#include <algorithm>
#include <map>

#include "algebra/error.h"
#include "provers/claims/claims.h"
#include "provers/claims/knot_world.h"
#include "provers/knot_certificate.h"
#include "robot/input/curve_text.h"
#include "robot/input/knot_examples.h"
#include "robot/recognition/knot_recognition.h"

namespace tact::provers {
namespace {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using knot::RopeEnd;
using recognition::EndRead;
using recognition::KnotRecognition;

std::vector<PData> Watched(const char* name) {
  const auto example = input::FindKnotExample(name);
  if (!example) throw InvariantError(std::string(name) + " is not among the examples");
  std::vector<PData> sequence;
  for (const auto& curve : input::ParseCurves({example->text, example->source, 1})) {
    const auto projection = knot::ProjectCurve(curve.points, knot::ViewFromAbove());
    sequence.push_back(std::get<knot::CurveProjection>(projection).p);
  }
  return sequence;
}

std::string Name(const Move& move) {
  if (move.kind == MoveKind::kCross) return move.end == RopeEnd::kSelective ? "C_s" : "C_e";
  return move.kind == MoveKind::kR1 ? "R_I" : move.kind == MoveKind::kR2 ? "R_II" : "R_III";
}

Table TableOf(const std::string& caption, const std::vector<PData>& sequence,
              const KnotRecognition& recognized) {
  Table table{caption, {"t", "P-data", "end", "moves to the next"}, {}};
  for (size_t t = 0; t < sequence.size(); ++t) {
    std::string moves;
    if (t + 1 < sequence.size()) {
      for (const Move& move : recognized.transitions[t]) moves += (moves.empty() ? "" : ", ") + Name(move);
    }
    const EndRead end = recognized.ends[t];
    table.rows.push_back({std::to_string(t + 1), sequence[t].ToJson(),
                          end == EndRead::kSwapped  ? "the other"
                          : end == EndRead::kEither ? "either"
                                                    : "as given",
                          moves});
  }
  return table;
}

// A certificate for each transition; ends repaired.
void AddCertificates(Outcome& outcome, const std::string& id, const std::vector<PData>& sequence,
                     const KnotRecognition& recognized) {
  const auto read = [&](size_t t) {
    return recognized.ends[t] == EndRead::kSwapped ? EquivalentPData(sequence[t]) : sequence[t];
  };
  for (size_t t = 0; t + 1 < sequence.size(); ++t) {
    const auto& moves = recognized.transitions[t];
    for (size_t k = 0; k < moves.size(); ++k) {
      const std::string name =
          id + ".transition-" + std::to_string(t + 1) + (k > 0 ? "-" + std::to_string(k + 1) : "");
      outcome.certificates.push_back(KnotMoveCertificate(name, id, read(t), moves[k], read(t + 1)));
    }
  }
}

Outcome Reproduced(bool agrees, const std::vector<PData>& sequence) {
  Outcome outcome;
  outcome.verdict = agrees ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound = std::to_string(sequence.size()) + " curves made after the text";
  return outcome;
}

Outcome TryBowline(Effort) {
  const std::string id = "thesis.5.4.2.bowline";
  const std::vector<PData> sequence = Watched("bowline_tied");
  const KnotRecognition recognized = recognition::RecognizeKnot(sequence);
  bool agrees = sequence.size() == 8;
  for (size_t t = 0; t + 1 < sequence.size(); ++t) {
    const auto& moves = recognized.transitions[t];
    agrees = agrees && sequence[t + 1].columns() == sequence[t].columns() + 2 && !moves.empty() &&
             (moves.size() > 1) == (t == 0 || t == 3) &&
             std::any_of(moves.begin(), moves.end(), [](const Move& move) { return Name(move) == "C_s"; });
  }
  Outcome outcome = Reproduced(agrees, sequence);
  outcome.evidence =
      "The free end is the selective end and does the work: each transition is its Cross move C_s. In the "
      "first "
      "transition the loop is an R_I and a Cross move of the other end as well; in the fourth, where the "
      "free end goes "
      "behind the standing part, that part may as well have been laid over the free end.";
  outcome.tables = {TableOf("The bowline", sequence, recognized)};
  AddCertificates(outcome, id, sequence, recognized);
  return outcome;
}

Outcome TryWrongEnds(Effort) {
  const std::string id = "thesis.5.4.2.wrong-ends";
  const std::vector<PData> right = Watched("bowline_tied"), given = Watched("bowline_tied_wrong_ends");
  const KnotRecognition recognized = recognition::RecognizeKnot(given);
  bool agrees = given.size() == 8 && right.size() == 8;
  std::vector<EndRead> ends(8, EndRead::kAsGiven);
  ends[0] = ends[2] = EndRead::kEither;
  ends[5] = ends[6] = EndRead::kSwapped;
  agrees = agrees && recognized.ends == ends &&
           recognized.transitions == recognition::RecognizeKnot(right).transitions;
  // Counted from 1: P5 to P6, to its equivalent, P6 to P7, and the third.
  const auto fifth = agrees ? DetectMoves(given[4], EquivalentPData(given[5])) : std::vector<Move>();
  agrees = agrees && DetectMoves(given[4], given[5]).empty() && fifth.size() == 1 &&
           Name(fifth[0]) == "C_s" && !DetectMoves(given[5], given[6]).empty() &&
           given[2] == EquivalentPData(given[2]);
  Outcome outcome = Reproduced(agrees, given);
  outcome.evidence =
      "No move leads from the fifth P-data to the sixth as given, one Cross move of the selective end to its "
      "equivalent. "
      "From the sixth to the seventh one does, so both were read off from the wrong end. The third is its "
      "own "
      "equivalent: nobody can tell. The moves are those found with the right ends.";
  outcome.tables = {TableOf("The bowline, curves 3, 6 and 7 begun at the standing end", given, recognized)};
  AddCertificates(outcome, id, given, recognized);
  return outcome;
}

bool HasR2(const std::vector<Move>& moves) {
  return std::any_of(moves.begin(), moves.end(), [](const Move& move) { return move.kind == MoveKind::kR2; });
}

Outcome TryBow(Effort) {
  const std::string id = "thesis.5.4.2.bow";
  const std::vector<PData> sequence = Watched("bow_tied");
  const KnotRecognition recognized = recognition::RecognizeKnot(sequence);
  bool agrees = sequence.size() == 8;
  for (size_t t = 0; t + 1 < sequence.size(); ++t) {
    agrees = agrees && !recognized.transitions[t].empty() &&
             HasR2(recognized.transitions[t]) == (t == 3 || t == 5 || t == 6);
  }
  Outcome outcome = Reproduced(agrees, sequence);
  outcome.evidence =
      "First an overhand knot in three transitions; then one strand is laid over the other (R_II), the "
      "other's end led "
      "under it, and a loop of each pushed through (R_II twice).";
  outcome.tables = {TableOf("The bow", sequence, recognized)};
  AddCertificates(outcome, id, sequence, recognized);
  return outcome;
}

// What one or two Cross moves make of p, and the moves; of the ways to one P-data the first that is as short as any.
std::map<PData, std::vector<Move>> ReachedByCross(const PData& p) {
  std::map<PData, std::vector<Move>> reached = {{p, {}}};
  std::vector<PData> front = {p};
  for (int step = 0; step < 2; ++step) {
    std::vector<PData> next;
    for (const PData& from : front) {
      const std::vector<Move> way = reached.at(from);
      for (const Move& move : AllMoves(from)) {
        if (move.kind != MoveKind::kCross) continue;
        PData to = Apply(from, move);
        const auto [place, is_new] = reached.try_emplace(to, way);
        if (!is_new) continue;
        place->second.push_back(move);
        next.push_back(std::move(to));
      }
    }
    front = std::move(next);
  }
  return reached;
}

// A shortest way of Cross moves, of four at most; empty: there is none so short.
std::vector<Move> CrossWay(const PData& before, const PData& after) {
  const auto forth = ReachedByCross(before), back = ReachedByCross(after);
  std::vector<Move> best;
  for (const auto& [middle, way] : forth) {
    const auto rest = back.find(middle);
    if (rest == back.end() || (!best.empty() && way.size() + rest->second.size() >= best.size())) continue;
    best = way;
    for (size_t k = rest->second.size(); k-- > 0;) best.push_back(Inverse(rest->second[k]));
  }
  return best;
}

Outcome TryBowByCross(Effort) {
  const std::string id = "thesis.5.4.2.bow-by-cross";
  const std::vector<PData> sequence = Watched("bow_tied");
  Outcome outcome;
  outcome.bound = "the fourth, sixth and seventh transition";
  outcome.verdict = Verdict::kProved;
  for (const size_t t : {3, 5, 6}) {
    const std::vector<Move> way = CrossWay(sequence[t], sequence[t + 1]);
    if (way.empty()) outcome.verdict = Verdict::kUndecided;
    PData p = sequence[t];
    for (size_t k = 0; k < way.size(); ++k) {
      const PData next = Apply(p, way[k]);
      outcome.certificates.push_back(KnotMoveCertificate(
          id + ".transition-" + std::to_string(t + 1) + "-" + std::to_string(k + 1), id, p, way[k], next));
      p = next;
    }
    outcome.numbers.emplace_back("Cross moves for transition " + std::to_string(t + 1),
                                 static_cast<long long>(way.size()));
  }
  outcome.evidence =
      "An end is led where the strand was laid, back over what is in its way and forth again; no fewer Cross "
      "moves do. "
      "With R_II it is one move each: to push a loop through by Cross moves takes four.";
  return outcome;
}

}  // namespace

std::vector<Claim> KnotWatchedClaims() {
  return {{"thesis.5.4.2.bowline",
           "In every transition of the bowline the Cross move that ties it is selected, in the first and the "
           "fourth "
           "with others.",
           "5.4.2, Fig. 5.17", "simulation", TryBowline},
          {"thesis.5.4.2.wrong-ends",
           "Where the third, sixth and seventh P-data of the bowline are read off from the wrong end, the "
           "sixth and the "
           "seventh are found out and the third cannot be told.",
           "5.4.2, Fig. 5.18", "simulation", TryWrongEnds},
          {"thesis.5.4.2.bow", "R_II realizes the fourth, the sixth and the seventh transition of the bow.",
           "5.4.2, Fig. 5.19", "simulation", TryBow},
          {"thesis.5.4.2.bow-by-cross",
           "The transitions of the bow that R_II realizes can be realized by several Cross moves.",
           "5.4.2, Fig. 5.19", "exhaustive", TryBowByCross}};
}

}  // namespace tact::provers
