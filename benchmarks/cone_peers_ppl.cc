#include <ppl.hh>

#include "benchmarks/cone_peers.h"

namespace tact::benchmarks {

namespace ppl = Parma_Polyhedra_Library;

ConeSize SizeByPpl(const std::vector<int64_t>& rows) {
  ppl::Constraint_System system;
  for (size_t i = 0; i < rows.size(); i += 6) {
    ppl::Linear_Expression row;
    row.set_space_dimension(6);
    for (size_t j = 0; j < 6; ++j) row.set_coefficient(ppl::Variable(j), ppl::Coefficient(rows[i + j]));
    system.insert(row >= 0);
  }
  system.set_space_dimension(6);
  const ppl::C_Polyhedron cone(system, ppl::Recycle_Input());
  ConeSize size;
  for (const ppl::Generator& generator : cone.minimized_generators()) size.lineality += generator.is_line();
  size.dimension = static_cast<int>(cone.affine_dimension());
  return size;
}

}  // namespace tact::benchmarks
