#pragma once
#include <functional>
#include <optional>
#include <string_view>

namespace drawbead {

/// Value of an arithmetic expression as /PARAMETER/…_EXPR writes it: + - * / ^ ** ( ), numbers, the usual
/// functions, names (with or without &). Empty when it cannot be evaluated or is not finite.
std::optional<double> evaluate_expression(std::string_view text,
                                          const std::function<std::optional<double>(std::string_view)>& name);

} // namespace drawbead
