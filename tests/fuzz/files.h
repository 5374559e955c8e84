#pragma once
// A fuzzing input as several files: text up to a line "#%%NAME" is the main deck, what follows is a file of
// that name.
#include "deck/file_reader.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace drawbead {

inline constexpr const char* fuzz_main = "main_0000.rad";

inline MemoryReader files_from(const uint8_t* data, std::size_t size) {
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    MemoryReader files;
    std::string name = fuzz_main;
    std::size_t begin = 0;
    for (;;) {
        const std::size_t mark = all.find("#%%", begin);
        files.add(name, std::string(all.substr(begin, mark == std::string_view::npos ? mark : mark - begin)));
        if (mark == std::string_view::npos) return files;
        const std::size_t end = std::min(all.find('\n', mark), all.size());
        name = std::string(all.substr(mark + 3, end - mark - 3));
        begin = std::min(end + 1, all.size());
    }
}

} // namespace drawbead
