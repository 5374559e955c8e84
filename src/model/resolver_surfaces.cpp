#include "base/parallel.h"
#include "model/resolver.h"

#include <algorithm>
#include <array>

namespace drawbead {

namespace {

constexpr std::size_t most_set_segments = 50'000'000; ///< sets of sets can double at every level

/// Runs of both senses, ascending.
std::vector<SegmentRun> signed_runs(const RowSet& plus, const RowSet& minus) {
    std::vector<SegmentRun> runs;
    for (const RowRun& run : plus.runs())
        runs.push_back({run.begin, run.end, 1});
    for (const RowRun& run : minus.runs())
        runs.push_back({run.begin, run.end, -1});
    std::sort(runs.begin(), runs.end(),
              [](const SegmentRun& a, const SegmentRun& b) { return a.begin < b.begin; });
    return runs;
}

void reverse(ListedSegment& segment) {
    std::reverse(segment.node.begin(), segment.node.end());
}

/// As a reference with a minus sign does: 4 3 2 1, whatever the segment is made of.
void reverse(SurfaceContent& content) {
    for (auto& chunk : content.listed)
        for (ListedSegment& segment : chunk)
            reverse(segment);
    for (SegmentRun& run : content.shells4)
        run.sense = static_cast<int8_t>(-run.sense);
    for (SegmentRun& run : content.shells3)
        run.sense = static_cast<int8_t>(-run.sense);
    for (Segment& face : content.faces) {
        std::reverse(face.n.begin(), face.n.end());
        face.sense = static_cast<int8_t>(-face.sense);
    }
}

void append(SurfaceContent& to, const SurfaceContent& from) {
    to.listed.insert(to.listed.end(), from.listed.begin(), from.listed.end());
    to.shells4.insert(to.shells4.end(), from.shells4.begin(), from.shells4.end());
    to.shells3.insert(to.shells3.end(), from.shells3.begin(), from.shells3.end());
    to.faces.insert(to.faces.end(), from.faces.begin(), from.faces.end());
    to.evaluated = to.evaluated && from.evaluated;
}

using Corners = std::array<NodeRow, 4>;

Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Faces of a solid by its corners, outward for a solid of positive volume. Mid-side nodes of a 10-node
/// tetrahedron split each face in four.
void solid_faces(SolidKind kind, const std::array<NodeRow, 8>& n, const std::array<NodeRow, 6>* mid,
                 std::vector<Corners>& faces) {
    static constexpr int hexahedron[6][4] = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                             {2, 3, 7, 6}, {1, 2, 6, 5}, {0, 4, 7, 3}};
    static constexpr int pentahedron[5][4] = {
        {0, 2, 1, 1}, {3, 4, 5, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
    static constexpr int tetrahedron[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    // Mid-side node between two corners of a tetrahedron.
    static constexpr int between[4][4] = {{-1, 0, 2, 3}, {0, -1, 1, 4}, {2, 1, -1, 5}, {3, 4, 5, -1}};
    const auto corner = [&](int i) { return n[static_cast<std::size_t>(i)]; };
    switch (kind) {
    case SolidKind::tetra4:
    case SolidKind::tetra10:
        for (const auto& f : tetrahedron) {
            const NodeRow a = corner(f[0]), b = corner(f[1]), c = corner(f[2]);
            const auto middle = [&](int i, int j) {
                return mid ? (*mid)[static_cast<std::size_t>(between[i][j])] : no_node;
            };
            const NodeRow ab = middle(f[0], f[1]), bc = middle(f[1], f[2]), ca = middle(f[2], f[0]);
            if (ab == no_node || bc == no_node || ca == no_node) {
                faces.push_back({a, b, c, c});
                continue;
            }
            faces.push_back({a, ab, ca, ca});
            faces.push_back({ab, b, bc, bc});
            faces.push_back({ca, bc, c, c});
            faces.push_back({ab, bc, ca, ca});
        }
        return;
    case SolidKind::penta6:
        for (const auto& f : pentahedron)
            faces.push_back({corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])});
        return;
    default:
        for (const auto& f : hexahedron)
            faces.push_back({corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])});
    }
}

} // namespace

