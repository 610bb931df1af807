#include "robot/recognition/relation_candidates.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace tact::recognition {
namespace {

using joint::Transform;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int kSteps = 20;
constexpr double kRank = 1e-7;  // of the largest singular value, rows in units of the noise

// Changes of a pose in units of the noise.
class NoisyPose {
 public:
  NoisyPose(const ProximitySolid& moving, const ProximitySolid& fixed, const Transform& seen,
            const PoseNoise& noise)
      : moving_(moving), fixed_(fixed), seen_(seen), noise_(noise), middle_(moving.middle()) {}

  Transform Changed(const Vector6& change) const {
    const Eigen::Matrix3d R = joint::RotationExp(noise_.rotation * change.head<3>()) * seen_.R;
    const Eigen::Vector3d middle = seen_ * middle_ + noise_.location * change.tail<3>();
    return {R, middle - R * middle_};
  }
  Vector6 ChangeTo(const Transform& X) const {
    Vector6 change;
    change << joint::RotationLog(X.R * seen_.R.transpose()) / noise_.rotation,
        (X * middle_ - seen_ * middle_) / noise_.location;
    return change;
  }
  Gap GapAt(const PointContact& contact, const Transform& X) const {
    return GapOf(contact, moving_.solid(), fixed_.solid(), X);
  }
  // A gap's row at the pose, for changes on top of it.
  GapRow Row(const Gap& gap, const Transform& X) const {
    const Eigen::Vector3d n = gap.row.tail<3>().transpose(), arm = gap.at - X * middle_;
    GapRow row;
    row << noise_.rotation * arm.cross(n).transpose(), noise_.location * n.transpose();
    return row;
  }
  Transform Stepped(const Transform& X, const Vector6& step) const {
    const Eigen::Matrix3d turn = joint::RotationExp(noise_.rotation * step.head<3>());
    const Eigen::Vector3d middle = X * middle_ + noise_.location * step.tail<3>();
    const Eigen::Matrix3d R = turn * X.R;
    return {R, middle - R * middle_};
  }

 private:
  const ProximitySolid &moving_, &fixed_;
  Transform seen_;
  PoseNoise noise_;
  Eigen::Vector3d middle_;
};

struct Closed {
  bool closed = false;
  Transform X;
  int rank = 0;
  Eigen::Vector2d share = Eigen::Vector2d::Zero();
};

Eigen::MatrixXd RowsOf(const NoisyPose& pose, const std::vector<PointContact>& contacts, const Transform& X) {
  Eigen::MatrixXd J(static_cast<Eigen::Index>(contacts.size()), 6);
  for (size_t i = 0; i < contacts.size(); ++i)
    J.row(static_cast<Eigen::Index>(i)) = pose.Row(pose.GapAt(contacts[i], X), X);
  return J;
}

int RankOf(const NoisyPose& pose, const std::vector<PointContact>& contacts, const Transform& X) {
  if (contacts.empty()) return 0;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd(RowsOf(pose, contacts, X));
  svd.setThreshold(kRank);
  return static_cast<int>(svd.rank());
}

// The change of least norm that closes the gaps: of all changes on the linearised gaps' solutions the one nearest to the
// pose seen, again and again.
Closed Close(const NoisyPose& pose, const std::vector<PointContact>& contacts) {
  Closed answer{false, pose.Changed(Vector6::Zero()), 0};
  if (contacts.empty()) {
    answer.closed = true;
    return answer;
  }
  const auto rows = static_cast<Eigen::Index>(contacts.size());
  Eigen::MatrixXd J(rows, 6);
  Eigen::VectorXd gaps(rows);
  for (int step = 0; step < kSteps; ++step) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Gap gap = pose.GapAt(contacts[static_cast<size_t>(i)], answer.X);
      J.row(i) = pose.Row(gap, answer.X);
      gaps[i] = gap.gap;
    }
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(kRank);
    answer.rank = static_cast<int>(svd.rank());
    if (gaps.cwiseAbs().maxCoeff() < kClosed / 10) {
      answer.closed = true;
      const auto rows_space = svd.matrixV().leftCols(answer.rank);
      answer.share = {rows_space.topRows<3>().squaredNorm(), rows_space.bottomRows<3>().squaredNorm()};
      return answer;
    }
    const Vector6 change = pose.ChangeTo(answer.X);
    const Vector6 next = svd.solve(J * change - gaps);  // the least change with J (next - change) = -gaps
    answer.X = pose.Stepped(answer.X, next - change);
  }
  return answer;
}

class Search {
 public:
  Search(const ProximitySolid& moving, const ProximitySolid& fixed, const Transform& X,
         const CandidateSearch& search)
      : moving_(moving), fixed_(fixed), pose_(moving, fixed, X, search.noise), search_(search) {
    const double angle = search.deviations * search.noise.rotation;
    // A vertex moves by half the diameter when the solid turns by a radian.
    const double distance =
        search.deviations * search.noise.location + moving.diameter() / 2 * search.noise.rotation;
    for (const NearContact& near : FindNearContacts(moving, fixed, X, {distance, angle}))
      near_.push_back(near.contact);
    faces_ = FacePairs(X.R, angle);
  }

