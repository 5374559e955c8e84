#include "force/moving_surface.h"

#include <algorithm>

namespace drawbead {

void MovingSurface::bring(uint32_t node, uint32_t n) {
    const MotionSteps& m = steps_[surface_.motion[node]];
    if (m.turns) {
        x_[node] = m.placements[n](surface_.mesh.x[node]);
    } else if (!m.increment.empty()) {
        Vec3 x = x_[node];
        for (uint32_t step = stamp_[node]; step < n;)
            x += m.increment[++step];
        x_[node] = x;
    }
    stamp_[node] = n;
}

void MovingSurface::bring_segment(uint32_t segment, std::size_t n) {
    for (const uint32_t node : surface_.mesh.segment[segment])
        at(node, n);
}

void MovingSurface::find_rings(uint32_t node) {
    const NearMesh& mesh = surface_.mesh;
    std::vector<uint32_t>& rings = rings_[node];
    rings.push_back(node);
    for (const uint32_t s : mesh.segments_around(node))
        for (const uint32_t next : mesh.segment[s])
            for (const uint32_t t : mesh.segments_around(next))
                rings.insert(rings.end(), mesh.segment[t].begin(), mesh.segment[t].end());
    std::sort(rings.begin(), rings.end());
    rings.erase(std::unique(rings.begin(), rings.end()), rings.end());
}

} // namespace drawbead
