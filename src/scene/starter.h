#pragma once
#include "contact/blank_stiffness.h"
#include "findings/report.h"
#include "model/model.h"

#include <span>

namespace drawbead {

/// What the Starter will print about the drawbeads, as numbers of messages and user ids; one verdict per
/// interface, as Model::drawbeads().
StarterMessages starter_messages(const Model&, std::span<const StarterVerdict>);

} // namespace drawbead
