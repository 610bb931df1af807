/// @file
/// Motions that realise transitions between contact relations, as certificates (docs/certificates.md,
/// `motion-path`).
/// Errors  PreconditionError: a path that something interrupts (the message says what and where); contacts at a
///         seam, where a solid's pieces together bound a motion more than each of them does. BudgetError: no
///         separating planes were found.
#pragma once

#include "algebra/contact/scene.h"
#include "provers/certificate_writer.h"

namespace tact::provers {

/// How the transition is read: from the relation on [0, 1) to that at 1, or back.
enum class PathDirection { kForth, kBack };

/// The relations are those at s = 0, 1/2 and 1, in the order of the direction; `expects` is about the change that
/// s = 1 makes.
Certificate PathCertificate(const std::string& name, const std::string& claim, const algebra::Scene& scene,
                            PathDirection direction = PathDirection::kForth, const Changes& expects = {});

}  // namespace tact::provers
