/// @file
/// The claims on trial, a file a part of the thesis.
#pragma once

#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

/// [thesis, 2.1]: legal infinitesimal displacement.
std::vector<Claim> DisplacementClaims();
/// [thesis, 2.2.1]: Propositions 1 to 6.
std::vector<Claim> PropositionClaims();
/// [thesis, 2.2.1, 2.3.1, 2.6 and A.1]: more on the motion DOFs of non-singular relations.
std::vector<Claim> MotionDofClaims();
/// [thesis, 2.2.2-2.6]: singular relations, restricted DOFs, sub-skill rules.
std::vector<Claim> SingularClaims();
/// [thesis, 2.3]: how many kinds of contact relations there are.
std::vector<Claim> DofClassClaims();
/// [thesis, 2.3]: the thirty DOF-transitions, the practical ones, the thirteen steps between ten kinds.
std::vector<Claim> DofTransitionClaims();
/// [thesis, 2.3.2 and 2.6]: the rules that read sub-skills and critical transitions off DOF-transitions.
std::vector<Claim> SubSkillRuleClaims();
/// [thesis, 2.3.1 and 2.6]: how often the kinds of DOF-transitions appear, and what the rules make of them.
std::vector<Claim> TransitionFrequencyClaims();
/// [thesis, 2.7.4 and 2.8.1]: validity of transitions, the peg insertion watched with errors.
std::vector<Claim> WatchedInsertionClaims();
/// [thesis, 2.7.3 and 2.8.3]: vision error correction, Table 2.1.
std::vector<Claim> VisionCorrectionClaims();
/// [thesis, 2.8.2]: the peg insertion and its seven transitions.
std::vector<Claim> PegInsertionClaims();
/// [thesis, chapter 4]: joints.
std::vector<Claim> JointClaims();
/// [thesis, 4.5.3]: the two parts of a plier from range images, and its axis.
std::vector<Claim> PlierClaims();
/// [thesis, 5.1 and 5.4.1]: P-data and knot projections, Propositions 7 to 9.
std::vector<Claim> KnotProjectionClaims();
/// [thesis, 5.2 and 5.3]: the rules that detect moves, Propositions 10 to 15.
std::vector<Claim> KnotMoveClaims();
/// [thesis, 5.2.3]: sufficiency.
std::vector<Claim> KnotTyingClaims();
/// [thesis, 5.4.2]: a bowline and a bow, recognized.
std::vector<Claim> KnotWatchedClaims();

/// Every claim, in the order of the thesis.
std::vector<Claim> AllClaims();

}  // namespace tact::provers
