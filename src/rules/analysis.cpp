#include "rules/analysis.h"

#include "base/parallel.h"
#include "geometry/segment_shape.h"
#include "rules/limits.h"
#include "rules/srf/near_surface.h"
#include "scene/deck_contact.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace drawbead {

namespace {

/// The bead as its list says: line, limits, totals.
BeadAnalysis analyse_line(const Model& model, const Drawbead& bead) {
    BeadAnalysis a;
    a.bead = &bead;
    if (bead.group) a.group = &model.groups()[*bead.group];
    if (bead.surface) a.surface = &model.surfaces()[*bead.surface];
    if (!a.group) return a;
    a.order_is_the_authors = a.group->order == NodeGroup::Order::unsorted;
    const bool positions = model.nodes().x.size() == model.nodes().size();
    if (!positions) return a;
    for (const NodeRow row : a.group->nodes)
        a.x.push_back(model.nodes()[row]);
    a.line = bead_line(a.x);
    for (std::size_t i = 0; i < a.x.size(); ++i) {
        a.fn.push_back(normal_limit_along(bead.fn_first, bead.fn_last, a.line.s[i], a.line.length));
        a.ft.push_back(limit_along(bead.ft_first, bead.ft_last, a.line.s[i], a.line.length));
        a.fn_total += a.fn_force(i);
        a.ft_total += a.ft_force(i);
    }
    return a;
}

LineLimits line_limits(const Limits& limits) {
    LineLimits out;
    out.gap_ratio = limits.LIN001_ratio;
    out.gap_elements = limits.LIN001_elements;
    out.coincident = limits.LIN003_coincident_steps;
    out.fold_degrees = limits.LIN004_turn_degrees;
    out.corner_degrees = limits.LIN005_turn_degrees;
    out.closed_steps = limits.LIN006_end_steps;
    out.over_element = limits.LIN009_elements;
    out.fine_element = limits.LIN010_elements;
    out.uneven_ratio = limits.LIN011_ratio;
    return out;
}

SideLimits limits_of_sides(const Limits& limits) {
    return {.reach = limits.SRF001_reach_elements,
            .in_surface = limits.SRF004_in_surface_elements,
            .minority = limits.SRF001_minority_share};
}

void check_list(BeadAnalysis& a, const LineLimits& limits) {
    std::vector<uint32_t> node;
    std::vector<double> element;
    for (const NodeRow row : a.group->nodes)
        node.push_back(index(row));
    for (const BeadHit& h : a.hit)
        element.push_back(h.element);
    a.check = check_line(a.x, node, element, limits);
}

/// Of how many nodes one is enough to see whether there is another layer: of a bead whose nodes are closer
/// than the elements under it, one per element, but 8 of them at least; of a long one, 96.
std::size_t layer_step(const BeadAnalysis& a) {
    constexpr std::size_t most = 96, least = 8;
    double element = std::numeric_limits<double>::infinity();
    for (const BeadHit& h : a.hit)
        element = std::min(element, h.element);
    const std::size_t count = a.hit.size();
    const double hop = count > 1 ? a.line.length / static_cast<double>(count - 1) : 0;
    const double nodes = hop > 0 ? std::min(element / hop, 1e6) : 1;
    const std::size_t close = std::min(static_cast<std::size_t>(nodes), count / least);
    return std::max({std::size_t{1}, count / most, close});
}

/// Another layer of the surface as far from bead nodes as the closest one, or little farther. A long bead is
/// looked at every few nodes, and closely only when one of these has found something: layers go on.
void find_other_layers(const NearMesh& mesh, const ClosestSegment& closest, const NormalCone& cone,
                       const Limits& limits, BeadAnalysis& a, unsigned threads) {
    const double ratio = limits.SRF010_ratio, elements = limits.SRF010_elements;
    constexpr std::size_t chunk = 16;
    const auto look = [&](std::size_t i) {
        BeadHit& h = a.hit[i];
        const double distance = h.closest.foot.distance;
        const double within = std::min(ratio * distance, distance + elements * h.element);
        const auto other = closest.other_layer(a.x[i], h.closest, within, &cone);
        if (!other) return;
        h.other_layer = mesh.segment_index[other->segment];
        h.other_layer_distance = other->d;
    };
    const auto look_at_every = [&](std::size_t step) {
        const std::size_t count = (a.hit.size() + step - 1) / step;
        parallel_for(threads, (count + chunk - 1) / chunk, [&](std::size_t piece) {
            for (std::size_t k = piece * chunk; k < std::min(count, (piece + 1) * chunk); ++k)
                look(k * step);
        });
    };
    const std::size_t step = layer_step(a);
    look_at_every(step);
    if (step > 1 &&
        std::any_of(a.hit.begin(), a.hit.end(), [](const BeadHit& h) { return h.other_layer != no_segment; }))
        look_at_every(1);
}

void take(BeadHit& h, const NearMesh& mesh, const ClosestHit& closest) {
    h.closest = closest;
    h.segment = mesh.segment_index[closest.segment];
    h.element = std::sqrt(area(mesh.corners(closest.segment)));
}

/// The hits that the contact has found; whether the part of the surface that it has made is large enough for
/// the rules too.
bool take_hits(const NearMesh& mesh, const std::vector<InterfaceContact>& contact, double side_reach,
               const std::vector<BeadAnalysis*>& beads, unsigned threads) {
    const auto complete = [&](Vec3 x, const BeadHit& h) {
        const double r = h.closest.foot.distance + side_reach * h.element;
        return h.closest.exact && mesh.covers(x - Vec3{r, r, r}, x + Vec3{r, r, r});
    };
    for (BeadAnalysis* a : beads) {
        const auto one = std::find_if(contact.begin(), contact.end(),
                                      [&](const InterfaceContact& c) { return c.bead == a->bead; });
        if (one == contact.end() || one->contact.node.size() != a->x.size()) return false;
        const std::vector<BeadNodeContact>& nodes = one->contact.node;
        a->hit.assign(nodes.size(), {});
        std::atomic<bool> enough = true;
        constexpr std::size_t chunk = 64;
        parallel_for(threads, (nodes.size() + chunk - 1) / chunk, [&](std::size_t piece) {
            const std::size_t end = std::min(nodes.size(), (piece + 1) * chunk);
            for (std::size_t i = piece * chunk; i < end; ++i) {
                if (nodes[i].exact.found()) take(a->hit[i], mesh, nodes[i].exact);
                if (!nodes[i].exact.found() || !complete(a->x[i], a->hit[i])) enough = false;
            }
        });
        if (!enough) return false;
    }
    return true;
}

/// How many elements on either side of the beads of a surface are judged: some, or as far as the beads
/// travel.
double side_reach_of(const Analysis& all, const std::vector<BeadAnalysis*>& beads, double least) {
    constexpr double most = 30; // the part of the surface grows with it
    double reach = least;
    for (const BeadAnalysis* a : beads) {
        const auto b = static_cast<std::size_t>(a - all.beads.data());
        if (b >= all.path.size() || !all.path[b].known()) continue;
        for (const NodePath& node : all.path[b].node)
            if (node.element > 0) reach = std::max(reach, std::min(all.path[b].travel / node.element, most));
    }
    return reach;
}

/// Exact closest segments of all beads of a surface, and the part of the surface around them: from the
/// contact where it is there and large enough.
void find_closest(const Model& model, std::size_t number, const std::vector<BeadAnalysis*>& beads,
                  DeckContact& contact, const Limits& limits, SurfaceAnalysis& out, double side_reach,
                  bool layers, unsigned threads) {
    if (!contact.surfaces.empty()) {
        SurfaceScene& scene = contact.surfaces[number];
        if (!scene.mesh.segment.empty() &&
            take_hits(scene.mesh, contact.interfaces, side_reach, beads, threads)) {
            out.near = std::move(scene.mesh);
            if (!layers) return;
            const ClosestSegment closest(out.near, scene.tree);
            const NormalCone cone(out.near, *scene.tree);
            for (BeadAnalysis* a : beads)
                find_other_layers(out.near, closest, cone, limits, *a, threads);
            return;
        }
    }
    std::vector<Vec3> points;
    for (const BeadAnalysis* a : beads)
        points.insert(points.end(), a->x.begin(), a->x.end());
    const SegmentMesh mesh = segment_mesh(model, model.surfaces()[number]);
    const double elements = side_reach > 0 ? side_reach + 1 : 0;
    double least_margin = 0;
    while (true) {
        NearSurface near = near_surface(mesh, points, elements, least_margin, threads);
        if (near.mesh.segment.empty()) return;
        const ClosestSegment closest(near.mesh);
        double needed = 0; // of margin, by any node that has too little of it
        std::size_t first = 0;
        for (BeadAnalysis* a : beads) {
            a->hit.assign(a->x.size(), {});
            constexpr std::size_t chunk = 128;
            parallel_for(threads, (a->x.size() + chunk - 1) / chunk, [&](std::size_t piece) {
                const std::size_t end = std::min(a->x.size(), (piece + 1) * chunk);
                for (std::size_t i = piece * chunk; i < end; ++i)
                    take(a->hit[i], near.mesh, closest.find(a->x[i]));
            });
            for (std::size_t i = 0; side_reach > 0 && i < a->x.size(); ++i)
                if (const double reach = side_reach * a->hit[i].element; reach > near.margin[first + i])
                    needed = std::max(needed, reach);
            first += a->x.size();
        }
        if (layers && needed == 0) {
            const NormalCone cone(near.mesh, *closest.tree());
            for (BeadAnalysis* a : beads)
                find_other_layers(near.mesh, closest, cone, limits, *a, threads);
        }
        out.near = std::move(near.mesh);
        if (needed == 0) return;
        least_margin = needed;
    }
}

/// Neighbours along the bead: by the list, or by the walk where the list is none; gaps left out.
std::vector<std::pair<uint32_t, uint32_t>> hops_of(const BeadAnalysis& a) {
    std::vector<std::pair<uint32_t, uint32_t>> hops;
    const auto add_pieces = [&](const std::vector<uint32_t>& starts, std::size_t count, auto&& position) {
        for (std::size_t p = 0; p < starts.size(); ++p) {
            const std::size_t end = p + 1 < starts.size() ? starts[p + 1] : count;
            for (std::size_t i = starts[p] + 1; i < end; ++i)
                hops.emplace_back(position(i - 1), position(i));
        }
    };
    const LineWalk& walk = a.check.walk;
    if (!a.order_is_the_authors || a.check.scrambled)
        add_pieces(walk.pieces, walk.order.size(), [&](std::size_t i) { return walk.order[i]; });
    else
        add_pieces(a.check.piece_starts(), a.x.size(),
                   [](std::size_t i) { return static_cast<uint32_t>(i); });
    return hops;
}

void judge(const Surface& surface, const NearMesh& near, SideLimits limits, double side_reach,
           BeadAnalysis& a) {
    if (a.hit.empty() || near.segment.empty()) return;
    constexpr double beside = 0.05; // of the segment, as for the manual law
    std::vector<BeadFoot> feet;
    for (std::size_t i = 0; i < a.hit.size(); ++i) {
        const BeadHit& h = a.hit[i];
        const Segment& s = surface.segments[h.segment];
        feet.push_back({h.closest.segment, a.x[i], h.closest.foot.point, h.closest.d, h.element,
                        h.closest.on_free_edge && h.closest.offset > beside,
                        s.solid_backed && s.kind != ElementKind::solid});
    }
    std::vector<uint8_t> solid_backed(near.segment.size());
    for (std::size_t i = 0; i < near.segment.size(); ++i)
        solid_backed[i] = surface.segments.solid_backed(near.segment_index[i]);
    limits.reach = side_reach;
    a.side = judge_side(near, feet, hops_of(a), solid_backed, limits);
}

} // namespace

