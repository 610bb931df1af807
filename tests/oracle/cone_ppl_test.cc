/// @file
/// Random cones compared with PPL's polyhedra: dimension, lineality space, rays, facets and a projection.
/// Model   Both sides are brought to one form: subspaces to their echelon basis, rays and facets to their primitive
///         representatives modulo the subspace, in lexicographic order.
/// Exact   PPL computes in GMP integers.
#include <cstdlib>
#include <exception>
#include <iostream>
#include <ppl.hh>
#include <set>
#include <stdexcept>
#include <string>

#include "algebra/cone/cone.h"
#include "algebra/exact/linear_algebra.h"
#include "tests/oracle/random_cone.h"
#include "tests/oracle/random_relation.h"

namespace tact::oracle {
namespace {

namespace ppl = Parma_Polyhedra_Library;
using algebra::ConeForms;
using algebra::EchelonBasis;
using algebra::GeneratorCone;
using algebra::HalfspaceCone;
using algebra::Integer;
using algebra::IntegerMatrix;
using algebra::IntegerVector;

ppl::Linear_Expression Expression(std::span<const Integer> row) {
  ppl::Linear_Expression expression;
  expression.set_space_dimension(row.size());
  for (size_t j = 0; j < row.size(); ++j) {
    ppl::Coefficient entry;
    row[j].GetMpz(entry.get_mpz_t());
    expression.set_coefficient(ppl::Variable(j), entry);
  }
  return expression;
}

template <typename Row>  // a constraint or a generator
IntegerVector Entries(const Row& row, size_t columns) {
  IntegerVector entries;
  for (size_t j = 0; j < columns; ++j) {
    const ppl::Coefficient entry = row.coefficient(ppl::Variable(j));
    entries.push_back(Integer::FromMpz(entry.get_mpz_t()));
  }
  return entries;
}

ppl::C_Polyhedron Polyhedron(const HalfspaceCone& cone) {
  ppl::C_Polyhedron result(cone.ambient_dimension());
  for (size_t i = 0; i < cone.inequalities.rows; ++i) {
    result.add_constraint(Expression(cone.inequalities.row(i)) >= 0);
  }
  for (size_t i = 0; i < cone.equalities.rows; ++i) {
    result.add_constraint(Expression(cone.equalities.row(i)) == 0);
  }
  return result;
}

// The subspace's echelon basis, and the others reduced modulo it.
struct Form {
  IntegerMatrix subspace, others;
  bool operator==(const Form&) const = default;
};

Form Canonical(const IntegerMatrix& subspace, const IntegerMatrix& others) {
  const EchelonBasis basis = algebra::RowSpace(subspace);
  IntegerMatrix reduced(0, others.columns);
  for (size_t i = 0; i < others.rows; ++i) reduced.AppendRow(algebra::ReduceModulo(basis, others.row(i)));
  return {basis.vectors, SortedPrimitive(reduced)};
}

Form GeneratorsByPpl(const ppl::C_Polyhedron& polyhedron) {
  const size_t columns = polyhedron.space_dimension();
  IntegerMatrix lines(0, columns), rays(0, columns);
  for (const ppl::Generator& generator : polyhedron.minimized_generators()) {
    if (generator.is_line()) lines.AppendRow(Entries(generator, columns));
    if (generator.is_ray()) rays.AppendRow(Entries(generator, columns));
  }
  return Canonical(lines, rays);
}

Form FacetsByPpl(const ppl::C_Polyhedron& polyhedron) {
  const size_t columns = polyhedron.space_dimension();
  IntegerMatrix equalities(0, columns), inequalities(0, columns);
  for (const ppl::Constraint& constraint : polyhedron.minimized_constraints()) {
    const IntegerVector entries = Entries(constraint, columns);
    bool zero = true;  // PPL lists 1 >= 0 too
    for (const Integer& entry : entries) zero = zero && entry.sign() == 0;
    if (!zero) (constraint.is_equality() ? equalities : inequalities).AppendRow(entries);
  }
  return Canonical(equalities, inequalities);
}

// Every other coordinate, chosen by the bits of `mask`.
std::vector<size_t> Coordinates(size_t columns, uint64_t mask) {
  std::vector<size_t> coordinates;
  for (size_t j = 0; j < columns; ++j) {
    if ((mask >> j & 1) != 0) coordinates.push_back(j);
  }
  return coordinates;
}

ppl::C_Polyhedron ProjectByPpl(ppl::C_Polyhedron polyhedron, uint64_t mask) {
  ppl::Variables_Set removed;
  for (size_t j = 0; j < polyhedron.space_dimension(); ++j) {
    if ((mask >> j & 1) == 0) removed.insert(ppl::Variable(j));
  }
  polyhedron.remove_space_dimensions(removed);
  return polyhedron;
}

// The name of the first thing that differs, empty if nothing does.
std::string Difference(const HalfspaceCone& cone, uint64_t mask) {
  const ppl::C_Polyhedron expected = Polyhedron(cone);
  const GeneratorCone found = algebra::Generators(cone).cone;
  if (algebra::Dimension(found) != expected.affine_dimension()) return "dimension";
  const Form generators = GeneratorsByPpl(expected);
  if (found.lines != generators.subspace) return "lineality space";
  if (found.rays != generators.others) return "rays";
  const HalfspaceCone facets = algebra::Facets(found);
  if (Form{facets.equalities, facets.inequalities} != FacetsByPpl(expected)) return "facets";
  const ConeForms shadow = algebra::Project(cone, Coordinates(cone.ambient_dimension(), mask));
  const ppl::C_Polyhedron expected_shadow = ProjectByPpl(expected, mask);
  if (Form{shadow.generators.lines, shadow.generators.rays} != GeneratorsByPpl(expected_shadow))
    return "projection";
  if (Form{shadow.facets.equalities, shadow.facets.inequalities} != FacetsByPpl(expected_shadow)) {
    return "facets of the projection";
  }
  return "";
}

void Print(const char* what, const IntegerMatrix& rows) {
  for (size_t i = 0; i < rows.rows; ++i)
    std::cout << "  " << what << " " << algebra::ToString(rows.row(i)) << "\n";
}

int Run(uint64_t cones, uint64_t seed) {
  constexpr int kMostPrinted = 5;
  uint64_t differences = 0, flat = 0, with_lines = 0, subspaces = 0;
  std::set<size_t> ray_counts;
  for (uint64_t index = 0; index < cones; ++index) {
    const HalfspaceCone cone = RandomCone(seed, index);
    const uint64_t mask = Random(seed + 1, index).Next();
    const std::string difference = Difference(cone, mask);
    if (!difference.empty() && ++differences <= kMostPrinted) {
      std::cout << "cone " << index << ": " << difference << "\n";
      Print("inequality", cone.inequalities);
      Print("equality", cone.equalities);
    }
    const GeneratorCone found = algebra::Generators(cone).cone;
    flat += algebra::Dimension(found) < cone.ambient_dimension();
    with_lines += found.lines.rows > 0;
    subspaces += found.rays.rows == 0;
    ray_counts.insert(found.rays.rows);
  }
  std::cout << cones << " cones (" << flat << " not of full dimension, " << with_lines << " with lines, "
            << subspaces << " subspaces, up to " << (ray_counts.empty() ? 0 : *ray_counts.rbegin())
            << " rays), " << differences << " differences\n";
  // A generator gone dull would make agreement worthless.
  const bool varied = cones < 1000 || (flat > cones / 20 && with_lines > cones / 20 && subspaces > 0 &&
                                       cones - flat > cones / 20 && ray_counts.size() > 20);
  if (!varied) std::cout << "the cones lack variety\n";
  return differences == 0 && varied ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::oracle

int main(int argc, char** argv) {
  try {
    uint64_t cones = 3000, seed = 1;
    for (int i = 1; i < argc; i += 2) {
      const std::string name = argv[i];
      if ((name != "--cones" && name != "--seed") || i + 1 == argc) {
        throw std::invalid_argument("expected --cones N or --seed S, got " + name);
      }
      (name == "--cones" ? cones : seed) = std::stoull(argv[i + 1]);
    }
    return tact::oracle::Run(cones, seed);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
