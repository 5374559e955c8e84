#pragma once
// Small decks in memory.
#include "deck/deck.h"

#include <catch2/catch.hpp>
#include <string>

namespace drawbead {

inline const std::string begin_2022 = "#RADIOSS STARTER\n/BEGIN\nrun\n      2022         0\n"
                                      "                  Mg                  mm                   s\n"
                                      "                  Mg                  mm                   s\n";

inline std::string begin_of(int version) {
    std::string number = std::to_string(version);
    return "#RADIOSS STARTER\n/BEGIN\nrun\n" + std::string(10 - number.size(), ' ') + number +
           "         0\n" + "                  Mg                  mm                   s\n" +
           "                  Mg                  mm                   s\n";
}

/// Reads `text` as main_0000.rad; further files can be added to the reader before.
inline Deck read_deck(const std::string& text, MemoryReader reader = {}, const ReadOptions& options = {}) {
    reader.add("main_0000.rad", text);
    auto deck = Deck::read("main_0000.rad", reader, options);
    REQUIRE(deck);
    return std::move(*deck);
}

inline std::size_t count(const Deck& deck, Notice::Kind kind) {
    std::size_t found = 0;
    for (const Notice& notice : deck.notices())
        found += notice.kind == kind;
    return found;
}

} // namespace drawbead
