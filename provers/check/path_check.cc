// A motion that realises a transition between contact relations: solids as unions of convex pieces, separated
// all along the path, that touch in the same corners until its end.
#include <algorithm>
#include <cstddef>
#include <string>

#include "provers/check/contact_reader.h"
#include "provers/check/kinds.h"
#include "provers/check/separate_normals.h"
#include "provers/check/touching.h"

namespace tact::check {
namespace {

// How often an interval is halved in which the touches could not be decided at once.
constexpr int kHalvings = 10;
// So that a hostile certificate is refused instead of keeping the checker busy.
constexpr std::size_t kMostPieces = 16, kMostCorners = 32, kMostPlanes = 64, kMostRelations = 8,
                      kMostContacts = 1024;

const Array& AsShortArray(const Value& value, std::size_t least, std::size_t most) {
  const Array& array = AsArray(value);
  if (array.size() < least || array.size() > most) {
    throw Refused(&value, "expected " + std::to_string(least) + " to " + std::to_string(most) + " entries");
  }
  return array;
}

// Of the hull: some plane touches it there only.
bool IsCorner(const Piece& piece, std::size_t index) {
  Matrix directions;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    if (i == index) continue;
    directions.push_back(Difference(piece[i], piece[index]));
    if (directions.back() == Row(3)) return false;
  }
  return Rank(ExtremeNormals(directions)) == 3;
}

std::vector<Piece> ReadPieces(const Value& value) {
  std::vector<Piece> pieces;
  for (const Value& list : AsShortArray(value, 1, kMostPieces)) {
    Piece& piece = pieces.emplace_back();
    Matrix differences;
    for (const Value& corner : AsShortArray(list, 4, kMostCorners)) {
      piece.push_back(AsIntegers(corner, 4));
      if (piece.back()[3] <= 0) throw Refused(&corner, "W is not positive");
      differences.push_back(Difference(piece.back(), piece.front()));
    }
    if (Rank(differences) < 3) throw Refused(&list, "the corners are all in one plane");
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (!IsCorner(piece, i)) throw Refused(&AsArray(list)[i], "no corner: the others' hull holds it");
    }
  }
  return pieces;
}

// A plane between two pieces from one s to another.
struct Separation {
  Fraction from, until;
  const Value* where;
};

struct Pair {
  const Piece& moving;
  const Piece& fixed;
  std::vector<Separation> separations;
};

class Check {
 public:
  explicit Check(const Value& certificate)
      : moving_(ReadPieces(At(certificate, "moving"))),
        fixed_(ReadPieces(At(certificate, "fixed"))),
        path_(ReadPath(At(certificate, "path"))) {
    const Value& planes = At(certificate, "planes");
    for (std::size_t i = 0; i < AsShortArray(planes, moving_.size(), moving_.size()).size(); ++i) {
      const Value& row = AsArray(planes)[i];
      for (std::size_t j = 0; j < AsShortArray(row, fixed_.size(), fixed_.size()).size(); ++j)
        pairs_.push_back({moving_[i], fixed_[j], ReadSeparations(AsArray(row)[j])});
    }
  }

  // No two pieces overlap, and which corners touch does not change on [0, 1).
  void Along() const {
    for (const Pair& pair : pairs_) {
      std::vector<TouchingCorner> first;
      for (const Separation& separation : pair.separations) {
        const auto corners = CornersFrom(pair, separation, separation.from, separation.until, kHalvings);
        if (&separation == &pair.separations.front()) first = corners;
        if (corners != first) throw Refused(separation.where, "other corners touch than before");
      }
    }
  }

  // The contacts are those of the pieces in place at s, all of them.
  void RelationAt(const Fraction& s, const Value& contacts) const {
    std::vector<ContactNumbers> expected;
    for (const Pair& pair : pairs_) AddContacts(pair, s, expected);
    std::vector<ContactNumbers> claimed;
    for (const Value& value : AsArray(contacts)) {
      claimed.push_back(ReadContact(value));
      const ContactNumbers& contact = claimed.back();
      const auto same = [&](const ContactNumbers& other) { return Same(contact, other); };
      if (std::none_of(expected.begin(), expected.end(), same))
        throw Refused(&value, "the pieces do not touch there with these planes");
      if (IsImplied(contact, expected))
        throw Refused(&value, "other pieces touch there with fewer of these planes");
      if (std::count_if(claimed.begin(), claimed.end(), same) > 1) throw Refused(&value, "stands twice");
    }
    for (const ContactNumbers& contact : expected) {
      const bool said = std::any_of(claimed.begin(), claimed.end(),
                                    [&](const ContactNumbers& other) { return Same(contact, other); });
      if (!said && !IsImplied(contact, expected))
        throw Refused(&contacts, "the pieces touch elsewhere too, at " + PointText(contact.point));
    }
  }

