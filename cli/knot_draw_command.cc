#include "algebra/error.h"
#include "cli/commands.h"

namespace tact::cli {

ExitStatus RunKnotDraw(const KnotOptions&) { throw InputError("not built yet"); }

}  // namespace tact::cli
