// The list of all DOF classes as a certificate: complete lists are accepted, any other is refused with its reason.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "enumerators/dof_census.h"
#include "provers/certificate_writer.h"
#include "provers/check/check.h"

namespace tact::provers {
namespace {

using nlohmann::json;

json Complete(ClassList list) {
  static std::map<ClassList, json> known;
  const auto [at, is_new] = known.try_emplace(list);
  if (!is_new) return at->second;
  const enumerators::DofCensus census(list == ClassList::kAnyFaces ? enumerators::CornerWorld(7)
                                                                   : enumerators::CubeWorld(9));
  std::vector<algebra::ContactRelation> witnesses;
  for (const auto& c : census.Count()) witnesses.push_back(census.Relation(c.witness));
  at->second =
      json::parse(DofClassesCertificate("list", "list", list, witnesses, enumerators::DofDefinitions()).json);
  return at->second;
}

std::string Why(const json& certificate) { return check::CheckCertificate(certificate.dump()).why; }

TEST(DofClassesCertificate, CompleteListsAreAccepted) {
  EXPECT_EQ(Why(Complete(ClassList::kAnyFaces)), "");
  EXPECT_EQ(Why(Complete(ClassList::kAxisParallelFaces)), "");
}

TEST(DofClassesCertificate, AMissingClassIsNoticed) {
  json list = Complete(ClassList::kAnyFaces);
  list["classes"].erase(17);
  EXPECT_EQ(Why(list), "classes: 1 of 142 classes have no witness");
}

TEST(DofClassesCertificate, AClassTwiceIsRefused) {
  json list = Complete(ClassList::kAnyFaces);
  list["classes"].push_back(list["classes"][3]);
  EXPECT_EQ(Why(list), "classes[142]: its class has a witness already");
}

TEST(DofClassesCertificate, BoxesAreNotAllThereIs) {
  json list = Complete(ClassList::kAxisParallelFaces);
  list["faces"] = "any";
  EXPECT_EQ(Why(list), "classes: 3 of 142 classes have no witness");
}

TEST(DofClassesCertificate, OtherFacesAreNoBoxes) {
  json list = Complete(ClassList::kAnyFaces);
  list["faces"] = "axis-parallel";
  list.erase("fewest");
  EXPECT_NE(Why(list).find("its plane is not parallel to a coordinate plane"), std::string::npos);
  list["faces"] = "round";
  EXPECT_EQ(Why(list), "faces: expected \"any\" or \"axis-parallel\"");
}

TEST(DofClassesCertificate, AWrongCountIsRefused) {
  json list = Complete(ClassList::kAnyFaces);
  list["counts"][4]["classes"] = 138;
  EXPECT_EQ(Why(list), "counts[4].classes: these indices tell 66 classes apart");
  list = Complete(ClassList::kAxisParallelFaces);
  list["touching"] = 139;
  EXPECT_EQ(Why(list), "touching: 138 witnesses have contacts");
  list["counts"][0]["indices"][0] = "translation.wobbling";
  EXPECT_NE(Why(list), "");
}

TEST(DofClassesCertificate, AWitnessWithAContactTooManyIsNotSmallest) {
  json list = Complete(ClassList::kAxisParallelFaces);  // boxes need more contacts for some classes
  list["fewest"] = true;
  EXPECT_NE(Why(list).find("the fewest contacts of its class are"), std::string::npos);
}

TEST(DofClassesCertificate, OrdinaryRelationsAreNoSingularOnes) {
  json list = Complete(ClassList::kAnyFaces);
  list["singular"] = true;
  EXPECT_NE(Why(list).find("singular relations are listed for any faces"), std::string::npos);
  list.erase("fewest");
  EXPECT_EQ(Why(list), "classes[0]: is not singular");
}

}  // namespace
}  // namespace tact::provers