 private:
  static std::vector<Separation> ReadSeparations(const Value& value) {
    std::vector<Separation> separations;
    for (const Value& plane : AsShortArray(value, 1, kMostPlanes)) {
      ExpectKeys(plane, {"until", "through"}, {"normal", "carried", "edges"});
      const Fraction from = separations.empty() ? Fraction{0, 1} : separations.back().until;
      const Fraction until = ReadFraction(At(plane, "until"));
      if (!(from < until) || Fraction{1, 1} < until)
        throw Refused(&At(plane, "until"), "not after the plane before, or beyond 1");
      separations.push_back({from, until, &plane});
    }
    if (!(separations.back().until == Fraction{1, 1})) throw Refused(&value, "the planes end before 1");
    return separations;
  }

  // A normal on the moving piece's side.
  PolynomialVector NormalOf(const Pair& pair, const Value& plane, const Stage& stage) const {
    const Value* normal = Find(plane, "normal");
    const Value* carried = Find(plane, "carried");
    const Value* edges = Find(plane, "edges");
    if ((normal != nullptr) + (carried != nullptr) + (edges != nullptr) != 1)
      throw Refused(&plane, "expected one of normal, carried and edges");
    if (normal != nullptr) return Constant(AsIntegers(*normal, 3));
    if (carried != nullptr) return path_.Turn(AsIntegers(*carried, 3), stage);
    const auto direction = [](const Value& ends, const Piece& piece) {
      const Array& list = AsShortArray(ends, 2, 2);
      return Difference(piece[AsIndex(list[1], piece.size())], piece[AsIndex(list[0], piece.size())]);
    };
    const Array& both = AsShortArray(*edges, 2, 2);
    return Cross(path_.Turn(direction(both[0], pair.moving), stage),
                 Constant(direction(both[1], pair.fixed)));
  }

  PolynomialPoint BaseOf(const Pair& pair, const Value& plane, const Stage& stage) const {
    const Value& through = At(plane, "through");
    ExpectKeys(through, {}, {"moving", "fixed"});
    const Value* moving = Find(through, "moving");
    const Value* fixed = Find(through, "fixed");
    if ((moving == nullptr) == (fixed == nullptr))
      throw Refused(&through, "expected one corner, moving or fixed");
    if (moving != nullptr) return path_.Carry(pair.moving[AsIndex(*moving, pair.moving.size())], stage);
    return Standing(pair.fixed[AsIndex(*fixed, pair.fixed.size())]);
  }

  // The corners in which the two pieces touch from one s to another, the same ones all the way.
  std::vector<TouchingCorner> CornersFrom(const Pair& pair, const Separation& separation,
                                          const Fraction& from, const Fraction& until, int halvings) const {
    TouchingAnswer answer = CornersIn(pair, *separation.where, Between(from, until));
    if (answer.undecided.empty()) return answer.corners;
    if (halvings == 0)
      throw Refused(separation.where, "the touch of " + answer.undecided + " comes or goes before s = 1");
    const Fraction middle{from.p * until.q + until.p * from.q, 2 * from.q * until.q};
    const auto first = CornersFrom(pair, separation, from, middle, halvings - 1);
    if (CornersFrom(pair, separation, middle, until, halvings - 1) != first)
      throw Refused(separation.where, "touches come or go before s = 1");
    return first;
  }

  // Those in which they touch all over the stage; the plane is checked.
  TouchingAnswer CornersIn(const Pair& pair, const Value& plane, const Stage& stage) const {
    PlanePair touching{pair.moving, pair.fixed, {}, {}, NormalOf(pair, plane, stage)};
    const PolynomialPoint base = BaseOf(pair, plane, stage);
    bool strict = false;
    const auto sort = [&](const PolynomialPoint& corner, std::size_t index, int side, const char* whose,
                          std::vector<std::size_t>& in_plane) {
      const auto sign = SignOn(Dot(touching.normal, Difference(corner, base)));
      if (!sign || *sign == -side) {
        throw Refused(&plane, std::string(whose) + " corner " + std::to_string(index) +
                                  " is not on its side throughout, or cannot be decided");
      }
      strict = strict || *sign != 0;
      if (*sign == 0) in_plane.push_back(index);
    };
    for (std::size_t i = 0; i < pair.moving.size(); ++i)
      sort(path_.Carry(pair.moving[i], stage), i, 1, "moving", touching.moving_corners);
    for (std::size_t i = 0; i < pair.fixed.size(); ++i)
      sort(Standing(pair.fixed[i]), i, -1, "fixed", touching.fixed_corners);
    if (!strict) throw Refused(&plane, "no plane: all corners of both pieces are in it");
    return TouchingCorners(touching, path_, stage);
  }

