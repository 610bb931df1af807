/// @file
/// Closures and codes of random ropes read by Regina: every notation must name one and the same knot diagram.
/// Model   A rope is closed over and under. Its signed Gauss code (Link::fromData), its oriented Gauss code and its PD code
///         must have one knot signature, in which neither reflection nor reversal is forgotten; its DT code, if the
///         diagram is irreducible, the same or that of the mirror image.
#include <link/link.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "algebra/knot/dt_code.h"
#include "algebra/knot/pd_code.h"
#include "algebra/knot/reducible.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::oracle {
namespace {

using knot::ClosedCode;
using regina::Link;

struct Tally {
  uint64_t closures = 0, dt_codes = 0, differences = 0, crossings = 0;

  void Expect(bool agrees, const ClosedCode& closed, const char* what) {
    if (!agrees && ++differences <= 5) std::cout << what << " differs: " << closed.cut.ToJson() << "\n";
  }
};

std::string Signature(const Link& link) { return link.knotSig(false, false); }

std::string MirroredSignature(Link link) {
  link.reflect();
  return Signature(link);
}

void Compare(const ClosedCode& closed, Tally& tally) {
  const knot::GaussCode gauss = closed.Gauss();
  const std::vector<std::vector<int>> components = {gauss.passes};
  const Link link =
      Link::fromData(gauss.signs.begin(), gauss.signs.end(), components.begin(), components.end());
  const std::string signature = Signature(link);
  ++tally.closures;
  tally.crossings += link.size();
  tally.Expect(link.size() == static_cast<size_t>(closed.cut.crossings()), closed, "size");
  tally.Expect(link.writhe() == std::accumulate(gauss.signs.begin(), gauss.signs.end(), 0L), closed,
               "writhe");
  tally.Expect(Signature(Link::fromOrientedGauss(closed.OrientedGauss())) == signature, closed,
               "oriented Gauss code");
  // One intersection: a PD code leaves the orientation open.
  if (closed.cut.crossings() > 1)
    tally.Expect(Signature(Link::fromPD(ToText(knot::ClosedPdCodeOf(closed.cut)))) == signature, closed,
                 "PD code");
  if (!knot::IsIrreducible(closed.cut)) return;
  ++tally.dt_codes;
  const std::vector<int> dt = DtCodeOf(closed);
  const Link by_dt = Link::fromDT(dt.begin(), dt.end());
  tally.Expect(Signature(by_dt) == signature || MirroredSignature(by_dt) == signature, closed, "DT code");
}

int Run(uint64_t ropes, uint64_t seed) {
  std::mt19937_64 random(seed);
  Tally tally;
  for (uint64_t rope = 0; rope < ropes; ++rope) {
    const knot::PData p = knot::RandomPData(random, 1 + static_cast<int>(random() % 12));
    for (const knot::Pass pass : {knot::Pass::kOver, knot::Pass::kUnder})
      Compare(knot::Close(p, pass), tally);
  }
  std::cout << tally.closures << " closures of " << ropes << " ropes, " << tally.crossings << " crossings, "
            << tally.dt_codes << " DT codes, " << tally.differences << " differences\n";
  return tally.differences == 0 && tally.dt_codes > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::oracle

int main(int argc, char** argv) {
  try {
    uint64_t ropes = 1000, seed = 1;
    for (int i = 1; i < argc; i += 2) {
      const std::string name = argv[i];
      if ((name != "--ropes" && name != "--seed") || i + 1 == argc) {
        throw std::invalid_argument("expected --ropes N or --seed S, got " + name);
      }
      (name == "--ropes" ? ropes : seed) = std::stoull(argv[i + 1]);
    }
    return tact::oracle::Run(ropes, seed);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
