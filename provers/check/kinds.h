/// @file
/// One check a kind of certificate (docs/certificates.md). Each refuses what it cannot confirm, unknown keys
/// too; the keys that every certificate has are checked before. Errors  Refused.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "provers/check/json_value.h"
#include "provers/check/motion_numbers.h"

namespace tact::check {

/// The motion DOFs of a relation with evidence, all of which has been checked.
MotionNumbers CheckRelation(const Value& relation);

/// ExpectKeys with the keys of every certificate added.
void ExpectCertificateKeys(const Value& certificate, std::initializer_list<std::string_view> required,
                           std::initializer_list<std::string_view> optional = {});

void CheckMotionDofs(const Value& certificate);
/// Why the world was not counted again; empty if it was.
std::string CheckCensus(const Value& certificate);
void CheckTransitions(const Value& certificate);
/// The members of `transitions` but its frame; the relations' motion DOFs, in order.
std::vector<MotionNumbers> CheckRelationsAndTransitions(const Value& certificate);
void CheckMotionPath(const Value& certificate);
void CheckBasis(const Value& certificate);
void CheckIllReducedSingular(const Value& certificate);
void CheckDofClasses(const Value& certificate);
/// One move between two codes of a rope's diagram.
void CheckKnotMove(const Value& certificate);
/// A pair of codes on which a rule of the thesis misses a move or accepts where there is none.
void CheckKnotRule(const Value& certificate);
void CheckKnotTying(const Value& certificate);
/// A rope's curve in space, seen along z.
void CheckKnotDrawing(const Value& certificate);
/// A second drawing of a knot graph on a sphere.
void CheckKnotEmbedding(const Value& certificate);
/// P-data on which the thesis' search for faces goes wrong.
void CheckKnotFaceSearch(const Value& certificate);
/// P-data of no sphere whose irreducible parts are of one each.
void CheckKnotParts(const Value& certificate);
/// A barycentric subdivision that is not three-connected.
void CheckKnotSubdivision(const Value& certificate);
/// Polynomial equations that follow from given ones.
void CheckIdentity(const Value& certificate);
/// Values at which the given equations hold and another does not.
void CheckNoIdentity(const Value& certificate);

}  // namespace tact::check
