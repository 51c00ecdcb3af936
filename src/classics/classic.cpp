// Calls a classic by its enumerator.
#include <oblast/classics.h>

#include "base/check_options.h"

namespace oblast {
using namespace internal;

RegionSet classic(ClassicMethod method, const RegionView& a, const RegionView& b, Operation operation,
                  ClassicReport* report, const CallOptions& options) {
  check_enumerator(method, ClassicMethod::margalit_knott, "ClassicMethod");
  check_operation(operation);
  switch (method) {
    case ClassicMethod::orourke:
      return orourke(a, b, operation, report, options);
    case ClassicMethod::sutherland_hodgman:
      if (operation != Operation::intersection)
        throw Error(
            ErrorCode::precondition,
            "Sutherland-Hodgman: the method has only the intersection; for other operations use Weiler-Atherton or "
            "overlay instead");
      return sutherland_hodgman(a, b, report, options);
    case ClassicMethod::weiler_atherton:
      return weiler_atherton(a, b, operation, report, options);
    case ClassicMethod::margalit_knott:
      return margalit_knott(a, b, operation, report, options);
  }
  throw Error(ErrorCode::bad_option, "there is no such classic method");
}

}  // namespace oblast
