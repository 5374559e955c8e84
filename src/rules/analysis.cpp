#include "rules/analysis.h"

namespace drawbead {

Analysis analyse(const Deck&, const Model&, Needs, unsigned) {
    return {};
}

} // namespace drawbead
