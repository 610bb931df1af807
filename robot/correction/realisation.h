/// @file
/// A pose that satisfies a contact relation, from nothing but the elements in contact.
/// Model   The sum of squares of the gaps and of every violated inequality (contact_problem.h), least by the method of
///         Levenberg and Marquardt, from the pose given and from it turned to 24 cube orientations.
/// Exact   no; none found does not prove that there is none.
#pragma once

#include "robot/correction/contact_problem.h"

namespace tact::correction {

std::optional<joint::Transform> FindRealisation(const Models& models,
                                                const std::vector<recognition::PointContact>& contacts,
                                                const joint::Transform& X_FM);

}  // namespace tact::correction