bool normalise(std::array<NodeRow, 4>& n, bool& repaired) {
    repaired = false;
    if (n[0] != n[1] && n[1] != n[2] && n[3] != n[0] && n[0] != n[2]) {
        if (n[2] == n[3] || n[1] != n[3]) return true; // three or four different nodes in the usual form
        return false;                                  // n2 = n4: no area
    }
    Corners distinct{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i)
        if (n[i] != n[(i + 3) % 4]) distinct[count++] = n[i];
    if (count == 3 && distinct[0] != distinct[2]) {
        n = {distinct[0], distinct[1], distinct[2], distinct[2]};
        repaired = true;
        return true;
    }
    return false;
}

void Resolver::add_faces(const RowSet& solids, Faces which, const ElementRows& coating,
                         std::vector<Segment>& segments) const {
    struct Face {
        Corners key, n;
        uint32_t solid;
        uint32_t order;
    };
    std::vector<Face> faces;
    std::vector<Corners> corners;
    for (const RowRun& run : solids.runs())
        for (uint32_t row = run.begin; row < run.end; ++row) {
            corners.clear();
            solid_faces(tables_.solids.kind[row], tables_.solids.nodes[row],
                        tables_.solids.mid.empty() ? nullptr : &tables_.solids.mid[row], corners);
            for (Corners face : corners) {
                bool repaired = false;
                if (!normalise(face, repaired)) continue; // a face that a repeated node closed
                if (std::find(face.begin(), face.end(), no_node) != face.end()) continue;
                faces.push_back({sorted(face), face, row, static_cast<uint32_t>(faces.size())});
            }
        }
    std::vector<Corners> coated;
    const auto take = [&](const auto& table, const RowSet& rows) {
        for (const RowRun& run : rows.runs())
            for (uint32_t row = run.begin; row < run.end; ++row)
                coated.push_back(sorted(table[row]));
    };
    take(tables_.shells4.nodes, coating.shells4);
    take(tables_.shells3.nodes, coating.shells3);
    std::sort(coated.begin(), coated.end());
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
        return a.key != b.key ? a.key < b.key : a.order < b.order;
    });
    std::vector<Face> kept;
    for (std::size_t i = 0; i < faces.size();) {
        std::size_t end = i + 1;
        while (end < faces.size() && faces[end].key == faces[i].key)
            ++end;
        const bool inner = end - i > 1;
        if (!(inner && which == Faces::external) &&
            !std::binary_search(coated.begin(), coated.end(), faces[i].key))
            kept.insert(kept.end(), faces.begin() + static_cast<std::ptrdiff_t>(i),
                        faces.begin() + static_cast<std::ptrdiff_t>(end));
        i = end;
    }
    std::sort(kept.begin(), kept.end(), [&](const Face& a, const Face& b) {
        const uint32_t ia = tables_.solids.id[a.solid], ib = tables_.solids.id[b.solid];
        return ia != ib ? ia < ib : a.order < b.order;
    });
    std::vector<Corners> shared; // keys that occur twice among the kept ones
    for (const Face& face : kept)
        shared.push_back(face.key);
    std::sort(shared.begin(), shared.end());
    for (const Face& face : kept) {
        Segment segment;
        segment.n = face.n;
        segment.kind = ElementKind::solid;
        segment.element = face.solid;
        const auto same = std::equal_range(shared.begin(), shared.end(), face.key);
        segment.solid_backed = same.second - same.first == 1;
        segments.push_back(segment);
    }
}

SurfaceContent Resolver::shells_and_faces(const Signed& rows, Faces faces) const {
    const ElementRows minus = subtract(rows.minus, rows.plus);
    SurfaceContent content;
    content.shells4 = signed_runs(rows.plus.shells4, minus.shells4);
    content.shells3 = signed_runs(rows.plus.shells3, minus.shells3);
    if (faces != Faces::none) {
        const ElementRows all = unite(rows.plus, minus);
        add_faces(all.solids, faces, all, content.faces);
    }
    return content;
}

