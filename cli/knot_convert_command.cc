#include "algebra/error.h"
#include "cli/commands.h"

namespace tact::cli {

ExitStatus RunKnotConvert(const KnotOptions&) { throw InputError("not built yet"); }

}  // namespace tact::cli
