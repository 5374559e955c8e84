#pragma once
// Which decks a command line means.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drawbead {

/// A deck to check, or why an argument leads to none.
struct DeckPath {
    std::string path;
    std::string failure, help; ///< both empty for a deck

    bool failed() const { return !failure.empty(); }
};

/// In the order of the arguments, each deck once:
/// - a file, whatever its name, and `-` for standard input, are taken as they are;
/// - a folder stands for all *_0000.rad in it and below, in the order of their paths, letter case of the name
/// aside;
///   hidden folders and links to folders are not entered;
/// - an argument that does not exist and holds *, ? or [ is a pattern, in which ** stands for any number of
/// folders. Whatever leads to no deck becomes a failure in its place.
std::vector<DeckPath> find_decks(const std::vector<std::string>& arguments);

/// Whether a file of this name is a starter deck by name.
bool is_starter_name(std::string_view file_name);

} // namespace drawbead