SurfaceContent Resolver::surface(BlockIndex index) {
    const Block& block = deck_.blocks()[index];
    SurfaceContent content;
    const OpenOption open(open_, index);
    if (!open) return content;
    if (is_option(block.keyword, "SET")) return surface_of_set(index);
    const std::string_view type = subtype(block.keyword);
    if (type == "SEG") {
        const std::vector<Span> pieces = line_pieces(deck_, list_text(deck_, block));
        content.listed.resize(pieces.size());
        std::vector<IssueLog> logs(pieces.size());
        parallel_for(threads_, pieces.size(), [&](std::size_t p) {
            DataLines lines(deck_, pieces[p]);
            Span line;
            ListedSegment segment;
            std::vector<ListedSegment>& listed = content.listed[p];
            listed.reserve(pieces[p].size() / 51); // full lines of five cells
            while (lines.next_filled(line))
                if (read_segment(deck_, block.scope, line, SegmentLine::plain, logs[p], segment))
                    listed.push_back(segment);
        });
        for (IssueLog& log : logs)
            for (const ReadIssue& issue : log.take())
                report(issue.kind, issue.place, issue.subject, issue.detail);
        return content;
    }
    if (type == "PLANE" || type == "ELLIPS" || type == "MDELLIPS") return content; // no mesh
    const Membership membership = read_membership(deck_, index, issues_);
    const auto refuse = [&] {
        report(ReadIssue::Kind::not_supported, block.header, std::string(block.keyword));
        content.evaluated = false;
        return content;
    };
    if (!membership.supported) return refuse();
    if (type == "SURF") return surface_of_surfaces(index, membership);
    if (type == "DSURF") return difference(index, membership);
    Faces faces = membership.faces;
    for (const Member& member : membership.members) {
        // Bricks give outer faces only, by EXT or FREE; solids in a box are not worked out.
        if (member.kind == MemberKind::brick_group && faces != Faces::external) return refuse();
        const bool box = member.kind == MemberKind::box || member.kind == MemberKind::box_touching;
        if (box && faces != Faces::none) return refuse();
        if (member.kind == MemberKind::line || member.kind == MemberKind::node_group) return refuse();
    }
    bool supported = true;
    const Signed rows = signed_elements(membership, supported);
    if (!supported) return refuse();
    if (faces != Faces::none) {
        const ElementRows all = unite(rows.plus, rows.minus);
        for (const RowRun& run : all.solids.runs())
            for (uint32_t row = run.begin; row < run.end; ++row)
                if (tables_.solids.kind[row] == SolidKind::bric20 ||
                    tables_.solids.kind[row] == SolidKind::shel16)
                    return refuse();
    }
    return shells_and_faces(rows, faces);
}

SurfaceContent Resolver::surface_of_surfaces(BlockIndex, const Membership& membership) {
    SurfaceContent content;
    for (const bool minus : {false, true})
        for (const Member& member : membership.members) {
            if (member.minus != minus) continue;
            const auto other = index_.find(Family::surface, member.first);
            if (!other) {
                report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
                continue;
            }
            SurfaceContent part = surface(*other);
            if (minus) reverse(part);
            append(content, part);
            std::size_t segments = content.faces.size() + content.shells4.size() + content.shells3.size();
            for (const auto& chunk : content.listed)
                segments += chunk.size();
            if (segments > 50'000'000) {
                report(ReadIssue::Kind::not_supported, member.place, "SURF/SURF", "over 50 million segments");
                content.evaluated = false;
                return content;
            }
        }
    return content;
}

