// Certificates of kind "knot-tying", and what is changed in them.
#include "provers/knot_certificate.h"

#include <gtest/gtest.h>

#include "provers/check/check.h"
#include "tests/algebra/knot/p_data_world.h"
#include "tests/provers/knot_oracle.h"

namespace tact::provers {
namespace {

using nlohmann::json;

check::Answer Check(const json& certificate) { return check::CheckCertificate(certificate.dump()); }

// A rope that random moves of every kind tie, of so many intersections at most.
json RandomCertificate(std::mt19937_64& random, int steps, int most_crossings) {
  std::vector<knot::TyingStep> sequence;
  knot::PData p;
  while (static_cast<int>(sequence.size()) < steps) {
    const auto moves = AllMoves(p, most_crossings);
    const knot::MoveKind kind = moves[random() % moves.size()].kind;
    std::vector<knot::Move> of_kind;
    for (const knot::Move& move : moves) {
      // An R3 wherever there is one: they are few.
      if (move.kind == kind || move.kind == knot::MoveKind::kR3) of_kind.push_back(move);
    }
    const knot::Move move =
        of_kind.back().kind == knot::MoveKind::kR3 ? of_kind.back() : of_kind[random() % of_kind.size()];
    p = Apply(p, move);
    sequence.push_back({move, p});
  }
  return json::parse(KnotTyingCertificate("t", "c", sequence, knot::TyingBound(p, {}).steps()).json);
}

TEST(KnotCertificate, SequencesOfEveryMoveAreAccepted) {
  std::mt19937_64 random(31);
  std::set<std::string> kinds;
  for (int trial = 0; trial < 150; ++trial) {
    const json certificate = RandomCertificate(random, 1 + trial % 9, 7);
    const auto answer = Check(certificate);
    ASSERT_TRUE(answer.accepted) << answer.why << certificate.dump();
    for (const json& move : certificate["moves"])
      kinds.insert(move["kind"].get<std::string>() + " " + move["direction"].get<std::string>());
  }
  EXPECT_EQ(kinds.size(), 7u);
}

TEST(KnotCertificate, AChangedNumberIsAcceptedJustIfItIsRightAgain) {
  std::mt19937_64 random(32);
  int right = 0, wrong = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const json original = RandomCertificate(random, 3 + trial % 6, 6);
    const json flat = original.flatten();
    for (const auto& [path, value] : flat.items()) {
      if (!value.is_number_integer()) continue;
      const int number = value;
      for (const int changed : {number - 1, number + 1, number ^ 2, -number, 0, 9}) {
        if (changed == number) continue;
        json mutant = original;
        mutant.at(json::json_pointer(path)) = changed;
        const bool expected = mutant["version"] == 1 && oracle::TyingIsRight(mutant);
        const auto answer = Check(mutant);
        ASSERT_EQ(answer.accepted, expected) << path << " " << changed << answer.why << mutant.dump();
        ++(expected ? right : wrong);
      }
    }
  }
  EXPECT_GT(right, 0);
  EXPECT_GT(wrong, 1000);
}

TEST(KnotCertificate, AChangedMoveIsAcceptedJustIfItIsRightAgain) {
  std::mt19937_64 random(33);
  int right = 0, wrong = 0;
  const std::map<std::string, std::vector<json>> words = {{"kind", {"R1", "R2", "R3", "Cross"}},
                                                          {"direction", {"add", "remove", "shift"}},
                                                          {"end", {nullptr, "selective", "other"}},
                                                          {"order", {nullptr, "same", "opposite"}},
                                                          {"attr", {nullptr, 1, 2, 3, 4}}};
  for (int trial = 0; trial < 25; ++trial) {
    const json original = RandomCertificate(random, 2 + trial % 7, 6);
    for (size_t k = 0; k < original["moves"].size(); ++k) {
      for (const auto& [key, values] : words) {
        for (const json& value : values) {
          json mutant = original;
          json& move = mutant["moves"][k];
          if (move[key] == value) continue;
          move[key] = value;
          // Whether an order or an attribute stands where none belongs, the engine's move cannot say.
          const bool fits = (move["kind"] == "R2") == !move["order"].is_null();
          const bool expected = fits && oracle::TyingIsRight(mutant);
          const auto answer = Check(mutant);
          ASSERT_EQ(answer.accepted, expected) << key << value << answer.why << original.dump();
          ++(expected ? right : wrong);
        }
      }
    }
  }
  EXPECT_GT(wrong, 1000);
}

TEST(KnotCertificate, StepsLeftOutOrInAnotherOrderAreRefused) {
  std::mt19937_64 random(34);
  const json original = RandomCertificate(random, 6, 7);
  json mutant = original;
  mutant["p_data"].erase(3);
  EXPECT_NE(Check(mutant).why.find("one P-data more"), std::string::npos);
  mutant["moves"].erase(3);
  EXPECT_FALSE(Check(mutant).accepted);
  mutant = original;
  mutant["p_data"].erase(0);
  mutant["moves"].erase(0);
  EXPECT_NE(Check(mutant).why.find("straight rope"), std::string::npos);
  mutant = original;
  mutant["moves"][2]["selective_end"] = "swapped";
  EXPECT_FALSE(Check(mutant).accepted);
  mutant["moves"][2].erase("selective_end");
  EXPECT_FALSE(Check(mutant).accepted);
}

}  // namespace
}  // namespace tact::provers
