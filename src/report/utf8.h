#pragma once
// Deck text and paths are bytes; most formats are UTF-8.
#include <cstddef>
#include <string>
#include <string_view>

namespace drawbead {

/// Length of the UTF-8 sequence that `text` begins with, 0 when there is none: no overlong forms, no
/// surrogates, nothing above U+10FFFF.
std::size_t sequence_length(std::string_view text);

/// The text with U+FFFD for every byte that is not UTF-8.
std::string valid_utf8(std::string_view text);

/// "%e4" for every byte above 0x7f, every control byte and '%': the bytes of `text` as ASCII.
std::string percent_encoded(std::string_view text);
/// The bytes again; what is no "%hh" stays.
std::string percent_decoded(std::string_view text);

} // namespace drawbead
