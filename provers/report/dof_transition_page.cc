#include "provers/report/dof_transition_page.h"

#include "provers/report/html.h"

namespace tact::provers {

std::string DofTransitionPage(const DofTransitionFindings&) { return PageHtml("tact", ""); }

}  // namespace tact::provers
