// The ledger itself: which claims there are, and what must come out of each, whatever the code says today.
#include "provers/claims/claims.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "provers/check/check.h"
#include "tests/provers/ledger_once.h"

namespace tact::provers {
namespace {

const std::vector<LedgerEntry>& QuickLedger() { return LedgerOnce(Effort::kQuick); }

struct Expected {
  Verdict verdict;
  const char* why;
};

const std::map<std::string, Expected>& ExpectedVerdicts() {
  constexpr auto kProved = Verdict::kProved, kHoldsTo = Verdict::kHoldsTo, kRefuted = Verdict::kRefuted,
                 kReproduced = Verdict::kReproduced;
  static const std::map<std::string, Expected> expected = {
      {"thesis.2.1.screw-form", {kProved, "the triple product: n . (w x p) = (p x n) . w"}},
      {"thesis.2.1.singular-edges",
       {kRefuted,
        "a union of half-spaces is not convex: legal by one plane at one end, by the other at the other"}},
      {"thesis.2.1.singular-edges-corrected",
       {kHoldsTo,
        "Farkas: one plane between the two serves both ends, or some point between goes against both"}},
      {"thesis.2.2.1.proposition-1", {kHoldsTo, "the span of a projected cone is the projected span"}},
      {"thesis.2.2.1.proposition-2",
       {kHoldsTo, "m_r + d_r = dim V_r, read as dimensions one modulo the other"}},
      {"thesis.2.2.1.axis-types",
       {kRefuted,
        "with one contact, a maintaining rotation plus a translation that leaves has the same axis"}},
      {"thesis.2.2.1.proposition-3", {kHoldsTo, "rank and nullity of the projection to angular parts"}},
      {"thesis.2.2.1.figure-2.2",
       {kHoldsTo, "each round turns one screw of a dependent set into a translation"}},
      {"thesis.2.2.1.not-differences",
       {kProved, "the thesis says 'not always': two contacts that face each other off one line"}},
      {"thesis.2.2.1.proposition-4",
       {kProved, "a cone holds both of s and -s, or one, or none; both types occur"}},
      {"thesis.2.2.1.proposition-5", {kHoldsTo, "3 - rank G is the dimension of the lineality space of V_r"}},
      {"thesis.2.2.1.proposition-6", {kHoldsTo, "what is left of d_r"}},
      {"thesis.2.2.2.sums", {kHoldsTo, "singular DOFs are those of a non-singular relation (2.8)"}},
      {"thesis.2.3.1.sums", {kHoldsTo, "by definition, and maintaining motions are legal"}},
      {"thesis.2.3.ten-kinds", {kProved, "three as an ordered sum of three non-negative numbers: 5 over 2"}},
      {"thesis.2.3.kinds-138",
       {kRefuted, "66 in translation and rotation, by lemmas and witnesses that meet"}},
      {"thesis.2.3.kinds-138-boxes",
       {kProved, "142 less three that boxes cannot have less the empty relation"}},
      {"thesis.2.3.singular-kinds", {kProved, "the others' classes, and ranks between theirs and three"}},
      {"thesis.2.3.transitions-13", {kReproduced, "6 head on, 4 aside, 3 slots"}},
      {"thesis.2.3.1.all-30-appear", {kProved, "fifteen motions, both ways"}},
      {"thesis.2.3.1.practical-20",
       {kProved, "keeping a singular contact; or a turn and two contacts at once"}},
      {"thesis.2.3.1.one-contact", {kHoldsTo, "one row raises one rank by one"}},
      {"thesis.2.3.same-elements", {kRefuted, "two lines of contacts cross or not, by where they are"}},
      {"thesis.2.3.1.seldom",
       {Verdict::kNotReproduced,
        "by a straight motion D -> C cannot occur, and along an edge SM -> SD is common"}},
      {"thesis.2.3.1.straight-motions", {kHoldsTo, "gaps are linear along a line"}},
      {"thesis.2.6.rules-decide",
       {kRefuted, "an edge on an edge laid down flush: SM -> M and D, and no rule"}},
      {"thesis.2.3.2.make-contact-rule",
       {kRefuted, "a wall and a ceiling at once hide each other in the counts"}},
      {"thesis.2.3.2.detach-contact-rule",
       {kRefuted, "the same, backwards; and SD and SM exchange their M and D"}},
      {"thesis.2.3.2.slide-rule",
       {kRefuted, "two walls and a rim at once: M -> SD and D -> SM look like M -> SM"}},
      {"thesis.2.3.2.critical-rule", {kRefuted, "between two walls, off a rim: SC -> C looks like SM -> C"}},
      {"thesis.2.3.2.footnote", {kProved, "r = 3 - m and m + d + c = 3"}},
      {"thesis.2.4.2.accompanied", {kRefuted, "from free space there is no detaching DOF to lose"}},
      {"thesis.2.6.footnote", {kHoldsTo, "with one plane a contact, r = 6 - m in rank"}},
      {"thesis.2.6.third-rule", {kProved, "parallel edges: m = 3 and r = 2, one way to slide, not three"}},
      {"thesis.2.6.restricted-rotation", {kHoldsTo, "rank and nullity again"}},
      {"thesis.2.6.footnote-singular",
       {kRefuted, "a singular contact whose planes other contacts have too adds nothing to r"}},
      {"thesis.2.6.footnote-inequality", {kHoldsTo, "more planes, no less rank"}},
      {"thesis.2.7.3.non-linear-not-always",
       {kReproduced, "steps of least norm may end where elements part"}},
      {"thesis.2.8.3.linear-always", {kReproduced, "a swing and a projection always exist"}},
      {"thesis.2.8.3.table-2.1-linear", {kReproduced, "5/4, 5 pi / 8, 5/2 of a turn uniform to 5 degrees"}},
      {"thesis.2.8.3.table-2.1-non-linear",
       {Verdict::kNotReproduced, "unit, reference point and solids are lost"}},
      {"thesis.2.8.3.noise-average", {Verdict::kNotReproduced, "5 and 10 bound the noise"}},
      {"thesis.2.8.3.below-noise", {kReproduced, "a component is shorter than the whole"}},
      {"thesis.2.8.3.c-equals-noise", {kHoldsTo, "the whole turn is undone"}},
      {"thesis.2.8.3.linear-less", {Verdict::kNotReproduced, "in (C) both turn all of it back"}},
      {"thesis.2.8.3.more-restricted", {kReproduced, "more components are undone"}},
      {"thesis.2.8.3.fails-at-four", {kReproduced, "fewer choices are left"}},
      {"thesis.2.8.3.nearest", {kHoldsTo, "ours"}},
      {"thesis.2.7.4.inclusion", {kHoldsTo, "touching is closed: it lasts to the end of a motion"}},
      {"thesis.2.7.4.inverse", {kProved, "walls on both sides stay in touch"}},
      {"thesis.2.7.4.practical-filter", {kRefuted, "the ten others are motions, too"}},
      {"thesis.2.8.1.insertion-watched", {kReproduced, "small errors leave no doubt"}},
      {"thesis.2.8.2.relations", {kReproduced, "the poses of the example make the eight relations"}},
      {"thesis.2.8.2.transition-1", {kReproduced, "free to one edge on a face"}},
      {"thesis.2.8.2.transition-2", {kReproduced, "the edge slides onto the rim: singular"}},
      {"thesis.2.8.2.transition-3", {kReproduced, "off the rim's edge, into the slot"}},
      {"thesis.2.8.2.transition-4", {kReproduced, "the other rim on the side face"}},
      {"thesis.2.8.2.transition-5", {kReproduced, "upright, both edges on both rims: singular"}},
      {"thesis.2.8.2.transition-6", {kReproduced, "between the walls: critical"}},
      {"thesis.2.8.2.transition-7", {kReproduced, "on the ground"}},
      {"thesis.5.1.3.parts", {kHoldsTo, "interlacement classes nest or follow each other"}},
      {"thesis.5.1.3.connecting", {kRefuted, "a rope from side to side put into a loop takes a torus"}},
      {"thesis.5.1.3.connecting-corrected", {kHoldsTo, "a handle needs two faces at both places"}},
      {"thesis.5.1.3.knot-graph-and-attributes", {kHoldsTo, "e_k leads from column k to k + 1"}},
      {"thesis.5.1.3.proposition-7", {kHoldsTo, "a vertex that parts the graph leaves a closed run"}},
      {"thesis.5.1.3.proposition-8", {kRefuted, "one intersection: three vertices"}},
      {"thesis.5.1.3.proposition-8-corrected", {kHoldsTo, "wheels that share three vertices"}},
      {"thesis.5.1.3.proposition-9", {kRefuted, "parallel edges may be exchanged"}},
      {"thesis.5.1.3.proposition-9-corrected", {kHoldsTo, "two closed curves cross an even number of times"}},
      {"thesis.5.1.3.one-attribute", {kHoldsTo, "it tells one turn"}},
      {"thesis.5.1.3.each-edge-twice", {kHoldsTo, "no edge parts the graph"}},
      {"thesis.5.1.3.caution", {kHoldsTo, "a face turns left at each intersection"}},
      {"thesis.5.1.3.face-search", {kRefuted, "a loop round parts of the rope is shorter than a face"}},
      {"thesis.5.1.3.face-search-corrected", {kHoldsTo, "the pairing tells the turns"}},
      {"thesis.5.1.3.example", {kReproduced, "read off the printed rows"}},
      {"thesis.5.4.1.knot-graph", {kReproduced, "columns in a row"}},
      {"thesis.5.4.1.faces", {kReproduced, "by hand: two digons, two triangles"}},
      {"thesis.5.4.1.external-faces", {kReproduced, "four faces, none alike"}},
      {"thesis.4.2.1.direction", {kRefuted, "a drawer goes out and in"}},
      {"thesis.4.2.2.least-angles", {kRefuted, "a median is not a mean"}},
      {"thesis.4.2.2.covariance", {kRefuted, "deviations from the mean add up to zero"}},
      {"thesis.4.3.2.traces", {kRefuted, "b . (l x b) = 0"}},
      {"thesis.4.4.1.angle-norm", {kRefuted, "270 and 90 degrees have one size"}},
      {"thesis.4.5.1.roll-pitch-yaw", {kRefuted, "a row of the yaw's sine and cosine has lost the pitch's"}},
      {"thesis.4.5.1.roll-pitch-yaw-corrected", {kProved, "three matrices multiplied"}},
      {"thesis.4.2.2.trace", {kProved, "4 w^2 - 1 of the unit quaternion"}},
      {"thesis.4.2.2.least-angles-corrected", {kProved, "6 - 2 Tr R_i^T R"}},
      {"thesis.4.3.2.two-turns", {kProved, "swing and twist"}},
      {"thesis.4.3.2.no-turn-about-the-axis", {kProved, "cosines of halves multiply"}},
      {"thesis.4.3.2.skew-form", {kProved, "Rodrigues"}},
      {"thesis.4.3.2.traces-corrected", {kProved, "l x (l x b) = -b"}},
      {"thesis.4.3.2.cosine", {kProved, "b turns by theta in the plane across l"}},
      {"thesis.4.3.2.rank", {kProved, "a centre may lie anywhere on its axis"}},
      {"thesis.4.5.1.axis-between-two", {kProved, "l_A to l_B and back"}},
      {"thesis.4.6.2.least-turn", {kProved, "along the great circle through l_B"}},
      {"thesis.4.5.2.table-4.1-method-a", {kReproduced, "by the true angles"}},
      {"thesis.4.5.2.table-4.1", {kReproduced, "with conjugate gradients that end a little early"}},
      {"thesis.4.5.2.table-4.2-centre", {kReproduced, "a centre near the origins"}},
      {"thesis.4.5.1.singularities", {kReproduced, "saddles aside, one optimum"}},
      {"thesis.4.5.2.method-a", {kReproduced, "two poses' noise over the sine of the turn"}},
      {"thesis.4.5.2.inverse-to-rotation",
       {Verdict::kNotReproduced, "the sine flattens: sqrt(1 - s^2) of 180 over 90 degrees is 1.77"}},
      {"thesis.4.5.2.inverse-to-rotation-corrected", {kHoldsTo, "first-order errors of least squares"}},
      {"thesis.4.5.2.root-of-poses", {kReproduced, "averages"}},
      {"thesis.4.5.2.table-4.3-b", {kReproduced, "principal components, in degrees"}},
      {"thesis.4.5.2.table-4.3-a",
       {Verdict::kNotReproduced, "an average of 200 orientations does not err by 1.6 degrees"}},
      {"thesis.4.5.2.table-4.3-a-explained", {kReproduced, "two of three angles keep one pose's noise"}},
      {"thesis.4.5.2.a-harder-than-b", {kReproduced, "an error more"}},
      {"thesis.4.5.2.prismatic-scaling", {kReproduced, "a line fitted to points"}},
      {"thesis.4.4.2.small-ratio", {kHoldsTo, "5 mm a radian times 1.7 degrees is 0.15 mm, of 3.3"}},
      {"thesis.4.5.2.table-4.4", {kReproduced, "3.3 mm over sqrt(50 pi^2 / 3), in size 0.21 mm"}},
      {"thesis.4.5.2.screw-insensitive", {kReproduced, "locations' noise along the axis"}},
      {"thesis.4.6.3.success-677", {Verdict::kNotReproduced, "searches that converge succeed more often"}},
      {"thesis.4.6.3.initial-guess",
       {Verdict::kNotReproduced, "the identity leads to the least sum already"}},
      {"thesis.4.5.3.two-part-division", {kReproduced, "points near the pin move with neither part"}},
      {"thesis.5.2.kinds-overlap", {kProved, "a kink of an end segment is thrown by either"}},
      {"thesis.5.3.1.r1-rule", {kHoldsTo, "a loop of one segment is a face of one corner"}},
      {"thesis.5.3.1.several-ways", {kProved, "a second kink before or after the first"}},
      {"thesis.5.3.2.r2-rule", {kRefuted, "a segment laid over itself: i = j"}},
      {"thesis.5.3.2.r2-rule-corrected", {kHoldsTo, "a lens of one strand over the other is a face"}},
      {"thesis.5.3.2.heights-and-signs", {kProved, "a clasp, and a ring with both strands leaving apart"}},
      {"thesis.5.3.2.signs-by-order", {kHoldsTo, "the rope joins both sides of the closed curve"}},
      {"thesis.5.3.2.r2-formula", {kProved, "both orders add up to 2 j + 5"}},
      {"thesis.5.3.2.figure-5.11", {kProved, "two strands woven over each other"}},
      {"thesis.5.3.3.proposition-10", {kHoldsTo, "corners join two sides"}},
      {"thesis.5.3.3.corollary-1", {kProved, "eight of fifteen pairings"}},
      {"thesis.5.3.3.eight-types", {kProved, "each strand meets the two others in one of two orders"}},
      {"thesis.5.3.3.proposition-11", {kHoldsTo, "no column leaves its segment's two ends"}},
      {"thesis.5.3.3.proposition-12", {kHoldsTo, "each strand's two intersections change places"}},
      {"thesis.5.3.3.corollary-2", {kHoldsTo, "both strands' places change"}},
      {"thesis.5.3.3.proposition-13", {kProved, "eight cases"}},
      {"thesis.5.3.3.r3-rule", {kRefuted, "segment n is an inner one, too"}},
      {"thesis.5.3.3.r3-rule-corrected", {kHoldsTo, "what the faces admit"}},
      {"thesis.5.3.3.triangle-is-a-face", {kHoldsTo, "else the exchange would leave the sphere"}},
      {"thesis.5.3.4.cross-rule", {kHoldsTo, "an end's last intersection can always be undone"}},
      {"thesis.5.3.4.cross-or-r1", {kRefuted, "a kink inside a kink"}},
      {"thesis.5.3.5.selective-end", {kRefuted, "the straight rope's ends are alike"}},
      {"thesis.5.3.5.proposition-14", {kProved, "counted from the other end"}},
      {"thesis.5.3.5.proposition-15", {kProved, "two signs change"}},
      {"thesis.5.2.3.every-p-data-is-tied", {kProved, "an end can always go back"}},
      {"thesis.5.2.3.end-crossing-is-cross", {kRefuted, "an end crosses two segments at once"}},
      {"thesis.5.2.3.no-single-move-without-ends", {kProved, "one loop for another takes two R1"}},
      {"thesis.5.2.3.kinds-needed", {kRefuted, "Cross moves alone tie everything"}},
      {"thesis.5.2.3.r3-redundant", {kRefuted, "three R2 and an R3 where five others are needed"}},
      {"thesis.5.2.3.untying-adds-nothing", {kHoldsTo, "nothing hard is as small as this"}},
      {"thesis.5.4.2.bowline", {kReproduced, "the free end crosses seven segments"}},
      {"thesis.5.4.2.wrong-ends", {kReproduced, "P-data and moves read backwards fit neither neighbour"}},
      {"thesis.5.4.2.bow", {kReproduced, "one strand laid over the other, two loops pushed through"}},
      {"thesis.5.4.2.bow-by-cross", {kProved, "an end goes where a loop can"}},
      {"thesis.A.1.rotation-equations", {kHoldsTo, "the combinations span the left null space of N"}},
      {"thesis.A.2.opposite-ways", {kRefuted, "normals that turn into one another lower a rank"}},
      {"thesis.A.3.1.least-translation", {kProved, "Pythagoras"}},
      {"thesis.A.3.2.rank-grows", {kRefuted, "a fourth point of a face restricts nothing new"}},
      {"thesis.A.4.1.least-turn-case-4", {kRefuted, "a turn about a_1 may take more off than it adds"}},
      {"thesis.A.4.2.case-2", {kProved, "swing and twist of a quaternion"}},
      {"thesis.A.4.2.case-3", {kRefuted, "two angles, three dimensions"}},
      {"thesis.A.4.2.case-3-corrected", {kProved, "w x = y z for products of turns about y and z"}},
      {"thesis.A.5.peg-insertion", {kReproduced, "the example was built so that each transition is one"}},
      {"thesis.A.6.1.only-two-axes", {kProved, "2 a b / norm"}},
      {"thesis.A.6.1.order", {kProved, "the second axis stays, the first is carried"}},
      {"thesis.A.6.1.least-turn", {kRefuted, "the axis depends on the end that is given"}},
      {"thesis.A.6.1.rank-one", {kRefuted, "an edge on the floor, its end at a wall"}},
      {"thesis.A.6.2.surface-normal", {kProved, "rotations keep angles"}},
      {"thesis.A.6.3.turned", {kReproduced, "A.6.1 and A.6.2 apply"}}};
  return expected;
}

TEST(Claims, EachComesOutAsItMustAndNoneIsUndecided) {
  std::set<std::string> tried;
  for (const LedgerEntry& entry : QuickLedger()) {
    tried.insert(entry.claim.id);
    const auto expected = ExpectedVerdicts().find(entry.claim.id);
    if (expected == ExpectedVerdicts().end()) {
      ADD_FAILURE() << "say in the table what must come out of " << entry.claim.id;
      continue;
    }
    EXPECT_EQ(ToString(entry.outcome.verdict), ToString(expected->second.verdict))
        << entry.claim.id << ": " << expected->second.why << "\n"
        << entry.outcome.evidence;
    EXPECT_FALSE(entry.outcome.bound.empty()) << entry.claim.id;
    EXPECT_FALSE(entry.outcome.evidence.empty()) << entry.claim.id;
  }
  for (const auto& [id, expected] : ExpectedVerdicts()) EXPECT_TRUE(tried.contains(id)) << id;
}

TEST(Claims, AnIdIsUniqueAndNamesTheSectionOfItsSource) {
  const std::regex form("thesis\\.((?:[0-9]+|[A-Z])(?:\\.[0-9]+)*)\\.([a-zA-Z][a-zA-Z0-9.-]*)");
  const std::set<std::string> methods = {"symbolic", "exhaustive", "property", "statistics", "simulation"};
  std::set<std::string> ids;
  for (const Claim& claim : AllClaims()) {
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(claim.id, parts, form)) << claim.id;
    const std::string section = parts[1];
    EXPECT_TRUE(std::regex_search(claim.source, std::regex("^" + section + "($|,| )")))
        << claim.id << " is said to be of " << claim.source;
    EXPECT_TRUE(methods.contains(claim.method)) << claim.id << ": " << claim.method;
    EXPECT_TRUE(claim.statement.ends_with(".")) << claim.id;
  }
}

TEST(Claims, TheSevenTransitionsComeInTheirOrder) {
  const auto claims = PegInsertionClaims();
  ASSERT_EQ(claims.size(), 8u);
  for (size_t t = 1; t < claims.size(); ++t) {
    EXPECT_EQ(claims[t].id, "thesis.2.8.2.transition-" + std::to_string(t));
    EXPECT_EQ(claims[t].source, "2.8.2, transition (" + std::to_string(t) + ")");
  }
}

TEST(Claims, EveryCertificateIsAboutItsClaimAndBearsItsName) {
  for (const LedgerEntry& entry : QuickLedger()) {
    for (const Certificate& certificate : entry.outcome.certificates) {
      EXPECT_EQ(nlohmann::json::parse(certificate.json)["claim"], entry.claim.id);
      EXPECT_EQ(check::CheckCertificate(certificate.json).claim, entry.claim.id);
      EXPECT_TRUE(certificate.name.starts_with(entry.claim.id)) << certificate.name;
    }
  }
}

TEST(Claims, EveryRefutationAndEveryProofHasEvidenceACheckerCanRead) {
  for (const LedgerEntry& entry : QuickLedger()) {
    const Verdict verdict = entry.outcome.verdict;
    if (verdict == Verdict::kRefuted) {
      EXPECT_FALSE(entry.outcome.certificates.empty()) << entry.claim.id;
    }
    if (verdict == Verdict::kProved && entry.outcome.certificates.empty()) {
      // An identity, a statement about kinds whose scenes are certified with the thirty, and a rope's finite cases and
      // lines of arithmetic.
      const std::set<std::string> known = {"thesis.2.1.screw-form",       "thesis.2.3.1.practical-20",
                                           "thesis.5.3.2.r2-formula",     "thesis.5.3.3.corollary-1",
                                           "thesis.5.3.3.eight-types",    "thesis.5.3.3.proposition-13",
                                           "thesis.5.3.5.proposition-14", "thesis.5.3.5.proposition-15"};
      EXPECT_TRUE(known.contains(entry.claim.id)) << entry.claim.id;
    }
  }
}

TEST(FullClaims, TheVerdictsDoNotDependOnTheEffort) {
  for (const LedgerEntry& entry : LedgerOnce(Effort::kStandard))
    EXPECT_EQ(ToString(entry.outcome.verdict), ToString(ExpectedVerdicts().at(entry.claim.id).verdict))
        << entry.claim.id;
}

}  // namespace
}  // namespace tact::provers
