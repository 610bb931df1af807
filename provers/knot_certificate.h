/// @file
/// Moves of a rope, knots tied step by step, and pairs of P-data on which a rule of the thesis fails, as certificates
/// (docs/certificates.md).
#pragma once

#include <string>
#include <vector>

#include "algebra/knot/curve_projection.h"
#include "algebra/knot/move.h"
#include "algebra/knot/thesis_rules.h"
#include "algebra/knot/tying.h"
#include "provers/certificate.h"

namespace tact::provers {

/// One move between two P-data; needs no more than its end points to be believed.
Certificate KnotMoveCertificate(const std::string& name, const std::string& claim, const knot::PData& before,
                                const knot::Move& move, const knot::PData& after);
/// A knot tied from the straight rope; at_least: so many steps are needed, by the bound of tying_bound.h; 0: not claimed.
Certificate KnotTyingCertificate(const std::string& name, const std::string& claim,
                                 const std::vector<knot::TyingStep>& steps, int at_least = 0);

/// A curve whose projection from above is the P-data (algebra/knot/exact_drawing.h makes one).
Certificate KnotDrawingCertificate(const std::string& name, const std::string& claim, const knot::PData& p,
                                   const knot::Curve& curve);

/// The rule for R_II or R_III in one reading, as JSON.
std::string RuleText(const knot::thesis::R2Reading& reading);
std::string RuleText(const knot::thesis::R3Reading& reading);
/// A move that adds or shifts and that the rule does not find.
Certificate MissedMoveCertificate(const std::string& name, const std::string& claim, const std::string& rule,
                                  const knot::PData& before, const knot::Move& move,
                                  const knot::PData& after);
/// Segments that the rule accepts where no move of its kind leads from one to the other.
Certificate WrongRuleCertificate(const std::string& name, const std::string& claim, const std::string& rule,
                                 const knot::PData& before, const std::vector<int>& segments,
                                 const knot::PData& after);

}  // namespace tact::provers
