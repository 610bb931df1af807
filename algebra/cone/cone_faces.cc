#include "algebra/cone/cone.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::algebra {
namespace {

// Decides row by row whether it is in the set (c) or not (s). The members that contain all c rows so far, and
// their intersection, are completed by s alone; so some set has this beginning if and only if that
// intersection meets no s row, and no branch is entered in vain.
class IntersectionWalk {
 public:
  IntersectionWalk(std::span<const RowSet> tight, size_t bound, const IntersectionVisitor& visitor)
      : tight_(tight), bound_(bound), visitor_(visitor), outside_(bound) {}

  bool Run() {
    closures_.push_back(RowSet::All(bound_));
    for (size_t k = 0; k < tight_.size(); ++k) {
      members_.push_back(k);
      closures_[0] &= tight_[k];
    }
    return Walk(0, 0);
  }

 private:
  // The members are members_[begin ..], their intersection is closures_.back(); both are as on entry on
  // return. Deciding c enters a smaller face, so the recursion is no deeper than the lattice of faces is high;
  // deciding s goes on in the loop.
  bool Walk(size_t row, size_t begin) {
    const size_t end = members_.size();
    const size_t first = row;
    bool go_on = true;
    for (; go_on && row < bound_; ++row) {
      if (closures_.back().Contains(row)) continue;
      go_on = WalkKeeping(row, begin, end);
      outside_.Insert(row);
    }
    if (go_on) go_on = visitor_(closures_.back(), {members_.data() + begin, end - begin});
    for (size_t decided = first; decided < row; ++decided) {
      if (!closures_.back().Contains(decided)) outside_.Erase(decided);
    }
    return go_on;
  }

  // The branch where the row is c, if there is one.
  bool WalkKeeping(size_t row, size_t begin, size_t end) {
    RowSet narrowed = RowSet::All(bound_);
    for (size_t i = begin; i < end; ++i) {
      const size_t member = members_[i];
      if (!tight_[member].Contains(row)) continue;
      members_.push_back(member);
      narrowed &= tight_[member];
    }
    bool go_on = true;
    if (!narrowed.Meets(outside_)) {
      closures_.push_back(std::move(narrowed));
      go_on = Walk(row + 1, end);
      closures_.pop_back();
    }
    members_.resize(end);
    return go_on;
  }

  std::span<const RowSet> tight_;
  size_t bound_;
  const IntersectionVisitor& visitor_;
  RowSet outside_;
  std::vector<RowSet> closures_;
  std::vector<size_t> members_;
};

}  // namespace

bool VisitIntersections(std::span<const RowSet> tight, size_t bound, const IntersectionVisitor& visitor) {
  return IntersectionWalk(tight, bound, visitor).Run();
}

std::vector<ConeFace> Faces(const ConeGenerators& generators, size_t inequalities) {
  std::vector<ConeFace> faces;
  VisitIntersections(generators.tight, inequalities, [&](const RowSet& set, std::span<const size_t> rays) {
    faces.push_back({set, {rays.begin(), rays.end()}, 0});
    // Canonical rays are zero at the lines' pivots, so the ranks add.
    faces.back().dimension = generators.lineality_dimension() + RankOfRows(generators.cone.rays, rays);
    return true;
  });
  return faces;
}

}  // namespace tact::algebra
