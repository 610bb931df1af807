#include "enumerators/planar_p_data.h"

namespace tact::enumerators {

knot::PData WithHeights(const Code& code, uint32_t heights) {
  std::array<bool, Code::kRow> over{};
  knot::PDataBuilder p(code.columns);
  uint32_t bit = (uint32_t{1} << code.crossings()) >> 1;
  for (int i = 1; i <= code.columns; ++i) {
    const int mate = code.sigma[static_cast<size_t>(i)];
    bool& mine = over[static_cast<size_t>(i)];
    if (i < mate) {
      mine = (heights & bit) == 0;
      bit >>= 1;
    } else {
      mine = !over[static_cast<size_t>(mate)];
    }
    p.Add(mate, knot::AttributeOf(mine, code.turn[static_cast<size_t>(i)]));
  }
  return p.Take();
}

}  // namespace tact::enumerators
