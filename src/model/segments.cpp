#include "base/parallel.h"
#include "model/resolver.h"

#include <algorithm>

namespace drawbead {

namespace {

constexpr uint32_t rows_per_piece = 1u << 16;

/// The part of a run that one thread writes, and where.
struct Piece {
    const ShellTable* table;
    ElementKind kind;
    uint32_t begin, end;
    int8_t sense;
    uint64_t out;
    bool ascending = true, has_hole = false;
};

void add_pieces(const ShellTable& table, ElementKind kind, const std::vector<SegmentRun>& runs, uint64_t& out,
                std::vector<Piece>& pieces) {
    for (const SegmentRun& run : runs)
        for (uint32_t begin = run.begin; begin < run.end; begin += rows_per_piece) {
            const uint32_t end = std::min(run.end, begin + rows_per_piece);
            pieces.push_back({&table, kind, begin, end, run.sense, out});
            out += end - begin;
        }
}

// Rows go from table to segment in registers: a Segment put together in memory and copied waits for its own
// bytes.
void write_piece(Piece& piece, Segment* out) {
    const std::array<NodeRow, 4>* const nodes = piece.table->nodes.data();
    const auto* const id = piece.table->id.data();
    const bool reversed = piece.sense < 0, triangle = piece.kind == ElementKind::shell3;
    const ElementKind kind = piece.kind;
    const int8_t sense = piece.sense;
    uint32_t last_id = 0;
    bool ascending = true, has_hole = false;
    for (uint32_t row = piece.begin; row < piece.end; ++row, ++out) {
        const NodeRow n0 = nodes[row][0], n1 = nodes[row][1], n2 = nodes[row][2], n3 = nodes[row][3];
        Segment& segment = *out;
        if (!reversed)
            segment.n = {n0, n1, n2, n3};
        else if (triangle)
            segment.n = {n2, n1, n0, n0};
        else
            segment.n = {n3, n2, n1, n0};
        segment.element = row;
        segment.kind = kind;
        segment.sense = sense;
        segment.solid_backed = false;
        segment.repaired = false;
        has_hole |= n0 == no_node || n1 == no_node || n2 == no_node || n3 == no_node;
        if (n0 == n1 || n1 == n2 || n2 == n3 || n3 == n0) normalise(segment.n, segment.repaired);
        ascending &= last_id <= id[row];
        last_id = id[row];
    }
    piece.ascending = ascending;
    piece.has_hole = has_hole;
}

/// SEG lines as segments; lines with unknown nodes are kept apart.
struct Written {
    std::vector<Segment> segments;
    std::vector<Span> lines;
    std::vector<int64_t> unknown;
    std::vector<Span> unknown_lines;
};

Written write_listed(const NodeTable& nodes, std::span<const ListedSegment> listed) {
    Written written;
    written.segments.reserve(listed.size());
    written.lines.reserve(listed.size());
    for (const ListedSegment& line : listed) {
        Segment segment;
        bool complete = true;
        for (std::size_t i = 0; i < 4; ++i) {
            const int64_t id = line.node[i];
            const auto row =
                id > 0 && id < 0xffffffff ? nodes.row(NodeId{static_cast<uint32_t>(id)}) : std::nullopt;
            if (row) {
                segment.n[i] = *row;
                continue;
            }
            complete = false;
            if (i == 3 && id == line.node[2]) continue;
            written.unknown.push_back(id);
            written.unknown_lines.push_back(line.line);
        }
        if (!complete) continue;
        normalise(segment.n, segment.repaired);
        written.segments.push_back(segment);
        written.lines.push_back(line.line);
    }
    return written;
}

/// Two vectors across the face; for a triangle two of its sides.
Vec3 face_normal(const NodeTable& nodes, const std::array<NodeRow, 4>& n) {
    const Vec3 a = nodes[n[0]], b = nodes[n[1]], c = nodes[n[2]], d = nodes[n[3]];
    return n[2] == n[3] ? cross(c - a, c - b) : cross(c - a, d - b);
}

/// Reverses the segment when its normal points into the solid.
void turn_outward(const Tables& tables, uint32_t solid, Segment& segment) {
    Vec3 centre, middle;
    double corners = 0;
    for (const NodeRow node : tables.solids.nodes[solid])
        if (node != no_node) {
            centre += tables.nodes[node];
            corners += 1;
        }
    for (const NodeRow node : segment.n)
        middle += tables.nodes[node];
    const Vec3 out = 0.25 * middle - centre / corners;
    if (dot(face_normal(tables.nodes, segment.n), out) >= 0) return;
    if (segment.n[2] == segment.n[3])
        std::swap(segment.n[0], segment.n[1]);
    else
        std::reverse(segment.n.begin(), segment.n.end());
}

/// Whether the rows of a run are segments as they stand; and, then, whether their ids ascend.
struct PlainRun {
    bool plain = true, ascending = true;
};

PlainRun look_at_run(const ShellTable& table, const SegmentRun& run, unsigned threads) {
    const uint32_t count = run.end - run.begin;
    std::vector<PlainRun> found((count + rows_per_piece - 1) / rows_per_piece);
    parallel_for(threads, found.size(), [&](std::size_t p) {
        const auto begin = run.begin + static_cast<uint32_t>(p) * rows_per_piece;
        const uint32_t end = std::min(run.end, begin + rows_per_piece);
        bool plain = true, ascending = true;
        uint32_t last_id = p > 0 ? table.id[begin - 1] : 0;
        for (uint32_t row = begin; row < end; ++row) {
            const std::array<NodeRow, 4>& n = table.nodes[row];
            plain &= n[0] != no_node && n[1] != no_node && n[2] != no_node && n[3] != no_node &&
                     n[0] != n[1] && n[1] != n[2] && n[2] != n[3] && n[3] != n[0];
            ascending &= last_id <= table.id[row];
            last_id = table.id[row];
        }
        found[p] = {plain, ascending};
    });
    PlainRun all;
    for (const PlainRun& one : found) {
        all.plain &= one.plain;
        all.ascending &= one.ascending;
    }
    return all;
}

/// A blank is mostly one run of quads: then its segments need not be written at all.
bool see_in_table(const SurfaceContent& content, const ShellTable& quads, unsigned threads,
                  Surface& surface) {
    const bool one_run = content.listed.empty() && content.shells3.empty() && content.faces.empty() &&
                         content.shells4.size() == 1 && content.shells4[0].sense > 0;
    if (!one_run) return false;
    const SegmentRun& run = content.shells4[0];
    const PlainRun found = look_at_run(quads, run, threads);
    if (!found.plain) return false;
    surface.in_storage_order = found.ascending;
    surface.segments = SegmentList(ElementKind::shell4, run.begin,
                                   quads.nodes.span().subspan(run.begin, run.end - run.begin));
    return true;
}

} // namespace

void write_segments(SurfaceContent& content, const Tables& tables, unsigned threads, Surface& surface) {
    if (see_in_table(content, tables.shells4, threads, surface)) return;
    std::vector<Written> written(content.listed.size());
    parallel_for(threads, written.size(), [&](std::size_t p) {
        written[p] = write_listed(tables.nodes, content.listed[p]);
        content.listed[p] = {};
    });
    uint64_t listed = 0;
    for (const Written& piece : written)
        listed += piece.segments.size();

    uint64_t total = listed;
    std::vector<Piece> pieces;
    add_pieces(tables.shells4, ElementKind::shell4, content.shells4, total, pieces);
    const std::size_t first_triangle = pieces.size();
    add_pieces(tables.shells3, ElementKind::shell3, content.shells3, total, pieces);
    const uint64_t first_face = total;
    total += content.faces.size();

    Buffer<Segment> segments(total);
    uint64_t at = 0;
    surface.lines.reserve(listed);
    for (const Written& piece : written) {
        std::copy(piece.segments.begin(), piece.segments.end(), segments.begin() + at);
        at += piece.segments.size();
        surface.lines.insert(surface.lines.end(), piece.lines.begin(), piece.lines.end());
        surface.unknown_nodes.insert(surface.unknown_nodes.end(), piece.unknown.begin(), piece.unknown.end());
        surface.unknown_node_lines.insert(surface.unknown_node_lines.end(), piece.unknown_lines.begin(),
                                          piece.unknown_lines.end());
    }
    parallel_for(threads, pieces.size(),
                 [&](std::size_t p) { write_piece(pieces[p], segments.data() + pieces[p].out); });
    std::copy(content.faces.begin(), content.faces.end(), segments.begin() + first_face);

    bool ordered = true, hole = false;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        const Piece& piece = pieces[p];
        hole |= piece.has_hole;
        ordered &= piece.ascending;
        if (p > 0 && p != first_triangle)
            ordered &= pieces[p - 1].table->id[pieces[p - 1].end - 1] <= piece.table->id[piece.begin];
    }
    for (uint64_t i = first_face + 1; !content.ordered && i < total; ++i)
        ordered &= tables.solids.id[segments[i - 1].element] <= tables.solids.id[segments[i].element];
    if (hole) {
        const auto end = std::remove_if(segments.begin(), segments.end(), [](const Segment& segment) {
            return std::find(segment.n.begin(), segment.n.end(), no_node) != segment.n.end();
        });
        segments.resize(static_cast<std::size_t>(end - segments.begin()));
    }
    surface.in_storage_order = ordered;
    surface.segments = SegmentList(std::move(segments));
}

