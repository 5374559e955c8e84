#pragma once
// The engine deck beside a starter deck: how long the run takes and what sets its time step.
#include "deck/file_reader.h"

#include <optional>
#include <string>

namespace drawbead {

struct EngineDeck {
    std::string path;
    std::optional<double> end; ///< of the run, the card of its first /RUN; as written, in work units
    std::string mass_scaling;  ///< header of the option that adds mass: /DT/NODA/CST, /DT/AMS; empty: none
};

/// NAME_0001.rad for NAME_0000.rad or NAME.rad.
std::string engine_deck_path(const std::string& starter);

/// Empty when there is none that can be read.
std::optional<EngineDeck> read_engine_deck(const std::string& starter, FileReader&);

} // namespace drawbead