/// Union of surfaces without those of negative ids, without duplicates, sorted by nodes; each segment starts
/// at its lowest node and keeps its sense.
SurfaceContent Resolver::difference(BlockIndex, const Membership& membership) {
    struct Entry {
        std::array<uint32_t, 4> key;
        Segment segment;
    };
    SurfaceContent content;
    const auto entries_of = [&](bool minus) {
        std::vector<Entry> entries;
        for (const Member& member : membership.members) {
            if (member.minus != minus) continue;
            const auto other = index_.find(Family::surface, member.first);
            if (!other) {
                report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
                continue;
            }
            SurfaceContent part = surface(*other);
            content.evaluated = content.evaluated && part.evaluated;
            Surface written;
            write_segments(part, tables_, threads_, written);
            for (Segment segment : written.segments) {
                const auto id = [&](NodeRow node) { return tables_.nodes.id[drawbead::index(node)]; };
                const std::size_t corners = segment.n[2] == segment.n[3] ? 3 : 4;
                const auto before = [&](NodeRow a, NodeRow b) { return id(a) < id(b); };
                const auto lowest = std::min_element(segment.n.begin(), segment.n.begin() + corners, before);
                std::rotate(segment.n.begin(), lowest,
                            segment.n.begin() + static_cast<std::ptrdiff_t>(corners));
                if (corners == 3) segment.n[3] = segment.n[2];
                entries.push_back(
                    {{id(segment.n[0]), id(segment.n[1]), id(segment.n[2]), id(segment.n[3])}, segment});
            }
        }
        std::stable_sort(entries.begin(), entries.end(),
                         [](const Entry& a, const Entry& b) { return a.key < b.key; });
        return entries;
    };
    const std::vector<Entry> plus = entries_of(false), minus = entries_of(true);
    for (std::size_t i = 0; i < plus.size(); ++i) {
        if (i > 0 && plus[i].key == plus[i - 1].key) continue;
        const auto at = std::lower_bound(minus.begin(), minus.end(), plus[i].key,
                                         [](const Entry& entry, const auto& key) { return entry.key < key; });
        if (at == minus.end() || at->key != plus[i].key) content.faces.push_back(plus[i].segment);
    }
    content.ordered = true;
    return content;
}

Resolver::SetContent Resolver::set_content(BlockIndex block, bool with_nodes) {
    SetContent content;
    if (with_nodes) content.nodes = NodeSet(tables_.nodes.size());
    NodeSet ordered = content.nodes;
    bool any_ordered = false;
    for (const SetClause& clause : read_set(deck_, index_, block, issues_)) {
        SetContent one;
        if (with_nodes) one.nodes = NodeSet(tables_.nodes.size());
        bool supported = clause.supported;
        for (const Member& member : clause.members) {
            if (member.kind == MemberKind::set) {
                const auto other = index_.find(Family::set, member.first);
                if (!other) {
                    report(ReadIssue::Kind::member_missing, member.place, std::to_string(member.first));
                    continue;
                }
                const OpenOption open(open_, *other);
                if (!open) continue;
                auto& cache = set_cache_[with_nodes ? 1 : 0];
                auto known = cache.find(*other);
                if (known == cache.end()) {
                    SetContent whole = set_content(*other, with_nodes);
                    known = cache.emplace(*other, std::move(whole)).first;
                }
                const SetContent& inner = known->second;
                if (content.segments.size() + one.segments.size() + inner.segments.size() >
                    most_set_segments) {
                    report(ReadIssue::Kind::not_supported, member.place, "SET", "over 50 million segments");
                    content.evaluated = false;
                    return content;
                }
                one.plus = unite(one.plus, inner.plus);
                one.reversed = unite(one.reversed, inner.reversed);
                one.all_faces = unite(one.all_faces, inner.all_faces);
                if (with_nodes) one.nodes.unite(inner.nodes);
                one.segments.insert(one.segments.end(), inner.segments.begin(), inner.segments.end());
                supported = supported && inner.evaluated;
            } else if (member.kind == MemberKind::node) {
                if (with_nodes) add_node_range(member, one.nodes, nullptr);
            } else {
                one.plus = unite(one.plus, elements(member, supported));
                if (with_nodes && member.kind == MemberKind::box)
                    if (const auto inside = nodes_in_box(member)) one.nodes.unite(*inside);
            }
        }
        one.segments.insert(one.segments.end(), clause.segments.begin(), clause.segments.end());
        if (!supported) {
            report(ReadIssue::Kind::not_supported, clause.place,
                   "SET clause " + std::string(deck_.text(clause.place)));
            content.evaluated = false;
            continue;
        }
        if (clause.key == "NODENS") {
            any_ordered = true;
            for (const WrittenId& id : clause.nodes)
                if (const auto node = row(Deck::global_id(id.id, deck_.scope(clause.scope).offsets.node)))
                    if (with_nodes) ordered.insert(*node);
            continue;
        }
        if (with_nodes) {
            add_nodes(unite(one.plus, one.reversed), one.nodes, nullptr);
            for (const ListedSegment& segment : one.segments)
                for (const int32_t id : segment.node)
                    if (const auto node = row(id)) one.nodes.insert(*node);
        }
        if (clause.reversed) {
            std::swap(one.plus, one.reversed);
            for (ListedSegment& segment : one.segments)
                reverse(segment);
        }
        if (clause.all_faces) one.all_faces = unite(one.plus.solids, one.reversed.solids);
        if (clause.remove) {
            const ElementRows gone = unite(one.plus, one.reversed);
            content.plus = subtract(content.plus, gone);
            content.reversed = subtract(content.reversed, gone);
            if (with_nodes) content.nodes.subtract(one.nodes);
        } else if (clause.intersect) {
            const ElementRows kept = unite(one.plus, one.reversed);
            content.plus = intersect(content.plus, kept);
            content.reversed = intersect(content.reversed, kept);
            if (with_nodes) content.nodes.intersect(one.nodes);
        } else {
            content.plus = unite(content.plus, one.plus);
            content.reversed = unite(content.reversed, one.reversed);
            content.all_faces = unite(content.all_faces, one.all_faces);
            if (with_nodes) content.nodes.unite(one.nodes);
            content.segments.insert(content.segments.end(), one.segments.begin(), one.segments.end());
        }
    }
    if (any_ordered) content.nodes = std::move(ordered);
    return content;
}

