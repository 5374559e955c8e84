#include "scene/interface_rank.h"

#include <algorithm>
#include <string_view>

namespace drawbead {

namespace {

/// What the solver counts as an interface: sub-interfaces are for output.
bool is_interface(std::string_view keyword) {
    return keyword.substr(0, 6) == "INTER/" && keyword != "INTER/SUB";
}

} // namespace

std::vector<int64_t> interface_ranks(const Model& model) {
    std::vector<BlockIndex> interfaces; // blocks of all types
    for (BlockIndex i = 0; i < model.deck().blocks().size(); ++i)
        if (is_interface(model.deck().blocks()[i].keyword)) interfaces.push_back(i);
    std::vector<int64_t> ranks;
    for (const Drawbead& bead : model.drawbeads())
        ranks.push_back(1 + std::lower_bound(interfaces.begin(), interfaces.end(), bead.block) -
                        interfaces.begin());
    return ranks;
}

} // namespace drawbead
