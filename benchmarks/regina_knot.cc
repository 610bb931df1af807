#include "benchmarks/regina_knot.h"

#include <link/link.h>

namespace tact::benchmarks {

struct ReginaKnot::Impl {
  regina::Link link;
  std::vector<int> crossing_of;  // of column i at [i - 1]
  std::vector<int> strand_of;    // 1 upper, 0 lower

  regina::StrandRef ArcFrom(int column) const {
    const auto at = static_cast<size_t>(column) - 1;
    return {link.crossing(static_cast<size_t>(crossing_of[at])), strand_of[at]};
  }
};

std::vector<int> CrossingOfColumns(const knot::PData& p) {
  std::vector<int> crossing(static_cast<size_t>(p.columns()));
  int met = 0;
  for (int i = 1; i <= p.columns(); ++i) {
    const int mate = p.sigma(i);
    crossing[static_cast<size_t>(i) - 1] = mate > i ? met++ : crossing[static_cast<size_t>(mate) - 1];
  }
  return crossing;
}

ReginaKnot::ReginaKnot(const knot::PData& p) : impl_(std::make_unique<Impl>()) {
  impl_->crossing_of = CrossingOfColumns(p);
  std::vector<int> signs;
  std::vector<std::vector<int>> component(1);
  for (int i = 1; i <= p.columns(); ++i) {
    const int crossing = impl_->crossing_of[static_cast<size_t>(i) - 1];
    if (p.sigma(i) > i) signs.push_back(p.sign(i));
    impl_->strand_of.push_back(p.over(i) ? 1 : 0);
    component[0].push_back(p.over(i) ? crossing + 1 : -(crossing + 1));
  }
  impl_->link = regina::Link::fromData(signs.begin(), signs.end(), component.begin(), component.end());
}

ReginaKnot::ReginaKnot(const ReginaKnot& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
ReginaKnot::~ReginaKnot() = default;

bool ReginaKnot::RemoveR1(int crossing, bool perform) {
  return impl_->link.r1(impl_->link.crossing(static_cast<size_t>(crossing)), true, perform);
}

bool ReginaKnot::RemoveR2(int crossing, bool perform) {
  return impl_->link.r2(impl_->link.crossing(static_cast<size_t>(crossing)), true, perform);
}

bool ReginaKnot::ShiftR3(int crossing, int side, bool perform) {
  return impl_->link.r3(impl_->link.crossing(static_cast<size_t>(crossing)), side, true, perform);
}

bool ReginaKnot::AddR1(int column, int side, int sign, bool perform) {
  return impl_->link.r1(impl_->ArcFrom(column), side, sign, true, perform);
}

bool ReginaKnot::AddR2(int upper_column, int upper_side, int lower_column, int lower_side, bool perform) {
  return impl_->link.r2(impl_->ArcFrom(upper_column), upper_side, impl_->ArcFrom(lower_column), lower_side,
                        true, perform);
}

std::string ReginaKnot::Signature() const { return impl_->link.knotSig(false, false); }

int ReginaKnot::Writhe() const { return static_cast<int>(impl_->link.writhe()); }

bool ReginaKnot::IsRealisable(const std::vector<int>& gauss) {
  try {
    return regina::Link::fromGauss(gauss.begin(), gauss.end()).size() > 0;
  } catch (const regina::InvalidArgument&) {
    return false;
  }
}

}  // namespace tact::benchmarks
