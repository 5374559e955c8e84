#include "model/tables.h"

#include <algorithm>

namespace drawbead {

namespace {

/// The element range that holds a row; ranges ascend and leave no row out.
PartId part_of_row(std::span<const ElementRange> ranges, uint32_t row) {
    const auto after =
        std::upper_bound(ranges.begin(), ranges.end(), row,
                         [](uint32_t r, const ElementRange& range) { return r < range.row_end; });
    return after == ranges.end() ? 0 : after->part;
}

} // namespace

Span row_line(const Deck& deck, std::span<const RowPiece> pieces, uint32_t row) {
    return RowLines(deck, pieces).line(row);
}

Span RowLines::line(uint32_t row) {
    const auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), row,
                                        [](uint32_t r, const RowPiece& p) { return r < p.row_end; });
    if (piece == pieces_.end() || row < piece->row_begin) return {};
    const Block& block = deck_->blocks()[piece->block];
    uint64_t from = piece->byte_begin;
    uint64_t lines = uint64_t{row - piece->row_begin} * piece->lines_per_row;
    if (piece->row_begin <= row_ && row_ <= row && row_ < piece->row_end) {
        from = byte_;
        lines = uint64_t{row - row_} * piece->lines_per_row;
    }
    Span found;
    DataLines text(*deck_, Span{block.text.file, from, block.text.end});
    for (uint64_t i = 0; i <= lines; ++i)
        if (!text.next_filled(found)) return {};
    row_ = row;
    byte_ = found.begin;
    return found;
}

std::optional<NodeRow> NodeTable::row(NodeId user) const {
    const uint32_t found = map.row(value(user));
    if (found == IdMap::none) return std::nullopt;
    return NodeRow{found};
}

PartId ShellTable::part(uint32_t row) const {
    return part_of_row(ranges, row);
}

double ShellTable::own_thickness(uint32_t row) const {
    if (thickness.size() == id.size()) return row < thickness.size() ? thickness[row].second : 0;
    const auto found = std::lower_bound(thickness.begin(), thickness.end(), row,
                                        [](const auto& entry, uint32_t r) { return entry.first < r; });
    return found != thickness.end() && found->first == row ? found->second : 0;
}

PartId SolidTable::part(uint32_t row) const {
    return part_of_row(ranges, row);
}

} // namespace drawbead
