// The list of all DOF classes: every candidate is excluded by a lemma of docs/dof-classes.md or has its witness.
#include <set>
#include <string>
#include <vector>

#include "provers/check/contact_reader.h"
#include "provers/check/kinds.h"

namespace tact::check {
namespace {

// A candidate by what the lemmas speak of (docs/dof-classes.md, "Notation").
struct Candidate {
  int rt, ct, rr, q, cr, ca;
};

MotionNumbers Numbers(const Candidate& c) {
  MotionNumbers n;
  n["translation.maintaining"] = 3 - c.rt;
  n["translation.detaching"] = c.rt - c.ct;
  n["translation.constraining"] = c.ct;
  n["translation.restricted"] = c.rt;
  n["rotation.maintaining"] = 3 - c.rr;
  n["rotation.detaching"] = c.rr - c.cr;
  n["rotation.detaching_type1"] = c.rr - c.q;
  n["rotation.detaching_type2"] = c.q - c.cr;
  n["rotation.constraining"] = c.cr;
  n["rotation.restricted"] = c.rr;
  n["all.maintaining"] = 6 - c.rt - c.rr;
  n["all.detaching"] = c.rt + c.rr - c.ca;
  n["all.constraining"] = c.ca;
  n["all.restricted"] = c.rt + c.rr;
  return n;
}

// The seven lemmas, in their order there.
bool IsExcluded(const Candidate& c) {
  if ((c.rt == 0 && c.rr > 0) || (c.rt == 1 && c.rr > 2)) return true;
  if (c.ct == 0 && (c.ca > 0 || c.q > 0)) return true;
  if (c.ct == 1 && c.q > 2) return true;
  if (c.rt == c.ct && c.rr > c.q) return true;
  if (c.ca < c.cr || c.ca > c.cr + c.ct) return true;
  if (c.ca > 0 && c.ca == c.cr) return true;
  return c.q == c.cr && c.ca != c.cr + c.ct;
}

// The two lemmas on axis-parallel faces.
bool IsExcludedForBoxes(const Candidate& c) {
  if (c.rt - c.ct == 1 && c.q == 0 && c.rr > 2) return true;
  return c.ct == 3 && c.ca == 0 && c.q < 2;
}

std::set<MotionNumbers> Classes(bool boxes) {
  std::set<MotionNumbers> classes;
  for (int rt = 0; rt <= 3; ++rt) {
    for (int ct = 0; ct <= rt; ++ct) {
      for (int rr = 0; rr <= 3; ++rr) {
        for (int q = 0; q <= rr; ++q) {
          for (int cr = 0; cr <= q; ++cr) {
            for (int ca = 0; ca <= rt + rr; ++ca) {
              const Candidate c{rt, ct, rr, q, cr, ca};
              if (!IsExcluded(c) && !(boxes && IsExcludedForBoxes(c))) classes.insert(Numbers(c));
            }
          }
        }
      }
    }
  }
  return classes;
}

// Of singular relations: the DOFs of the contacts with one plane, and every restricted DOF that is possible when
// planes are added, of which a singular contact has two directions at least.
std::set<MotionNumbers> SingularClasses() {
  std::set<MotionNumbers> classes;
  for (MotionNumbers dof : Classes(false)) {
    dof.singular = true;
    const int translation = dof["translation.restricted"], rotation = dof["rotation.restricted"];
    for (int rt = translation < 2 ? 2 : translation; rt <= 3; ++rt) {
      for (int rr = rotation; rr <= 3; ++rr) {
        dof["translation.restricted"] = rt;
        dof["rotation.restricted"] = rr;
        dof["all.restricted"] = rt + rr;
        classes.insert(dof);
      }
    }
  }
  return classes;
}

bool ReadFlag(const Value& certificate, std::string_view key) {
  const Value* flag = Find(certificate, key);
  return flag != nullptr && AsBool(*flag);
}

bool ReadFaces(const Value& faces) {
  if (AsString(faces) == "axis-parallel") return true;
  if (AsString(faces) != "any") throw Refused(&faces, "expected \"any\" or \"axis-parallel\"");
  return false;
}

void ExpectAxisParallel(const Value& relation) {
  for (const Value& contact : AsArray(At(relation, "contacts"))) {
    for (const Row& normal : ReadContact(contact).planes) {
      const int entries = (normal[0] != 0) + (normal[1] != 0) + (normal[2] != 0);
      if (entries != 1) throw Refused(&contact, "its plane is not parallel to a coordinate plane");
    }
  }
}

void ExpectFewest(const Value& relation, const MotionNumbers& dof) {
  const int fewest = dof["all.restricted"] + (dof["all.constraining"] > 0 ? 1 : 0);
  if (AsArray(At(relation, "contacts")).size() != static_cast<std::size_t>(fewest))
    throw Refused(&relation, "the fewest contacts of its class are " + std::to_string(fewest));
}

void CheckCount(const Value& entry, const std::set<MotionNumbers>& classes) {
  ExpectKeys(entry, {"indices", "classes"});
  std::vector<std::size_t> indices;
  for (const Value& name : AsArray(At(entry, "indices"))) {
    indices.push_back(IndexOf(AsString(name)));
    if (indices.back() == kIndexNames.size()) throw Refused(&name, "no index has this name");
  }
  std::set<std::vector<int>> distinct;
  for (const MotionNumbers& dof : classes) {
    std::vector<int> values;
    for (const std::size_t i : indices) values.push_back(dof.values[i]);
    distinct.insert(values);
  }
  const Value& count = At(entry, "classes");
  if (AsInteger(count) != static_cast<unsigned long>(distinct.size()))
    throw Refused(&count, "these indices tell " + std::to_string(distinct.size()) + " classes apart");
}

}  // namespace

void CheckDofClasses(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"faces", "classes", "counts", "touching"}, {"fewest", "singular"});
  const bool boxes = ReadFaces(At(certificate, "faces"));
  const bool expects_fewest = ReadFlag(certificate, "fewest"), singular = ReadFlag(certificate, "singular");
  if (singular && (boxes || expects_fewest))
    throw Refused(&certificate, "singular relations are listed for any faces and any number of contacts");
  const std::set<MotionNumbers> classes = singular ? SingularClasses() : Classes(boxes);
  std::set<MotionNumbers> witnessed;
  unsigned long touching = 0;
  for (const Value& relation : AsArray(At(certificate, "classes"))) {
    const MotionNumbers dof = CheckRelation(relation);
    if (dof.singular != singular) throw Refused(&relation, singular ? "is not singular" : "is singular");
    if (boxes) ExpectAxisParallel(relation);
    if (expects_fewest) ExpectFewest(relation, dof);
    if (!classes.contains(dof)) throw Refused(&relation, "has motion DOFs that a lemma excludes");
    if (!witnessed.insert(dof).second) throw Refused(&relation, "its class has a witness already");
    touching += AsArray(At(relation, "contacts")).empty() ? 0 : 1;
  }
  if (witnessed.size() != classes.size()) {
    throw Refused(&At(certificate, "classes"), std::to_string(classes.size() - witnessed.size()) + " of " +
                                                   std::to_string(classes.size()) +
                                                   " classes have no witness");
  }
  if (AsInteger(At(certificate, "touching")) != touching)
    throw Refused(&At(certificate, "touching"), std::to_string(touching) + " witnesses have contacts");
  for (const Value& entry : AsArray(At(certificate, "counts"))) CheckCount(entry, classes);
}

}  // namespace tact::check
