// The reader on any bytes: no crash, no hang, places inside their files.
#include "deck/deck.h"
#include "files.h"

#include <cstdlib>

using namespace drawbead;

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

constexpr Field fields[] = {{"a", 1, 10, Kind::integer}, {"b", 21, 20, Kind::real, length_dimension}};
constexpr CardSchema schema{"any", fields};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    MemoryReader files = files_from(data, size);
    ReadOptions options;
    options.max_files = 200;
    const auto deck = Deck::read(fuzz_main, files, options);
    if (!deck) return 0;
    for (const Notice& notice : deck->notices()) {
        require(notice.place.begin <= notice.place.end);
        require(notice.place.end <= deck->file(notice.place.file).bytes().size());
    }
    for (const Block& block : deck->blocks()) {
        require(block.text.begin <= block.text.end ||
                block.text.begin == deck->file(block.text.file).bytes().size());
        DataLines lines(*deck, block);
        Span line;
        while (lines.next(line)) {
            require(line.begin <= line.end && line.end <= deck->file(line.file).bytes().size());
            const Card card = read_card(*deck, block.scope, line, schema);
            for (const Cell& cell : card.cells)
                require(cell.place.begin <= cell.place.end &&
                        cell.place.end <= deck->file(line.file).bytes().size());
        }
    }
    return 0;
}
