/// @file
/// All motion DOFs of a contact relation by tact, timed against the dimension and generators of the same cone
/// by PPL and cddlib, with the answers compared in the same run.
/// Model   Blocks of different cones; each block goes to every tool in turn, so that a slow moment of the
///         machine hits all of them. A ratio is taken within a block; medians over the blocks are printed.
///         tact is timed from the relation's rationals on, the others from ready integer rows.
/// Exit    0; 1 if an answer differs, a warm 64-bit call allocates, or a ratio asked for is missed.
#include <gmp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "algebra/cone/dual_simplex.h"
#include "algebra/contact/contact_rows.h"
#include "algebra/contact/motion_dof.h"
#include "benchmarks/allocation_count.h"
#include "benchmarks/cone_peers.h"

namespace tact::benchmarks {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::Integer;
using algebra::MotionDof;
using algebra::MotionDofEngine;
using algebra::Rational;
using algebra::Vector3;
using Rows = std::vector<int64_t>;

constexpr std::array kCounts{4, 8, 16, 32};
constexpr size_t kBlock = 16;
// cddlib needs tens of milliseconds for a large cone: it sees only the first few of a block.
constexpr size_t kBlockOfCdd = 2;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  int Int(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }

 private:
  std::mt19937 engine_;
};

// Points to half a millimetre on one to three faces of a box of some centimetres; now and then a chamfer.
ContactRelation ContactLike(Random& random, int contacts) {
  const std::array<int, 3> half_size{random.Int(10, 60), random.Int(10, 60), random.Int(10, 60)};
  const int faces = random.Int(1, 3);
  std::array<std::pair<int, int>, 3> chosen;
  for (auto& [axis, side] : chosen) axis = random.Int(0, 2), side = random.Int(0, 1) == 0 ? -1 : 1;
  ContactRelation relation;
  for (int i = 0; i < contacts; ++i) {
    const auto [axis, side] = chosen[static_cast<size_t>(random.Int(0, faces - 1))];
    Vector3 point, normal;
    for (int k = 0; k < 3; ++k) {
      const int half = half_size[static_cast<size_t>(k)];
      point[k] = Rational(Integer(random.Int(-half, half)), Integer(2));
    }
    point[axis] = Rational(Integer(side * half_size[static_cast<size_t>(axis)]), Integer(2));
    normal[axis] = -side;
    if (random.Int(1, 10) == 1) normal[(axis + 1) % 3] = random.Int(0, 1) == 0 ? -1 : 1;
    relation.contacts.push_back({point, {normal}, ""});
  }
  return relation;
}

// Points and normals without any plan.
ContactRelation RandomContacts(Random& random, int contacts) {
  ContactRelation relation;
  while (relation.contacts.size() < static_cast<size_t>(contacts)) {
    const auto draw = [&random] { return Vector3{random.Int(-9, 9), random.Int(-9, 9), random.Int(-9, 9)}; };
    const Contact contact{draw(), {draw()}, ""};
    if (!contact.planes[0].IsZero()) relation.contacts.push_back(contact);
  }
  return relation;
}

// Six integers each that need not be a contact's.
Rows RandomRows(Random& random, int count) {
  Rows rows;
  for (int i = 0; i < 6 * count; ++i) rows.push_back(random.Int(-9, 9));
  for (size_t i = 0; i < rows.size(); i += 6) {
    if (std::all_of(&rows[i], &rows[i] + 6, [](int64_t a) { return a == 0; })) rows[i] = 1;
  }
  return rows;
}

struct Block {
  std::vector<ContactRelation> relations;  // empty: bare rows
  std::vector<Rows> rows;
};

Block RelationBlock(Random& random, int count, ContactRelation (*draw)(Random&, int)) {
  Block block;
  for (size_t i = 0; i < kBlock; ++i) {
    block.relations.push_back(draw(random, count));
    algebra::ContactRows rows;
    rows.Assign(block.relations.back());
    if (!rows.is_small()) throw std::logic_error("a benchmark row beyond 64 bits");
    block.rows.push_back(rows.small());
  }
  return block;
}

