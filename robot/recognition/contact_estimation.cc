#include "robot/recognition/contact_estimation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <set>

#include "algebra/error.h"

namespace tact::recognition {
namespace {

using Eigen::Vector3d;
using joint::Transform;

constexpr double kExact = 1e-9;        // share of the fixed solid's span: gaps that are zero
constexpr double kWidth = 2;           // of the thresholds a candidate may move the solid by
constexpr double kReach = 2 * kWidth;  // likewise: corners move farther than the root mean square of all
constexpr size_t kMostRestricted = 6;  // DOFs there are

double SpanOf(const SolidF& solid) {
  Vector3d low = solid.vertices.front(), high = low;
  for (const Vector3d& p : solid.vertices) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (high - low).norm();
}

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string WhyOf(const NoiseLevel& level, bool by_hand, const std::string& unit) {
  if (by_hand) return "the noise is given by hand";
  if (!level.deviation()) {
    return "the recording tells no noise (the fixed object is not seen, and nothing overlaps), so its poses "
           "are taken "
           "as exact";
  }
  std::string why = "noise of a gap: ";
  if (level.repeatability)
    why += Number(*level.repeatability) + " " + unit + " by the scatter of the fixed object's poses";
  if (level.overlap) {
    why += (level.repeatability ? ", " : "") + Number(*level.overlap) + " " + unit + " by " +
           std::to_string(level.overlaps) + " vertices inside the other solid";
  }
  return why + (level.repeatability && level.overlap ? "; the larger counts" : "");
}

// A candidate as it grows; so many of its contacts as are independent are what the next projection is told.
struct Grown {
  ContactCandidate candidate;
  std::vector<PointContact> independent;
};

// Points along the edges of a solid that may come to lie inside another, posed at X in it.
std::vector<Vector3d> PointsNear(const ProximitySolid& edges, const ProximitySolid& other, const Transform& X,
                                 double reach) {
  std::vector<Vector3d> points;
  const auto add = [&](const Vector3d& p) {
    if (other.DistanceToSurface(X * p) < reach || other.DepthOf(X * p) > 0) points.push_back(p);
  };
  for (const Vector3d& vertex : edges.solid().vertices) add(vertex);
  for (const auto& [tail, head] : edges.solid().edges) {
    for (int k = 1; k < kEdgeParts; ++k) add(tail + static_cast<double>(k) / kEdgeParts * (head - tail));
  }
  return points;
}

class CandidateSearch {
 public:
  CandidateSearch(const ProximitySolid& moving, const ProximitySolid& fixed, const Transform& X_FM,
                  const EstimationRule& rule)
      : moving_(moving),
        fixed_(fixed),
        X_FM_(X_FM),
        rule_(rule),
        metric_(moving.solid()),
        exact_(kExact * SpanOf(fixed.solid())),
        // A pair that leans on others may start farther away than the threshold.
        pairs_(NearPairs(moving, fixed, X_FM, kWidth * rule.threshold, TiltOf(metric_, rule))),
        moving_points_(PointsNear(moving, fixed, X_FM, kReach * rule.threshold)),
        fixed_points_(PointsNear(fixed, moving, X_FM.Inverse(), kReach * rule.threshold)) {}

  // How far edges may seem to dip into a plane: both ends of an arm as long as the solid's radius wrong by a threshold.
  static double TiltOf(const PoseMetric& metric, const EstimationRule& rule) {
    return std::min(2 * rule.threshold / metric.radius(), std::numbers::pi / 4);
  }

  std::vector<NearPair> Near() const {
    std::vector<NearPair> near;
    for (const NearPair& pair : pairs_) {
      if (pair.distance < rule_.threshold) near.push_back(pair);
    }
    return near;
  }

  std::vector<ContactCandidate> Find(size_t most) {
    std::vector<Grown> beam = {Finished({X_FM_, 0, 0}, true)};
    Keep(beam.front());
    for (size_t depth = 0; depth < kMostRestricted && !beam.empty(); ++depth) beam = GrowAll(beam);
    std::vector<ContactCandidate> found;
    for (auto& [contacts, candidate] : found_) found.push_back(std::move(candidate));
    std::stable_sort(found.begin(), found.end(),
                     [](const ContactCandidate& a, const ContactCandidate& b) { return a.cost < b.cost; });
    if (found.size() > most) {
      // The empty one stays: that nothing touches is always a candidate.
      const auto empty = std::find_if(found.begin() + static_cast<std::ptrdiff_t>(most), found.end(),
                                      [](const ContactCandidate& c) { return c.contacts.empty(); });
      if (empty != found.end() && most > 0) std::swap(found[most - 1], *empty);
      found.resize(most);
    }
    return found;
  }

 private:
  std::vector<Grown> GrowAll(const std::vector<Grown>& beam) {
    std::vector<Grown> next;
    for (const Grown& parent : beam) {
      for (const NearPair& pair : pairs_) {
        if (std::binary_search(parent.candidate.contacts.begin(), parent.candidate.contacts.end(),
                               pair.contact))
          continue;
        std::vector<PointContact> contacts = parent.independent;
        contacts.push_back(pair.contact);
        if (!tried_.insert(Sorted(contacts)).second) continue;
        const auto projection = ProjectOntoContacts(contacts, moving_.solid(), fixed_.solid(), metric_, X_FM_,
                                                    parent.candidate.X_FM, kWidth * rule_.threshold, exact_);
        if (!projection) continue;
        Grown child = Finished(*projection, false);
        const auto& held = child.candidate.contacts;
        // Where its pose was found, one of its contacts may be off its face.
        if (!std::binary_search(held.begin(), held.end(), pair.contact)) continue;
        if (child.candidate.restricted <= parent.candidate.restricted || !Keep(child)) continue;
        next.push_back(std::move(child));
      }
    }
    std::stable_sort(next.begin(), next.end(),
                     [](const Grown& a, const Grown& b) { return a.candidate.cost < b.candidate.cost; });
    if (next.size() > kBeam) next.resize(kBeam);
    return next;
  }

