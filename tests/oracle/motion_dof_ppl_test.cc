/// @file
/// The motion DOFs of random contact relations, compared with what PPL's polyhedra say.
/// Model   The DOFs are read off the thesis' definitions, not off tact's formulas: K = { A V >= 0 } and
///         T = { N v >= 0 } are polyhedra, V_r is the projection of K, M the projection of { A V = 0 };
///         detaching type I is what the largest linear space in V_r has more than M [thesis, eq. (2.3),
///         (2.4), Prop. 1-6].
/// Exact   PPL computes in GMP integers.
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <numeric>
#include <ppl.hh>
#include <set>
#include <string>

#include "algebra/contact/motion_dof.h"
#include "tests/oracle/random_relation.h"

namespace tact::oracle {
namespace {

namespace ppl = Parma_Polyhedra_Library;
using algebra::Contact;
using algebra::ContactRelation;
using algebra::MotionDof;
using algebra::Vector3;

// An integer multiple of (v, 1).
struct Homogeneous {
  long x, y, z, w;
};

Homogeneous Integers(const Vector3& v) {
  long w = 1;
  for (int i = 0; i < 3; ++i) w = std::lcm(w, v[i].denominator().small());
  const auto scaled = [&](int i) { return v[i].numerator().small() * (w / v[i].denominator().small()); };
  return {scaled(0), scaled(1), scaled(2), w};
}

// a . V in coordinates w1 w2 w3 v1 v2 v3, or its last half in coordinates v1 v2 v3.
ppl::Linear_Expression Row(const Contact& contact, const Vector3& normal, bool translation) {
  const Homogeneous p = Integers(contact.point);
  const Homogeneous n = Integers(normal);
  const long row[6] = {
      p.y * n.z - p.z * n.y, p.z * n.x - p.x * n.z, p.x * n.y - p.y * n.x, p.w * n.x, p.w * n.y, p.w * n.z};
  const int first = translation ? 3 : 0;
  ppl::Linear_Expression expression;
  expression.set_space_dimension(6 - first);
  for (int i = first; i < 6; ++i)
    expression.set_coefficient(ppl::Variable(i - first), ppl::Coefficient(row[i]));
  return expression;
}

enum class Sense { kLegal, kKept };  // >= 0, = 0

ppl::C_Polyhedron Motions(const ContactRelation& relation, Sense sense, bool translation) {
  ppl::Constraint_System system;
  for (const Contact& contact : relation.contacts) {
    for (const Vector3& normal : contact.planes) {
      const ppl::Linear_Expression row = Row(contact, normal, translation);
      system.insert(sense == Sense::kLegal ? ppl::Constraint(row >= 0) : ppl::Constraint(row == 0));
    }
  }
  system.set_space_dimension(translation ? 3 : 6);
  return ppl::C_Polyhedron(system, ppl::Recycle_Input());
}

int Dimension(const ppl::C_Polyhedron& p) { return static_cast<int>(p.affine_dimension()); }

int Lineality(const ppl::C_Polyhedron& p) {
  const ppl::Generator_System& generators = p.minimized_generators();
  return static_cast<int>(std::count_if(generators.begin(), generators.end(),
                                        [](const ppl::Generator& g) { return g.is_line(); }));
}

int RotationDimension(ppl::C_Polyhedron p) {
  p.remove_higher_space_dimensions(3);
  return Dimension(p);
}

MotionDof ByPolyhedra(const ContactRelation& relation) {
  MotionDof dof;
  dof.singular = relation.singular();
  const ContactRelation plain = relation.WithoutSingular();

  const ppl::C_Polyhedron translations = Motions(plain, Sense::kLegal, true);
  dof.translation.maintaining = Lineality(translations);
  dof.translation.constraining = 3 - Dimension(translations);
  dof.translation.detaching = 3 - dof.translation.maintaining - dof.translation.constraining;

  const ppl::C_Polyhedron motions = Motions(plain, Sense::kLegal, false);
  dof.all.maintaining = Lineality(motions);
  dof.all.constraining = 6 - Dimension(motions);
  dof.all.detaching = 6 - dof.all.maintaining - dof.all.constraining;

  ppl::C_Polyhedron rotations = motions;
  rotations.remove_higher_space_dimensions(3);
  const ppl::C_Polyhedron kept = Motions(plain, Sense::kKept, false);
  dof.rotation.maintaining = RotationDimension(kept);
  dof.rotation.constraining = 3 - Dimension(rotations);
  dof.rotation.detaching = 3 - dof.rotation.maintaining - dof.rotation.constraining;
  dof.rotation.detaching_type1 = Lineality(rotations) - dof.rotation.maintaining;
  dof.rotation.detaching_type2 = dof.rotation.detaching - dof.rotation.detaching_type1;

  const ppl::C_Polyhedron every_kept = dof.singular ? Motions(relation, Sense::kKept, false) : kept;
  dof.translation.restricted = 3 - Dimension(Motions(relation, Sense::kKept, true));
  dof.all.restricted = 6 - Dimension(every_kept);
  dof.rotation.restricted = 3 - RotationDimension(every_kept);
  return dof;
}

std::string ToString(const MotionDof& d) {
  const auto kinds = [](int m, int dt, int c, int r) {
    return std::to_string(m) + " " + std::to_string(dt) + " " + std::to_string(c) + " restricted " +
           std::to_string(r);
  };
  return std::string(d.singular ? "singular; " : "") + "translation " +
         kinds(d.translation.maintaining, d.translation.detaching, d.translation.constraining,
               d.translation.restricted) +
         "; rotation " +
         kinds(d.rotation.maintaining, d.rotation.detaching, d.rotation.constraining, d.rotation.restricted) +
         " type I " + std::to_string(d.rotation.detaching_type1) + " II " +
         std::to_string(d.rotation.detaching_type2) + "; all " +
         kinds(d.all.maintaining, d.all.detaching, d.all.constraining, d.all.restricted);
}

bool Differs(const ContactRelation& relation) {
  return algebra::ComputeMotionDof(relation) != ByPolyhedra(relation);
}

// No contact can go without the difference going too.
ContactRelation Shrink(ContactRelation relation) {
  for (size_t i = 0; i < relation.contacts.size();) {
    ContactRelation smaller = relation;
    smaller.contacts.erase(smaller.contacts.begin() + static_cast<long>(i));
    if (Differs(smaller)) {
      relation = smaller;
      i = 0;
    } else {
      ++i;
    }
  }
  return relation;
}

void PrintDifference(uint64_t index, const ContactRelation& found) {
  const ContactRelation relation = Shrink(found);
  std::cout << "relation " << index << ", shrunk to " << relation.contacts.size() << " contacts:\n";
  for (const Contact& contact : relation.contacts) {
    std::cout << "  point " << algebra::ToString(contact.point) << " planes";
    for (const Vector3& n : contact.planes) std::cout << " " << algebra::ToString(n);
    std::cout << "\n";
  }
  std::cout << "  tact: " << ToString(algebra::ComputeMotionDof(relation))
            << "\n  PPL:  " << ToString(ByPolyhedra(relation)) << "\n";
}

struct Options {
  uint64_t relations = 20000, seed = 1, shard = 1, shards = 1;
};

Options ParseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string name = argv[i];
    char* end = nullptr;
    const uint64_t value = std::strtoull(argv[i + 1], &end, 10);
    if (name == "--relations") {
      options.relations = value;
    } else if (name == "--seed") {
      options.seed = value;
    } else if (name == "--shard" && *end == '/') {
      options.shard = value;
      options.shards = std::strtoull(end + 1, &end, 10);
    } else {
      throw std::invalid_argument("expected --relations N, --seed S or --shard I/N, got " + name);
    }
    if (*end != '\0') throw std::invalid_argument(name + ": expected a number, got " + argv[i + 1]);
  }
  if (options.shard < 1 || options.shard > options.shards) throw std::invalid_argument("no such shard");
  return options;
}

