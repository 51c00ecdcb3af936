// The places where a result is wrong: they must lie within the bound of an input edge, and be no larger than the bound
// times the length of all edges.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "verify/slabs.h"
#include "verify/sources.h"
#include "verify/verify.h"

namespace oblast::verify {

/// Calls its argument for each trapezoid where the result is wrong. It is called a second time where estimates of the
/// area do not decide.
using ForEachWrong = std::function<void(const std::function<void(const Trapezoid&)>& visit)>;

/// A fault if a wrong place is not near an input edge ("around (x, y) " and `wrong_here`), or if all of them together
/// are too large (`too_large`).
std::optional<Fault> judge_wrong_places(const ForEachWrong& for_each_wrong, const Sources& sources,
                                        const std::string& wrong_here, const std::string& too_large);

}  // namespace oblast::verify