Block RowBlock(Random& random, int count) {
  Block block;
  for (size_t i = 0; i < kBlock; ++i) block.rows.push_back(RandomRows(random, count));
  return block;
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Microseconds a call, and the answers.
template <typename Answer, typename Call>
double Time(size_t calls, std::vector<Answer>& answers, Call call) {
  answers.resize(calls);
  const auto start = std::chrono::steady_clock::now();
  for (size_t i = 0; i < calls; ++i) answers[i] = call(i);
  const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>(calls);
}

ConeSize SizeFrom(const MotionDof& dof) { return {6 - dof.all.constraining, dof.all.maintaining}; }

class Tact {
 public:
  double TimeBlock(const Block& block, std::vector<ConeSize>& sizes) {
    if (block.relations.empty()) {
      return Time(block.rows.size(), sizes, [&](size_t i) { return Size(block.rows[i]); });
    }
    const double time =
        Time(block.relations.size(), dofs_, [&](size_t i) { return engine_.Compute(block.relations[i]); });
    sizes.clear();
    for (const MotionDof& dof : dofs_) sizes.push_back(SizeFrom(dof));
    return time;
  }
  size_t overflows() const { return engine_.overflows() + overflows_; }

 private:
  ConeSize Size(const Rows& rows) {
    if (simplex_.Solve(rows.data(), rows.size() / 6, 6, 6) == Simplex::Status::kDone) {
      return {6 - simplex_.vanishing_rank(), 6 - simplex_.rank()};
    }
    ++overflows_;
    std::vector<Integer> large;
    for (const int64_t entry : rows) large.emplace_back(static_cast<long>(entry));
    algebra::DualSimplex<Integer> simplex;
    simplex.Solve(large.data(), rows.size() / 6, 6, 6);
    return {6 - simplex.vanishing_rank(), 6 - simplex.rank()};
  }

  using Simplex = algebra::DualSimplex<int64_t>;
  MotionDofEngine engine_;
  Simplex simplex_;
  std::vector<MotionDof> dofs_;
  size_t overflows_ = 0;
};

struct Result {
  double tact = 0, ppl = 0, cdd = 0;  // microseconds
  double ppl_ratio = 0, cdd_ratio = 0;
  size_t differences = 0, allocations = 0, overflows = 0, cones = 0;
};

Result Measure(const std::function<Block()>& draw, size_t blocks) {
  Result result;
  Tact tact;
  std::vector<double> tact_times, ppl_times, cdd_times, ppl_ratios, cdd_ratios;
  std::vector<ConeSize> sizes, ppl_sizes, cdd_sizes;
  for (size_t b = 0; b < blocks; ++b) {
    const Block block = draw();
    tact.TimeBlock(block, sizes);  // warm
    const size_t overflows = tact.overflows();
    const size_t before = AllocationCount();
    const double tact_time = tact.TimeBlock(block, sizes);  // sizes has its room from the warm call
    const size_t allocations = AllocationCount() - before;
    tact_times.push_back(tact_time);
    if (tact.overflows() == overflows) result.allocations += allocations;
    result.overflows += tact.overflows() - overflows;

    ppl_times.push_back(
        Time(block.rows.size(), ppl_sizes, [&](size_t i) { return SizeByPpl(block.rows[i]); }));
    ppl_ratios.push_back(ppl_times.back() / tact_times.back());
    result.differences += ppl_sizes != sizes;
    if (b % 4 == 0) {
      cdd_times.push_back(Time(kBlockOfCdd, cdd_sizes, [&](size_t i) { return SizeByCdd(block.rows[i]); }));
      cdd_ratios.push_back(cdd_times.back() / tact_times.back());
      result.differences += !std::equal(cdd_sizes.begin(), cdd_sizes.end(), sizes.begin());
    }
    result.cones += block.rows.size();
  }
  result.tact = Median(tact_times);
  result.ppl = Median(ppl_times);
  result.cdd = Median(cdd_times);
  result.ppl_ratio = Median(ppl_ratios);
  result.cdd_ratio = Median(cdd_ratios);
  return result;
}

// A counter that misses operator new or GMP would report zero for anything.
void RequireCounterSees() {
  size_t before = AllocationCount();
  mpz_t number;
  mpz_init_set_ui(number, 1);
  mpz_mul_2exp(number, number, 1000);
  const size_t by_gmp = AllocationCount() - before;
  mpz_clear(number);
  before = AllocationCount();
  std::vector<std::string> strings(100, std::string(100, 'x'));
  if (by_gmp == 0 || AllocationCount() - before < 100)
    throw std::logic_error("the allocation counter is blind");
}

struct Options {
  size_t blocks = 60;
  double required_ratio = 0;  // PPL / tact on contact-like cones of 8 and 32 rows
};

Options ParseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    const double value = i + 1 < argc ? std::atof(argv[i + 1]) : 0;
    if (name == "--blocks" && value >= 1) {
      options.blocks = static_cast<size_t>(value);
    } else if (name == "--require" && value > 0) {
      options.required_ratio = value;
    } else {
      throw std::invalid_argument("expected --blocks N or --require RATIO, got " + name);
    }
  }
  return options;
}

int Run(const Options& options) {
  RequireCounterSees();
  std::printf("%-16s %5s %7s %9s %9s %10s %9s %9s %12s %9s\n", "cones", "rows", "count", "tact us", "PPL us",
              "cdd us", "PPL/tact", "cdd/tact", "allocations", "overflows");
  bool good = true;
  for (const std::string kind : {"contact-like", "random contacts", "random rows"}) {
    for (const int count : kCounts) {
      Random random(static_cast<unsigned>(count));
      const Result r = Measure(
          [&] {
            if (kind == "random rows") return RowBlock(random, count);
            return RelationBlock(random, count, kind == "contact-like" ? ContactLike : RandomContacts);
          },
          options.blocks);
      std::printf("%-16s %5d %7zu %9.2f %9.1f %10.1f %9.1f %9.1f %12zu %9zu\n", kind.c_str(), count, r.cones,
                  r.tact, r.ppl, r.cdd, r.ppl_ratio, r.cdd_ratio, r.allocations, r.overflows);
      if (r.differences > 0) std::printf("  %zu blocks with different answers\n", r.differences);
      if (r.allocations > 0) std::printf("  a warm call allocated\n");
      const bool slow =
          kind == "contact-like" && (count == 8 || count == 32) && r.ppl_ratio < options.required_ratio;
      if (slow) std::printf("  PPL/tact is below %.1f\n", options.required_ratio);
      good = good && r.differences == 0 && r.allocations == 0 && !slow;
    }
  }
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::benchmarks

int main(int argc, char** argv) {
  try {
    return tact::benchmarks::Run(tact::benchmarks::ParseOptions(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