void find_elements_behind(const Tables& tables, unsigned threads,
                          const std::function<bool(ShellRef, ShellRef)>& stronger, Surface& surface) {
    const auto count = static_cast<uint32_t>(surface.lines.size());
    if (count == 0) return;
    const std::span<Segment> segments = surface.segments.stored();

    // Segments by their first node: an element that has the node may lie behind them.
    std::vector<uint32_t> begin(tables.nodes.size() + std::size_t{1}), by_node(count);
    for (uint32_t i = 0; i < count; ++i)
        ++begin[index(segments[i].n[0])];
    uint32_t sum = 0;
    for (uint32_t& entry : begin) {
        sum += entry;
        entry = sum;
    }
    for (uint32_t i = count; i-- > 0;)
        by_node[--begin[index(segments[i].n[0])]] = i;

    struct Hit {
        uint32_t segment, row;
    };
    const auto hits_of = [&](const auto& table, uint32_t rows) {
        std::vector<std::vector<Hit>> hits((rows + rows_per_piece - 1) / rows_per_piece);
        parallel_for(threads, hits.size(), [&](std::size_t p) {
            const auto first = static_cast<uint32_t>(p) * rows_per_piece;
            for (uint32_t row = first; row < std::min(rows, first + rows_per_piece); ++row) {
                const auto& nodes = table[row];
                for (std::size_t c = 0; c < nodes.size(); ++c) {
                    if (nodes[c] == no_node ||
                        std::find(nodes.begin(), nodes.begin() + c, nodes[c]) != nodes.begin() + c)
                        continue;
                    const std::size_t node = index(nodes[c]);
                    for (uint32_t k = begin[node]; k < begin[node + 1]; ++k) {
                        const auto& n = segments[by_node[k]].n;
                        const auto holds = [&](NodeRow one) {
                            return std::find(nodes.begin(), nodes.end(), one) != nodes.end();
                        };
                        if (holds(n[1]) && holds(n[2]) && holds(n[3])) hits[p].push_back({by_node[k], row});
                    }
                }
            }
        });
        return hits;
    };

    // Three-node shells are asked first; a later one must be stronger to take their place.
    const auto take_shells = [&](const ShellTable& table, ElementKind kind) {
        for (const auto& piece : hits_of(table.nodes, table.size()))
            for (const Hit& hit : piece) {
                Segment& segment = segments[hit.segment];
                if (segment.kind == ElementKind::none ||
                    stronger({kind, hit.row}, {segment.kind, segment.element})) {
                    segment.kind = kind;
                    segment.element = hit.row;
                }
            }
    };
    take_shells(tables.shells3, ElementKind::shell3);
    take_shells(tables.shells4, ElementKind::shell4);

    struct Behind {
        uint32_t segment, solid, solids;
    };
    std::vector<Behind> behind;
    {
        std::vector<Hit> all;
        for (const auto& piece : hits_of(tables.solids.nodes, tables.solids.size()))
            all.insert(all.end(), piece.begin(), piece.end());
        std::sort(all.begin(), all.end(), [&](const Hit& a, const Hit& b) {
            if (a.segment != b.segment) return a.segment < b.segment;
            return tables.solids.id[a.row] < tables.solids.id[b.row];
        });
        for (const Hit& hit : all) {
            if (behind.empty() || behind.back().segment != hit.segment) behind.push_back({hit.segment, 0, 0});
            behind.back().solid = hit.row; // the highest user id counts
            ++behind.back().solids;
        }
    }
    for (const Behind& one : behind) {
        Segment& segment = segments[one.segment];
        if (segment.kind == ElementKind::none) {
            segment.kind = ElementKind::solid;
            segment.element = one.solid;
        } else {
            surface.coated.push_back({one.segment, one.solid});
        }
        segment.solid_backed = one.solids == 1;
        if (segment.solid_backed) turn_outward(tables, one.solid, segment);
    }
}

void turn_faces_outward(const Tables& tables, Surface& surface) {
    if (tables.solids.id.empty() || !surface.segments.is_stored()) return;
    for (Segment& segment : surface.segments.stored().subspan(surface.lines.size())) {
        if (segment.kind == ElementKind::solid && segment.solid_backed)
            turn_outward(tables, segment.element, segment);
    }
}

} // namespace drawbead