  static std::vector<PointContact> Sorted(std::vector<PointContact> contacts) {
    std::sort(contacts.begin(), contacts.end());
    return contacts;
  }

  // What holds at the pose, and how deep the solids overlap there. The empty candidate holds nothing, whatever touches.
  Grown Finished(const Projection& projection, bool empty) const {
    Grown grown;
    ContactCandidate& c = grown.candidate;
    c.X_FM = projection.X_FM;
    c.displacement = projection.displacement;
    for (const NearPair& pair : pairs_) {
      const double gap = GapOf(pair.contact, moving_.solid(), fixed_.solid(), c.X_FM).gap;
      if (!empty && std::abs(gap) < 10 * exact_ &&
          DistanceAt(pair.contact, c.X_FM) < kWidth * rule_.threshold)
        c.contacts.push_back(pair.contact);
    }
    c.overlap = OverlapAt(c.X_FM);
    grown.independent = IndependentContacts(c.contacts, moving_.solid(), fixed_.solid(), metric_, c.X_FM);
    c.restricted = static_cast<int>(grown.independent.size());
    const double way = c.displacement / rule_.noise, deep = c.overlap / (kOverlap * rule_.noise);
    const auto spare = static_cast<double>(c.contacts.size() - grown.independent.size());
    c.cost = way * way + deep * deep - rule_.reward * c.restricted - kSpare * spare;
    return grown;
  }

  double OverlapAt(const Transform& X) const {
    const Transform back = X.Inverse();
    double deepest = 0;
    for (const Vector3d& p : moving_points_) deepest = std::max(deepest, fixed_.DepthOf(X * p));
    for (const Vector3d& p : fixed_points_) deepest = std::max(deepest, moving_.DepthOf(back * p));
    return deepest;
  }

  // Between the elements: what noise shifts along a face, where nothing holds it, does not end a contact.
  double DistanceAt(const PointContact& contact, const Transform& X) const {
    switch (contact.kind) {
      case PointContactKind::kVertexFace:
        return fixed_.DistanceToFace(contact.fixed, X * moving_.solid().vertices[contact.moving]);
      case PointContactKind::kFaceVertex:
        return moving_.DistanceToFace(contact.moving, X.Inverse() * fixed_.solid().vertices[contact.fixed]);
      default: {
        const auto& [a, b] = moving_.solid().edges[contact.moving];
        const auto& [c, d] = fixed_.solid().edges[contact.fixed];
        return DistanceOfSegments(X * a, X * b, c, d);
      }
    }
  }

  // True if these contacts are new or better than before.
  bool Keep(const Grown& grown) {
    const auto [it, is_new] = found_.emplace(grown.candidate.contacts, grown.candidate);
    if (is_new) return true;
    if (it->second.cost <= grown.candidate.cost) return false;
    it->second = grown.candidate;
    return true;
  }

  const ProximitySolid &moving_, &fixed_;
  const Transform& X_FM_;
  const EstimationRule& rule_;
  PoseMetric metric_;
  double exact_;
  std::vector<NearPair> pairs_;
  std::vector<Vector3d> moving_points_,
      fixed_points_;  // where overlap is looked for, each in its solid's frame
  std::set<std::vector<PointContact>> tried_;
  std::map<std::vector<PointContact>, ContactCandidate> found_;
};

}  // namespace

EstimationRule MakeRule(const input::RecordedDemonstration& recording, const ProximitySolid& moving,
                        const ProximitySolid& fixed, const EstimationOptions& options) {
  if ((options.noise && !(*options.noise > 0)) || (options.threshold && !(*options.threshold > 0)))
    throw PreconditionError("a noise or a threshold that is not positive");
  const std::string unit(ToString(recording.models.unit));
  const double span = SpanOf(fixed.solid());
  const NoiseLevel level = options.noise ? NoiseLevel{} : MeasureNoise(recording, moving, fixed);
  EstimationRule rule;
  rule.noise = std::max(options.noise.value_or(level.deviation().value_or(0)), kLeastNoise * span);
  // Noise as large as the solids leaves nothing to tell.
  rule.reward = std::max(2 * std::log(span / (rule.noise * std::sqrt(2 * std::numbers::pi))), 0.0);
  rule.threshold = options.threshold.value_or(rule.noise * std::sqrt(std::max(rule.reward, 1.0)));
  rule.why = WhyOf(level, options.noise.has_value(), unit) + "; threshold " + Number(rule.threshold) + " " +
             unit +
             (options.threshold ? " by hand" : ", " + Number(rule.threshold / rule.noise) + " deviations");
  return rule;
}

SceneEstimate EstimateContacts(const ProximitySolid& moving, const ProximitySolid& fixed,
                               const Transform& X_FM, const EstimationRule& rule, size_t most) {
  CandidateSearch search(moving, fixed, X_FM, rule);
  SceneEstimate estimate;
  estimate.near = search.Near();
  estimate.candidates = search.Find(most);
  return estimate;
}

}  // namespace tact::recognition
