#pragma once
// The mechanical content of a deck, as far as drawbeads need it. Built once, then const and shared by
// threads.
#include "base/result.h"
#include "model/entities.h"
#include "model/motion.h"
#include "model/tables.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace drawbead {

/// What a command or rule will look at; the union decides which blocks are read how.
enum class Needs : uint32_t {
    none = 0,
    counts = 1,             ///< how many rows each table has
    coordinates = 2,        ///< node ids and positions
    blank_elements = 4,     ///< elements that main surfaces of drawbeads consist of
    all_element_ids = 8,    ///< ids of all elements, for duplicates
    element_thickness = 16, ///< thickness on element cards
    surface_users = 32,     ///< who else uses a surface or group
    attachments = 64,       ///< what holds the bead nodes
    motion = 128,           ///< what moves the nodes of drawbeads and of their main surfaces
};
constexpr Needs operator|(Needs a, Needs b) {
    return Needs(uint32_t(a) | uint32_t(b));
}
constexpr bool has(Needs set, Needs one) {
    return (uint32_t(set) & uint32_t(one)) != 0;
}

/// What the model's readers met in the cells they read.
struct ReadIssue {
    enum class Kind : uint8_t {
        not_a_number,
        not_finite,
        unknown_parameter,
        id_overflow,
        id_missing,   ///< a table row whose id is 0, blank or negative; it is left out
        duplicate_id, ///< subject: family and id; related: the first definition
        unknown_unit,
        unknown_node,     ///< an element's node does not exist
        not_supported,    ///< an option that would matter and that the tool cannot expand
        property_missing, ///< a part refers to a property that does not exist
        material_missing,
        part_missing,
        member_missing, ///< a group or surface names another that does not exist
    };
    Kind kind;
    Span place;
    std::string subject;
    std::string detail;
    Span related;
    uint64_t count =
        1; ///< how many alike this one stands for: lists are cut, the last one listed counts the rest
};

struct Counts {
    uint64_t nodes = 0, shells4 = 0, shells3 = 0, solids = 0, parts = 0;
};

class Model {
public:
    /// Reads what `needs` asks for. The deck must outlive the model.
    static Model build(const Deck&, Needs needs, unsigned threads);
    /// With Needs::motion: what `targets` name moves instead of what the deck moves.
    static Model build(const Deck&, Needs needs, unsigned threads, std::span<const MotionTarget> targets);

    const Deck& deck() const { return *deck_; }
    const Counts& counts() const { return counts_; }
    const NodeTable& nodes() const { return nodes_; }
    const ShellTable& shells4() const { return shells4_; }
    const ShellTable& shells3() const { return shells3_; }
    const SolidTable& solids() const { return solids_; }

    const Part* part(PartId) const;
    const Property* property(PropertyId) const;
    const Material* material(MaterialId) const;
    /// In deck order.
    const std::vector<Part>& parts() const { return parts_; }
    const std::vector<Property>& properties() const { return properties_; }
    const std::vector<Material>& materials() const { return materials_; }
    const std::vector<Drawbead>& drawbeads() const { return drawbeads_; }
    /// Groups and surfaces that drawbeads use, each once.
    const std::vector<NodeGroup>& groups() const { return groups_; }
    const std::vector<Surface>& surfaces() const { return surfaces_; }
    const std::optional<Admesh>& admesh() const { return admesh_; }
    /// Ipri of /IOFLAG, 0 without it: how much the Starter prints.
    int64_t ipri() const { return ipri_; }
    const std::vector<ReadIssue>& issues() const { return issues_; }

    /// What holds the node; empty unless Needs::attachments, and only for nodes of drawbead groups.
    std::span<const Attachment> attachments(NodeRow) const;

    /// What the deck prescribes of the motion of nodes; empty unless Needs::motion.
    const DeckMotion& motion() const { return motion_; }

    /// The element behind a segment: its user id, part, property and material (nullptr where there is none).
    ElementId element_id(const Segment&) const;
    const Part* part_of(const Segment&) const;
    const Property* property_of(const Segment&) const;
    const Material* material_of(const Segment&) const;
    double own_thickness(const Segment&) const; ///< on the element card, 0 when none
    /// Ascending in the solver's storage order; unique within a surface that lists no element twice.
    uint64_t storage_key(const Surface&, uint32_t segment) const;
    /// The data line of the element behind a segment.
    Span element_line(const Segment&) const;
    Span node_line(NodeRow row) const { return row_line(*deck_, nodes_.pieces, index(row)); }

private:
    friend class ModelBuilder;
    const Deck* deck_ = nullptr;
    Counts counts_;
    NodeTable nodes_;
    ShellTable shells4_, shells3_;
    SolidTable solids_;
    std::vector<Part> parts_;
    std::vector<Property> properties_;
    std::vector<Material> materials_;
    std::map<int64_t, uint32_t> part_index_, property_index_, material_index_;
    std::vector<Drawbead> drawbeads_;
    std::vector<NodeGroup> groups_;
    std::vector<Surface> surfaces_;
    std::optional<Admesh> admesh_;
    int64_t ipri_ = 0;
    std::map<uint32_t, std::vector<Attachment>> attachments_; ///< by node row
    DeckMotion motion_;
    std::vector<ReadIssue> issues_;
};

} // namespace drawbead