int Run(const Options& options) {
  constexpr int kMostPrinted = 5;
  uint64_t differences = 0, singular = 0, type1 = 0, type2 = 0, fixed = 0;
  std::set<MotionDof> classes;
  for (uint64_t i = 0; i < options.relations; ++i) {
    const uint64_t index = i * options.shards + options.shard - 1;
    const ContactRelation relation = RandomRelation(options.seed, index);
    const MotionDof expected = ByPolyhedra(relation);
    if (algebra::ComputeMotionDof(relation) != expected && ++differences <= kMostPrinted) {
      PrintDifference(index, relation);
    }
    singular += expected.singular;
    type1 += expected.rotation.detaching_type1 > 0;
    type2 += expected.rotation.detaching_type2 > 0;
    fixed += expected.all.constraining == 6;
    classes.insert(expected);
  }
  std::cout << options.relations << " relations (" << singular << " singular, " << type1 << " with type I, "
            << type2 << " with type II, " << fixed << " without motion, " << classes.size()
            << " different answers), " << differences << " differences\n";
  // A generator gone dull would make agreement worthless.
  const bool varied = options.relations < 1000 ||
                      (singular > 0 && type1 > 0 && type2 > 0 && fixed > 0 && classes.size() >= 100);
  if (!varied) std::cout << "the relations lack variety\n";
  return differences == 0 && varied ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::oracle

int main(int argc, char** argv) {
  try {
    return tact::oracle::Run(tact::oracle::ParseOptions(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
