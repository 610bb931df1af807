/// @file
/// Steps between contact relations and DOF-transitions for people, as JSON and as CSV.
/// JSON    {"translation_steps":[{"definition","pairs":N,"list":[{"from":[m,d,c],"to":[m,d,c]}]}],
///         "class_steps":[{"added":"contact"|"edge"|"face","additions":N,"steps":N,"definitions":[{"name","indices":[names],
///         "pairs":N,"within":N,"list":[{"from":[...],"to":[...],"count":N,"witness":{"relation":{"contacts":[...]},
///         "added":{"contacts":[...]}}}]}]}],"maintaining_to_constraining":[{"added","motion","steps":N,
///         "witness":...}],"dof_transitions":[{"motion","from","to","practical":bool,"occurs":bool,
///         "forced_by_counts":bool,"witness":{"story","backwards":bool,"before":{"contacts":[...],"dof":{...}},"after":{...},
///         "path":{"kind":"line","direction":[...]}|{"kind":"rotation","center":[...],"axis":[...]},"moving":[[corners]],
///         "fixed":[[corners]]}}],"world":{"name","sentence","contacts","largest"},"relations":N};
///         `maintaining_to_constraining` counts the steps after which a motion has fewer maintaining and more constraining
///         DOFs, `within` those that stay in their class, `pairs` ordered pairs of different classes; a world's `largest`
///         counts a relation with one contact added. Of a witness read backwards, `before` is the path's end; moving
///         pieces stand where the path starts; the quaternion (1, s axis) turns them, s from 0 to 1.
/// CSV     a line a step of the finest definition: what is added, the indices before and after, steps, the witness.
#pragma once

#include <string>

#include "provers/report/dof_transition_page.h"

namespace tact::cli {

std::string ToTable(const provers::DofTransitionFindings& findings);
std::string ToJson(const provers::DofTransitionFindings& findings, const std::string& world_name);
std::string ToCsv(const provers::DofTransitionFindings& findings);

}  // namespace tact::cli