  std::vector<RelationCandidate> Run() {
    std::vector<RelationCandidate> all;
    std::vector<Node> front = {{Empty(), {}}};
    all.push_back(front.front().candidate);
    seen_.insert(all.front().contacts);
    while (!front.empty()) {
      std::vector<Node> next;
      for (const Node& from : front) {
        const auto& has = from.candidate.contacts;
        for (const PointContact& contact : from.deep.empty() ? near_ : from.deep) {
          if (!std::binary_search(has.begin(), has.end(), contact)) Grow(from.candidate, {contact}, &next);
        }
        for (const auto& contacts : faces_) Grow(from.candidate, contacts, &next);
      }
      std::sort(next.begin(), next.end(),
                [](const Node& a, const Node& b) { return Before(a.candidate, b.candidate); });
      for (const Node& node : next)
        if (node.deep.empty()) all.push_back(node.candidate);
      if (next.size() > kGrown) next.resize(kGrown);
      front = std::move(next);
    }
    std::sort(all.begin(), all.end(), Before);
    return all;
  }

 private:
  struct Node {
    RelationCandidate candidate;
    std::vector<PointContact> deep;  // near contacts that penetrate
  };

  std::vector<std::vector<PointContact>> FacePairs(const Eigen::Matrix3d& R, double angle) const {
    std::map<std::pair<size_t, size_t>, std::vector<PointContact>> pairs;
    for (const PointContact& contact : near_) {
      if (contact.kind == PointContactKind::kVertexFace) {
        for (const size_t face : moving_.faces_at(contact.moving))
          pairs[{face, contact.fixed}].push_back(contact);
      } else if (contact.kind == PointContactKind::kFaceVertex) {
        for (const size_t face : fixed_.faces_at(contact.fixed))
          pairs[{contact.moving, face}].push_back(contact);
      }
    }
    std::vector<std::vector<PointContact>> answer;
    for (auto& [faces, contacts] : pairs) {
      const Eigen::Vector3d m = R * moving_.solid().faces[faces.first].normal;
      if (contacts.size() >= 3 && -m.dot(fixed_.solid().faces[faces.second].normal) > std::cos(angle))
        answer.push_back(std::move(contacts));
    }
    return answer;
  }
  static bool Before(const RelationCandidate& a, const RelationCandidate& b) {
    return a.cost != b.cost ? a.cost < b.cost : a.contacts < b.contacts;
  }

  RelationCandidate Empty() const {
    return {{}, pose_.Changed(Vector6::Zero()), Vector6::Zero(), 0, Eigen::Vector2d::Zero(), 0};
  }

  void Grow(const RelationCandidate& from, const std::vector<PointContact>& more, std::vector<Node>* next) {
    std::vector<PointContact> contacts;
    std::set_union(from.contacts.begin(), from.contacts.end(), more.begin(), more.end(),
                   std::back_inserter(contacts));
    if (contacts.size() == from.contacts.size()) return;
    const Closed closed = Close(pose_, contacts);
    if (!closed.closed) return;
    RelationCandidate grown;
    grown.X_FM = closed.X;
    grown.change = pose_.ChangeTo(closed.X);
    grown.taken = closed.rank;
    if (grown.change.cwiseAbs().maxCoeff() > 2 * search_.deviations) return;
    grown.share = closed.share;
    std::vector<PointContact> deep;
    for (const PointContact& near : near_) {
      const double gap = pose_.GapAt(near, closed.X).gap;
      if (gap >= kClosed || AsideOf(near, moving_, fixed_, closed.X) >= kClosed) continue;
      (gap > -kClosed ? grown.contacts : deep).push_back(near);
    }
    // Contacts beside their faces or edges are none; others may hold in their place.
    if (RankOf(pose_, grown.contacts, closed.X) < closed.rank) return;
    if (!seen_.insert(grown.contacts).second) return;
    grown.cost = grown.change.squaredNorm() / 2 - search_.reward * grown.taken;
    next->push_back({std::move(grown), std::move(deep)});
  }

  const ProximitySolid &moving_, &fixed_;
  NoisyPose pose_;
  CandidateSearch search_;
  std::vector<PointContact> near_;
  std::vector<std::vector<PointContact>>
      faces_;  // vertices of a face near another and of that near it, three at least
  std::set<std::vector<PointContact>> seen_;
};

}  // namespace

std::vector<RelationCandidate> FindRelationCandidates(const ProximitySolid& moving,
                                                      const ProximitySolid& fixed, const Transform& X_FM,
                                                      const CandidateSearch& search) {
  return Search(moving, fixed, X_FM, search).Run();
}

}  // namespace tact::recognition