SurfaceContent Resolver::surface_of_set(BlockIndex block) {
    const SetContent set = set_content(block, false);
    SurfaceContent content;
    content.evaluated = set.evaluated;
    if (!set.evaluated) return content;
    Signed rows{set.plus, set.reversed};
    const RowSet external = subtract(unite(set.plus.solids, set.reversed.solids), set.all_faces);
    rows.plus.solids = rows.minus.solids = {};
    content = shells_and_faces(rows, Faces::none);
    const ElementRows coating = unite(rows.plus, rows.minus);
    add_faces(external, Faces::external, coating, content.faces);
    add_faces(set.all_faces, Faces::all, coating, content.faces);
    content.listed.push_back(set.segments);
    return content;
}

std::vector<SurfaceSource> Resolver::sources(BlockIndex index) {
    using Source = SurfaceSource::Kind;
    const Block& block = deck_.blocks()[index];
    std::vector<SurfaceSource> sources;
    if (is_option(block.keyword, "SET")) {
        for (const SetClause& clause : read_set(deck_, index_, index, issues_))
            sources.push_back({Source::set_clause, 0, clause.place});
        return sources;
    }
    if (block.keyword == "SURF/SEG") {
        sources.push_back({Source::segment_lines, 0, list_text(deck_, block)});
        return sources;
    }
    const std::string_view type = subtype(block.keyword);
    if (type == "PLANE" || type == "ELLIPS" || type == "MDELLIPS") return sources;
    for (const Member& member : read_membership(deck_, index, issues_).members) {
        SurfaceSource source;
        switch (member.kind) {
        case MemberKind::part:
            source.kind = Source::part;
            break;
        case MemberKind::subset:
            source.kind = Source::subset;
            break;
        case MemberKind::material:
            source.kind = Source::material;
            break;
        case MemberKind::property:
            source.kind = Source::property;
            break;
        case MemberKind::shell_group:
            source.kind = Source::shell_group;
            break;
        case MemberKind::sh3n_group:
            source.kind = Source::sh3n_group;
            break;
        case MemberKind::brick_group:
            source.kind = Source::brick_group;
            break;
        case MemberKind::surface:
            source.kind = Source::surface;
            break;
        default:
            source.kind = Source::other;
        }
        source.id = member.minus ? -member.first : member.first;
        source.place = member.place;
        sources.push_back(source);
    }
    return sources;
}

} // namespace drawbead
