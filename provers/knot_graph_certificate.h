/// @file
/// Certificates about knot graphs, their faces and the parts of P-data (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "algebra/knot/rotation.h"
#include "algebra/knot/thesis_face_search.h"
#include "provers/certificate.h"

namespace tact::provers {

/// A planar rotation of p's knot graph besides its own and that one's mirror image; nameless: not even without the
/// edges' names like its own.
Certificate KnotEmbeddingCertificate(const std::string& name, const std::string& claim, const knot::PData& p,
                                     const knot::Rotation& rotation, bool nameless);
/// A search for faces that goes wrong: outcome is that of the reading.
Certificate KnotFaceSearchCertificate(const std::string& name, const std::string& claim, const knot::PData& p,
                                      const knot::thesis::FaceSearchReading& reading,
                                      const knot::thesis::FaceSearchOutcome& outcome);
/// P-data of no sphere, with the columns of its parts, each of a sphere.
Certificate KnotPartsCertificate(const std::string& name, const std::string& claim, const knot::PData& p);
/// A subdivision that is not three-connected: fewer than four vertices, or in pieces without some two.
Certificate KnotSubdivisionCertificate(const std::string& name, const std::string& claim,
                                       const knot::PData& p, int external, const std::vector<int>& without);

/// Edges e_k as their k, ascending.
std::vector<int> EdgesOf(knot::thesis::EdgeSet set);

}  // namespace tact::provers
