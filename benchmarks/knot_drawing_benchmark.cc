/// @file
/// P-data drawn with exact coordinates and read back, at 8 to 30 intersections; and round trips of whole worlds.
/// Model   Random ropes, any face outside; a time is the median over ropes, the slowest is printed beside it. Parts: the embedding alone,
///         the whole drawing, the reading. Each drawing has to give its P-data again. Times are the process' own, on its one thread:
///         other programs on the machine do not count.
/// Worlds  --codes N all codes of up to N intersections, heights alternating over the codes; --p-data N all P-data of up to N;
///         --random N so many ropes of 12 to 30; --every K takes each K-th of them, from the first.
/// Exit    0; 1 if a drawing gives other P-data, or with --require MS if drawing and reading at 30 take longer.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "algebra/knot/curve_views.h"
#include "algebra/knot/exact_drawing.h"
#include "benchmarks/random_rope.h"
#include "enumerators/planar_p_data.h"

namespace tact::benchmarks {
namespace {

using knot::PData;

struct Options {
  double require = 0;  // milliseconds; 0: none
  int codes = -1, p_data = -1;
  long random = 0, every = 1;
};

double Milliseconds(std::clock_t since) {
  return 1000 * static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC;
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool ReadsAs(const knot::Curve& curve, const PData& p) {
  const auto read = knot::ProjectCurve(curve, knot::ViewFromAbove());
  const auto* projection = std::get_if<knot::CurveProjection>(&read);
  return projection != nullptr && projection->p == p;
}

// Milliseconds of drawing and reading together.
double PrintSize(int crossings, int ropes, bool& good) {
  Random random(static_cast<uint64_t>(crossings));
  std::vector<double> embed, draw, read, both;
  int wrong = 0;
  for (int k = 0; k < ropes; ++k) {
    const PData p = RandomRope(random, crossings);
    const int outer = Below(random, crossings + 1);
    auto start = std::clock();
    EmbedTriangulation(TriangulateDiagram(p, outer));
    embed.push_back(Milliseconds(start));
    start = std::clock();
    const knot::Curve curve = DrawExactly(p, outer);
    draw.push_back(Milliseconds(start));
    start = std::clock();
    wrong += ReadsAs(curve, p) ? 0 : 1;
    read.push_back(Milliseconds(start));
    both.push_back(draw.back() + read.back());
  }
  std::printf("%3d intersections  embed %7.2f  draw %7.2f  read %7.2f  both %7.2f ms  slowest %7.2f%s\n",
              crossings, Median(embed), Median(draw), Median(read), Median(both),
              *std::max_element(both.begin(), both.end()), wrong == 0 ? "" : "  WRONG");
  good &= wrong == 0;
  return Median(both);
}

class World {
 public:
  explicit World(long every) : every_(every) {}

  // The face outside goes through all faces in turn.
  void Visit(const PData& p) {
    if (seen_++ % every_ != 0) return;
    const int outer = static_cast<int>(drawn_++ % (p.crossings() + 1));
    wrong_ += ReadsAs(DrawExactly(p, outer), p) ? 0 : 1;
  }
  bool Print(const std::string& what) const {
    std::printf("%-36s %ld of %ld drawn, %ld read otherwise, %.1f s\n", what.c_str(), drawn_, seen_, wrong_,
                Milliseconds(start_) / 1000);
    return wrong_ == 0;
  }
  bool Takes() const { return seen_ % every_ == 0; }
  void Skip() { ++seen_; }

 private:
  long every_, seen_ = 0, drawn_ = 0, wrong_ = 0;
  std::clock_t start_ = std::clock();
};

bool PrintWorlds(const Options& options) {
  bool good = true;
  for (int n = 0; n <= options.codes; ++n) {
    World world(options.every);
    enumerators::ForEachCode(n, [&](const enumerators::Code& code) {
      // Making P-data of a code takes longer than the next code.
      if (world.Takes()) {
        world.Visit(WithHeights(code, 0x55555555u & ((uint32_t{1} << n) - 1)));
      } else {
        world.Skip();
      }
    });
    good &= world.Print("codes of " + std::to_string(n));
  }
  for (int n = 0; n <= options.p_data; ++n) {
    World world(options.every);
    enumerators::ForEachPlanarPData(n, [&](const PData& p) { world.Visit(p); });
    good &= world.Print("P-data of " + std::to_string(n));
  }
  if (options.random > 0) {
    World world(1);
    Random random(1);
    for (long k = 0; k < options.random; ++k) world.Visit(RandomRope(random, 12 + Below(random, 19)));
    good &= world.Print("random ropes of 12 to 30");
  }
  return good;
}

int Run(const Options& options) {
  bool good = true;
  double at_30 = 0;
  for (const int crossings : {8, 12, 20, 30}) at_30 = PrintSize(crossings, 60, good);
  good &= PrintWorlds(options);
  if (options.require > 0 && at_30 > options.require) {
    std::printf("expected at most %.1f ms at 30 intersections, got %.1f\n", options.require, at_30);
    good = false;
  }
  return good ? 0 : 1;
}

}  // namespace
}  // namespace tact::benchmarks

int main(int argc, char** argv) {
  tact::benchmarks::Options options;
  try {
    for (int i = 1; i < argc; i += 2) {
      const std::string name = argv[i];
      if (i + 1 == argc) throw std::invalid_argument("expected a number after " + name);
      const char* const value = argv[i + 1];
      if (name == "--require") {
        options.require = std::strtod(value, nullptr);
      } else if (name == "--codes") {
        options.codes = static_cast<int>(std::strtol(value, nullptr, 10));
      } else if (name == "--p-data") {
        options.p_data = static_cast<int>(std::strtol(value, nullptr, 10));
      } else if (name == "--random") {
        options.random = std::strtol(value, nullptr, 10);
      } else if (name == "--every") {
        options.every = std::max(1L, std::strtol(value, nullptr, 10));
      } else {
        throw std::invalid_argument("expected --require, --codes, --p-data, --random or --every, got " +
                                    name);
      }
    }
    return tact::benchmarks::Run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
