#pragma once
// Expands groups, surfaces and sets into nodes, elements and segments once the tables are read.
#include "model/boxes.h"
#include "model/node_set.h"
#include "model/part_picker.h"
#include "model/row_set.h"
#include "model/sets.h"
#include "model/table_reader.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace drawbead {

/// Elements as rows of the three tables.
struct ElementRows {
    RowSet shells4, shells3, solids;

    bool empty() const { return shells4.empty() && shells3.empty() && solids.empty(); }
};
ElementRows unite(const ElementRows&, const ElementRows&);
ElementRows subtract(const ElementRows&, const ElementRows&);
ElementRows intersect(const ElementRows&, const ElementRows&);

/// Rows [begin, end) of a shell table as segments of one sense.
struct SegmentRun {
    uint32_t begin = 0, end = 0;
    int8_t sense = 1;
};

/// A surface before its segments are written out.
struct SurfaceContent {
    std::vector<std::vector<ListedSegment>>
        listed; ///< SEG lines in order, in chunks; reversed where a sign says so
    std::vector<SegmentRun> shells4, shells3; ///< ascending within each surface of a surface of surfaces
    std::vector<Segment> faces;               ///< of solids, or of DSURF
    bool ordered = false;                     ///< `faces` stand in the solver's order (DSURF)
    bool evaluated = true;
};

/// Marks an option as being expanded for as long as it lives; false when it is so already (or 200 deep).
class OpenOption {
public:
    OpenOption(std::vector<BlockIndex>& open, BlockIndex block) : open_(open) {
        entered_ = std::find(open.begin(), open.end(), block) == open.end() && open.size() < 200;
        if (entered_) open.push_back(block);
    }
    ~OpenOption() {
        if (entered_) open_.pop_back();
    }
    OpenOption(const OpenOption&) = delete;
    OpenOption& operator=(const OpenOption&) = delete;
    explicit operator bool() const { return entered_; }

private:
    std::vector<BlockIndex>& open_;
    bool entered_;
};

class Resolver {
public:
    Resolver(const Deck&, const OptionIndex&, const PartPicker&, const Tables&, IssueLog&, unsigned threads);

    /// A node group (or set) as an interface takes it.
    NodeGroup group(int64_t id, BlockIndex);
    /// The nodes of a group, without order; `only` restricts the work to some nodes. False when the group
    /// cannot be expanded, which is reported.
    bool nodes(BlockIndex group, NodeSet& set, const NodeSet* only = nullptr);
    bool lists_nodes(BlockIndex group) const { return is_node_list(deck_.blocks()[group].keyword); }

    /// Likewise the nodes of one reference.
    bool member_nodes(const Member& member, NodeSet& set, const NodeSet* only = nullptr) {
        return add_member_nodes(member, set, only);
    }

    SurfaceContent surface(BlockIndex);
    std::vector<SurfaceSource> sources(BlockIndex);

    void report(ReadIssue::Kind, Span place, std::string subject, std::string detail = {});
    /// Row of a global node id.
    std::optional<NodeRow> row(int64_t id) const;

private:
    struct Signed {
        ElementRows plus, minus;
    };
    struct SetContent {
        ElementRows plus, reversed;
        RowSet all_faces; ///< solids of which every face counts
        NodeSet nodes;
        std::vector<ListedSegment> segments;
        bool evaluated = true;
    };

    // Elements: resolver_elements.cpp
    ElementRows elements(const Member&, bool& supported);
    ElementRows element_group(BlockIndex, bool& supported);
    Signed signed_elements(const Membership&, bool& supported);
    ElementRows rows_of_parts(const std::vector<uint32_t>& parts) const;
    ElementRows rows_in_box(const Member&, bool& supported);
    std::optional<NodeSet> nodes_in_box(const Member&);

    // Nodes: resolver_nodes.cpp
    void add_nodes(const ElementRows&, NodeSet&, const NodeSet* only) const;
    bool add_member_nodes(const Member&, NodeSet&, const NodeSet* only);
    void add_listed_nodes(const Block&, NodeSet&, const NodeSet* only);
    void add_node_range(const Member&, NodeSet&, const NodeSet* only) const;
    void add_surface_nodes(const SurfaceContent&, NodeSet&, const NodeSet* only) const;
    bool ordered_nodes(BlockIndex, NodeGroup*, std::vector<NodeRow>&);
    std::vector<NodeRow> by_user_id(const NodeSet&) const;
    void take_set_nodes(BlockIndex, NodeGroup&);

    // Surfaces: resolver_surfaces.cpp
    SetContent set_content(BlockIndex, bool with_nodes);
    SurfaceContent surface_of_set(BlockIndex);
    SurfaceContent surface_of_surfaces(BlockIndex, const Membership&);
    SurfaceContent difference(BlockIndex, const Membership&);
    SurfaceContent shells_and_faces(const Signed&, Faces) const;
    void add_faces(const RowSet& solids, Faces, const ElementRows& coating, std::vector<Segment>&) const;

    const Deck& deck_;
    const OptionIndex& index_;
    const PartPicker& picker_;
    const Tables& tables_;
    IssueLog& issues_;
    unsigned threads_;
    std::map<PartId, std::vector<RowRun>> shells4_of_, shells3_of_, solids_of_;
    std::array<std::map<BlockIndex, NodeSet>, 2>
        group_cache_; ///< groups that other groups refer to: whole, restricted
    std::map<BlockIndex, std::optional<ElementRows>>
        element_cache_; ///< groups of elements that something refers to; empty: they cannot be expanded
    std::array<std::map<BlockIndex, SetContent>, 2>
        set_cache_;                ///< sets that other sets refer to: without and with nodes
    std::vector<BlockIndex> open_; ///< options being expanded, against recursion
    std::set<std::pair<uint64_t, uint64_t>> reported_;
};

/// Whether four nodes in order make a segment after equal neighbours were merged; brings them to n1 n2 n3 n3
/// and says whether that changed them.
bool normalise(std::array<NodeRow, 4>& nodes, bool& repaired);

/// Writes the segments of a surface: SEG lines, quadrilaterals, triangles, faces. Gives the SEG lines of
/// `content` free.
void write_segments(SurfaceContent& content, const Tables&, unsigned threads, Surface&);

/// Finds the elements behind the SEG lines of a surface and turns what has a solid behind it outward.
/// `stronger` says whether the first of two shells (kind and row) gives the stiffness.
struct ShellRef {
    ElementKind kind = ElementKind::none;
    uint32_t row = 0;
};
void find_elements_behind(const Tables&, unsigned threads,
                          const std::function<bool(ShellRef, ShellRef)>& stronger, Surface&);
/// Turns the faces of solids outward.
void turn_faces_outward(const Tables&, Surface&);

} // namespace drawbead