Analysis analyse(const Deck& deck, const Model& model, const Limits& limits, Needs needs, unsigned threads,
                 RunFacts run) {
    Analysis out;
    out.run = std::move(run);
    out.beads.reserve(model.drawbeads().size());
    out.surfaces.resize(model.surfaces().size());
    const bool lines = has(needs, analysis_lines);
    for (const Drawbead& bead : model.drawbeads()) {
        out.cards.push_back(card_lines(deck, bead));
        out.beads.push_back(analyse_line(model, bead));
    }

    if (has(needs, analysis_contact)) {
        const double around = has(needs, analysis_sides) ? limits.SRF001_reach_elements : 0;
        out.contact = contact_of(model, {.layer_ratio = 0, .around_elements = around, .threads = threads});
        for (const InterfaceContact& one : out.contact.interfaces)
            out.starter.push_back(one.starter);
        if (has(needs, analysis_motion))
            out.path = bead_paths(model, out.contact, {out.run.prescribed, out.run.end(), threads});
    } else if (has(needs, Needs::coordinates) && has(needs, Needs::blank_elements)) {
        out.starter = starter_of(model, threads);
    }

    std::vector<double> side_reach(out.surfaces.size(), 0.0);
    for (std::size_t s = 0; s < out.surfaces.size(); ++s) {
        const Surface& surface = model.surfaces()[s];
        std::vector<BeadAnalysis*> beads;
        for (BeadAnalysis& a : out.beads)
            if (a.surface == &surface && !a.x.empty()) beads.push_back(&a);
        if (has(needs, analysis_sides))
            side_reach[s] = side_reach_of(out, beads, limits.SRF001_reach_elements);
        if (has(needs, analysis_closest))
            find_closest(model, s, beads, out.contact, limits, out.surfaces[s], side_reach[s],
                         has(needs, analysis_layers), threads);
        if (has(needs, analysis_clashes))
            out.surfaces[s].clashes = edge_clashes(surface.segments, model.nodes().size(), threads);
    }
    if (!lines) return out;
    const LineLimits list_limits = line_limits(limits);
    const SideLimits side_limits = limits_of_sides(limits);
    parallel_for(threads, out.beads.size(), [&](std::size_t i) {
        BeadAnalysis& a = out.beads[i];
        if (a.x.empty()) return;
        check_list(a, list_limits);
        if (has(needs, analysis_sides) && a.surface)
            judge(*a.surface, out.surfaces[*a.bead->surface].near, side_limits, side_reach[*a.bead->surface],
                  a);
    });
    return out;
}

} // namespace drawbead
