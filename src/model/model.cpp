#include "model/model.h"

namespace drawbead {

namespace {

template <class Entity>
const Entity* find(const std::vector<Entity>& entities, const std::map<int64_t, uint32_t>& rows, int64_t id) {
    const auto row = rows.find(id);
    return row == rows.end() ? nullptr : &entities[row->second];
}

} // namespace

const Part* Model::part(PartId id) const {
    return find(parts_, part_index_, id);
}

const Property* Model::property(PropertyId id) const {
    return find(properties_, property_index_, id);
}

const Material* Model::material(MaterialId id) const {
    return find(materials_, material_index_, id);
}

std::span<const Attachment> Model::attachments(NodeRow row) const {
    const auto found = attachments_.find(index(row));
    if (found == attachments_.end()) return {};
    return found->second;
}

ElementId Model::element_id(const Segment& segment) const {
    switch (segment.kind) {
    case ElementKind::shell4:
        return ElementId{shells4_.id[segment.element]};
    case ElementKind::shell3:
        return ElementId{shells3_.id[segment.element]};
    case ElementKind::solid:
        return ElementId{solids_.id[segment.element]};
    case ElementKind::none:
        break;
    }
    return ElementId{0};
}

const Part* Model::part_of(const Segment& segment) const {
    switch (segment.kind) {
    case ElementKind::shell4:
        return part(shells4_.part(segment.element));
    case ElementKind::shell3:
        return part(shells3_.part(segment.element));
    case ElementKind::solid:
        return part(solids_.part(segment.element));
    case ElementKind::none:
        break;
    }
    return nullptr;
}

const Property* Model::property_of(const Segment& segment) const {
    const Part* owner = part_of(segment);
    return owner ? property(owner->property) : nullptr;
}

const Material* Model::material_of(const Segment& segment) const {
    const Part* owner = part_of(segment);
    return owner ? material(owner->material) : nullptr;
}

double Model::own_thickness(const Segment& segment) const {
    switch (segment.kind) {
    case ElementKind::shell4:
        return shells4_.own_thickness(segment.element);
    case ElementKind::shell3:
        return shells3_.own_thickness(segment.element);
    default:
        return 0;
    }
}

uint64_t Model::storage_key(const Surface& surface, uint32_t segment) const {
    // Class, element id, place in the surface: 2, 31 and 31 bits.
    if (surface.type == "DSURF" || segment < surface.lines.size()) return segment;
    const Segment& s = surface.segments[segment];
    const uint64_t rank = s.kind == ElementKind::shell4 ? 1 : s.kind == ElementKind::shell3 ? 2 : 3;
    return rank << 62 | uint64_t{value(element_id(s))} << 31 | segment;
}

Span Model::element_line(const Segment& segment) const {
    switch (segment.kind) {
    case ElementKind::shell4:
        return row_line(*deck_, shells4_.pieces, segment.element);
    case ElementKind::shell3:
        return row_line(*deck_, shells3_.pieces, segment.element);
    case ElementKind::solid:
        return row_line(*deck_, solids_.pieces, segment.element);
    case ElementKind::none:
        break;
    }
    return {};
}

} // namespace drawbead