  // Of a point at a stage of one s.
  static Row InPlace(const PolynomialPoint& point) {
    const auto value = [](const Polynomial& p) {
      return p.coefficients().empty() ? mpz_class(0) : p.coefficients()[0];
    };
    return {value(point.xyz[0]), value(point.xyz[1]), value(point.xyz[2]), value(point.w)};
  }

  void AddContacts(const Pair& pair, const Fraction& s, std::vector<ContactNumbers>& contacts) const {
    const auto separation = std::find_if(pair.separations.begin(), pair.separations.end() - 1,
                                         [&](const Separation& one) { return s < one.until; });
    const Stage stage = Only(s);
    Piece moving;
    for (const Row& corner : pair.moving) moving.push_back(InPlace(path_.Carry(corner, stage)));
    for (const TouchingCorner& corner : CornersIn(pair, *separation->where, stage).corners) {
      if (contacts.size() == kMostContacts)
        throw Refused(separation->where, "more than " + std::to_string(kMostContacts) + " contacts");
      const Row point = InPlace(corner.point);
      contacts.push_back({point, SeparateNormals(moving, pair.fixed, point), {}});
    }
  }

  static bool SamePoint(const ContactNumbers& a, const ContactNumbers& b) {
    return Difference(a.point, b.point) == Row(3);
  }
  static bool Same(const ContactNumbers& a, const ContactNumbers& b) {
    return SamePoint(a, b) && a.planes.size() == b.planes.size() && Includes(a.planes, b.planes) &&
           Includes(b.planes, a.planes);
  }
  static std::string PointText(const Row& point) {
    std::string text = "[";
    for (const mpz_class& x : point) text += (text.size() > 1 ? "," : "") + x.get_str();
    return text.substr(0, 200) + "]";
  }
  // By a contact at the same point with fewer planes.
  static bool IsImplied(const ContactNumbers& contact, const std::vector<ContactNumbers>& all) {
    return std::any_of(all.begin(), all.end(), [&](const ContactNumbers& other) {
      return SamePoint(contact, other) && other.planes.size() < contact.planes.size() &&
             Includes(contact.planes, other.planes);
    });
  }

  std::vector<Piece> moving_, fixed_;
  Path path_;
  std::vector<Pair> pairs_;
};

std::vector<Fraction> ReadPlaces(const Value& value, std::size_t relations) {
  std::vector<Fraction> places;
  for (const Value& s : AsShortArray(value, 2, kMostRelations)) places.push_back(ReadFraction(s));
  if (places.size() != relations) throw Refused(&value, "expected one s a relation");
  const bool back = places.back() < places.front();
  std::vector<Fraction> ascending = places;
  if (back) std::reverse(ascending.begin(), ascending.end());
  for (std::size_t i = 0; i + 1 < ascending.size(); ++i) {
    if (!(ascending[i] < ascending[i + 1])) throw Refused(&value, "not in order");
  }
  if (!(ascending.front() == Fraction{0, 1}) || !(ascending.back() == Fraction{1, 1}))
    throw Refused(&value, "expected all the way from 0 to 1, or back");
  return places;
}

}  // namespace

void CheckMotionPath(const Value& certificate) {
  ExpectCertificateKeys(certificate,
                        {"moving", "fixed", "path", "planes", "at", "relations", "names", "transitions"},
                        {"expects"});
  const Array& relations = AsArray(At(certificate, "relations"));
  const std::vector<Fraction> places = ReadPlaces(At(certificate, "at"), relations.size());
  const std::vector<MotionNumbers> dofs = CheckRelationsAndTransitions(certificate);
  const std::size_t end = places.back() == Fraction{1, 1} ? places.size() - 1 : 0;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    if (i != end && dofs[i] != dofs[end == 0 ? 1 : 0])
      throw Refused(&At(relations[i], "dof"), "the motion DOFs change before s = 1");
  }
  const Check check(certificate);
  check.Along();
  for (std::size_t i = 0; i < places.size(); ++i) check.RelationAt(places[i], At(relations[i], "contacts"));
}

}  // namespace tact::check
