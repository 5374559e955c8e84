#pragma once
// What `table` prints: one row per bead node in a fixed order of columns, and the totals.
#include "findings/bead_table.h"
#include "report/output.h"

#include <string_view>

namespace drawbead {

/// One block per bead with units in the head, then the totals. Six significant digits.
void write_table_text(OutputSink&, const DeckTable&);
/// A head and the rows, without totals; numbers read back exactly, flags are 0 or 1, what is not known is
/// empty.
void write_table_csv(OutputSink&, const DeckTable&);
/// By schemas/table.schema.json; numbers read back exactly, what is not known is null.
void write_table_json(OutputSink&, const DeckTable&, std::string_view tool_version);

} // namespace drawbead
