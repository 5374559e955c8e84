#include "scene/starter.h"

#include <algorithm>
#include <set>

namespace drawbead {

StarterMessages starter_messages(const Model& model, std::span<const StarterVerdict> verdicts) {
    StarterMessages out;
    std::set<int> all;
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const Drawbead& bead = model.drawbeads()[i];
        const StarterVerdict& verdict = verdicts[i];
        StarterMessages::Interface one;
        one.id = bead.id;
        if (verdict.error_112) one.messages.push_back(112);
        if (!verdict.nodes_346.empty()) one.messages.insert(one.messages.end(), {346, 499});
        if (verdict.error_703) one.messages.push_back(703);
        if (verdict.warning_1040) one.messages.push_back(1040);
        if (verdict.warning_1043) one.messages.push_back(1043);
        for (const uint32_t place : verdict.nodes_346) {
            const NodeRow row = model.groups()[*bead.group].nodes[place];
            one.nodes_346.push_back(value(model.nodes().user_id(row)));
        }
        std::sort(one.nodes_346.begin(), one.nodes_346.end());
        one.nodes_346.erase(std::unique(one.nodes_346.begin(), one.nodes_346.end()), one.nodes_346.end());
        all.insert(one.messages.begin(), one.messages.end());
        out.interfaces.push_back(std::move(one));
    }
    out.messages.assign(all.begin(), all.end());
    return out;
}

} // namespace drawbead
