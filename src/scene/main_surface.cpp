#include "scene/main_surface.h"

#include "base/parallel.h"

#include <algorithm>
#include <utility>

namespace drawbead {

namespace {

static_assert(sizeof(NodeRow) == sizeof(uint32_t), "segments are seen through SegmentArray");

uint32_t range_at(const std::vector<ElementRange>& ranges, uint32_t row) {
    const auto range = std::upper_bound(ranges.begin(), ranges.end(), row,
                                        [](uint32_t r, const ElementRange& one) { return r < one.row_end; });
    return static_cast<uint32_t>(range - ranges.begin());
}

/// The eight corners of a solid as the solver stores it: a tetrahedron repeats its nodes as 11224334, a
/// wedge as 12314564. Empty when a corner does not exist.
std::optional<std::array<Vec3, 8>> stored_corners(const Model& model, uint32_t row) {
    using Places = std::array<uint8_t, 8>;
    static constexpr Places brick{0, 1, 2, 3, 4, 5, 6, 7}, tetra{0, 0, 1, 1, 3, 2, 2, 3},
        wedge{0, 1, 2, 0, 3, 4, 5, 3};
    const SolidTable& table = model.solids();
    const SolidKind kind = table.kind[row];
    const Places& place = kind == SolidKind::tetra4 || kind == SolidKind::tetra10 ? tetra
                          : kind == SolidKind::penta6                             ? wedge
                                                                                  : brick;
    std::array<Vec3, 8> corners;
    for (std::size_t k = 0; k < 8; ++k) {
        const NodeRow node = table.nodes[row][place[k]];
        if (node == no_node) return {};
        corners[k] = model.nodes()[node];
    }
    return corners;
}

} // namespace

SegmentMesh segment_mesh(const Model& model, const Surface& surface) {
    SegmentMesh mesh;
    mesh.segment =
        SegmentArray(surface.segments.first_nodes(), surface.segments.size(), surface.segments.stride());
    mesh.x = model.nodes().x.span();
    mesh.node_id = model.nodes().id.span();
    if (!surface.in_storage_order)
        mesh.storage_key = [&](uint32_t segment) { return model.storage_key(surface, segment); };
    return mesh;
}

SurfaceStiffness::SurfaceStiffness(const Model& model, const Surface& surface, unsigned threads)
    : model_(model), surface_(surface), shells4_(ranges_of(model, model.shells4().ranges, false)),
      shells3_(ranges_of(model, model.shells3().ranges, false)),
      solids_(ranges_of(model, model.solids().ranges, true)), same_(same_everywhere()) {
    if (same_)
        smallest_ = (*this)(0).smallest;
    else
        look_at_all(threads);
}

std::vector<SurfaceStiffness::Range>
SurfaceStiffness::ranges_of(const Model& model, const std::vector<ElementRange>& ranges, bool solids) {
    constexpr int sandwich = 11, stack = 17, laminate = 51, composite = 52;
    std::vector<Range> out;
    out.reserve(ranges.size());
    for (const ElementRange& range : ranges) {
        Range one;
        const Part* part = model.part(range.part);
        const Property* property = part ? model.property(part->property) : nullptr;
        const Material* material = part ? model.material(part->material) : nullptr;
        const std::string name = "part " + std::to_string(range.part);
        if (!part)
            one.doubt = name + " does not exist";
        else if (!material)
            one.doubt = name + ": material " + std::to_string(part->material) + " does not exist";
        else if (material->stiffness == Material::Stiffness::unknown)
            one.doubt = name + ": the modulus of material " + std::to_string(material->id) + " (" +
                        material->law + ") is not known";
        else if (material->stiffness == Material::Stiffness::encrypted)
            one.doubt = name + ": material " + std::to_string(material->id) + " is encrypted";
        else if (!solids && !property)
            one.doubt = name + ": property " + std::to_string(part->property) + " does not exist";
        else if (!solids && !property->has_thickness)
            one.doubt =
                name + ": the thickness of property " + std::to_string(property->id) + " is not known";
        else {
            one.known = true;
            one.modulus = solids ? material->bulk : material->young;
            if (!solids) {
                const int type = property->type;
                one.thickness = property->thickness;
                one.element_thickness = type == stack || type == laminate || type == composite;
                if (one.element_thickness || type == sandwich)
                    one.doubt = name + ": property " + std::to_string(property->id) +
                                " is layered; its own modulus may count in place of the material's";
            }
        }
        out.push_back(std::move(one));
    }
    return out;
}

SegmentStiffness SurfaceStiffness::of_shell_row(const ShellTable& table, const std::vector<Range>& ranges,
                                                uint32_t row) const {
    const uint32_t at = range_at(table.ranges, row);
    if (at >= ranges.size() || !ranges[at].known) return {};
    const Range& range = ranges[at];
    const double own = range.element_thickness ? table.own_thickness(row) : 0;
    return of_shell(range.modulus, own > 0 ? own : range.thickness);
}

SegmentStiffness SurfaceStiffness::of_face(const Segment& s, uint32_t solid) const {
    const uint32_t at = range_at(model_.solids().ranges, solid);
    if (at >= solids_.size() || !solids_[at].known) return {};
    const std::optional<std::array<Vec3, 8>> corners = stored_corners(model_, solid);
    if (!corners) return {};
    Corners face;
    for (std::size_t k = 0; k < 4; ++k)
        face[k] = model_.nodes()[s.n[k]];
    return of_solid_face(area(face), solids_[at].modulus, one_point_volume(*corners));
}

SegmentStiffness SurfaceStiffness::operator()(uint32_t segment) const {
    const Segment& s = surface_.segments[segment];
    switch (s.kind) {
    case ElementKind::none:
        return {};
    case ElementKind::solid:
        return of_face(s, s.element);
    case ElementKind::shell4:
    case ElementKind::shell3:
        break;
    }
    const bool quad = s.kind == ElementKind::shell4;
    const SegmentStiffness shell =
        of_shell_row(quad ? model_.shells4() : model_.shells3(), quad ? shells4_ : shells3_, s.element);
    const auto solid =
        std::lower_bound(surface_.coated.begin(), surface_.coated.end(), segment,
                         [](const CoatedSolid& one, uint32_t wanted) { return one.segment < wanted; });
    if (solid == surface_.coated.end() || solid->segment != segment) return shell;
    return coated(of_face(s, solid->solid), shell);
}

/// Whether that can be said without looking at the segments: shells only, and all that were read alike.
bool SurfaceStiffness::same_everywhere() const {
    if (surface_.segments.empty() || !surface_.lines.empty() || !solids_.empty()) return false;
    const Range* first = nullptr;
    for (const auto* ranges : {&shells4_, &shells3_})
        for (const Range& one : *ranges) {
            if (!one.known || !one.doubt.empty() || one.element_thickness) return false;
            if (!first) first = &one;
            if (one.modulus != first->modulus || one.thickness != first->thickness) return false;
        }
    return first != nullptr;
}

/// The minimum over all segments, and which parts lie behind them.
void SurfaceStiffness::look_at_all(unsigned threads) {
    struct Found {
        double smallest = std::numeric_limits<double>::infinity();
        std::vector<uint8_t> used[3];
    };
    constexpr std::size_t piece = 1 << 16;
    const std::size_t count = surface_.segments.size();
    std::vector<Found> found((count + piece - 1) / piece);
    const std::vector<ElementRange>* tables[3]{&model_.shells4().ranges, &model_.shells3().ranges,
                                               &model_.solids().ranges};
    const std::vector<Range>* ranges[3]{&shells4_, &shells3_, &solids_};
    parallel_for(threads, found.size(), [&](std::size_t p) {
        Found& mine = found[p];
        for (int t = 0; t < 3; ++t)
            mine.used[t].assign(tables[t]->size(), 0);
        // Neighbours mostly come from one range: its minimum is taken once.
        int last = -1;
        uint32_t begin = 0, end = 0;
        for (std::size_t i = p * piece; i < std::min(count, (p + 1) * piece); ++i) {
            const Segment& s = surface_.segments[i];
            if (s.kind == ElementKind::none) continue;
            const int t = s.kind == ElementKind::shell4 ? 0 : s.kind == ElementKind::shell3 ? 1 : 2;
            if (t == last && s.element >= begin && s.element < end) continue;
            const uint32_t at = range_at(*tables[t], s.element);
            if (at >= tables[t]->size()) continue;
            mine.used[t][at] = 1;
            mine.smallest = std::min(mine.smallest, (*this)(static_cast<uint32_t>(i)).smallest);
            const bool alike = t < 2 && !(*ranges[t])[at].element_thickness;
            last = alike ? t : -1;
            begin = (*tables[t])[at].row_begin, end = (*tables[t])[at].row_end;
        }
    });
    // A solid under a shell counts whatever the range of the shell.
    for (const CoatedSolid& one : surface_.coated)
        smallest_ = std::min(smallest_, (*this)(one.segment).smallest);
    for (const Found& one : found)
        smallest_ = std::min(smallest_, one.smallest);
    for (int t = 0; t < 3; ++t)
        for (std::size_t r = 0; r < tables[t]->size(); ++r) {
            const std::string& doubt = (*ranges[t])[r].doubt;
            const bool used = std::any_of(found.begin(), found.end(),
                                          [&](const Found& one) { return one.used[t][r] != 0; });
            if (used && !doubt.empty() && std::find(doubts_.begin(), doubts_.end(), doubt) == doubts_.end())
                doubts_.push_back(doubt);
        }
}

std::vector<double> SurfaceStiffness::in_storage_order(std::size_t count) const {
    const auto segments = static_cast<uint32_t>(surface_.segments.size());
    count = std::min<std::size_t>(count, segments);
    std::vector<double> k(count);
    if (same_) {
        std::fill(k.begin(), k.end(), (*this)(0).k);
        return k;
    }
    if (surface_.in_storage_order) {
        for (std::size_t i = 0; i < count; ++i)
            k[i] = (*this)(static_cast<uint32_t>(i)).k;
        return k;
    }
    std::vector<std::pair<uint64_t, uint32_t>> order;
    order.reserve(segments);
    for (uint32_t s = 0; s < segments; ++s)
        order.emplace_back(model_.storage_key(surface_, s), s);
    if (count < order.size())
        std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < count; ++i)
        k[i] = (*this)(order[i].second).k;
    return k;
}

} // namespace drawbead
