#include "config/glob.h"

#include <fnmatch.h>
#include <string>
#include <vector>

namespace drawbead {

namespace {

std::vector<std::string> parts_of(std::string_view path) {
    std::vector<std::string> parts;
    while (!path.empty()) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        if (const std::string_view part = path.substr(0, slash); !part.empty() && part != ".")
            parts.emplace_back(part);
        path.remove_prefix(std::min(slash + 1, path.size()));
    }
    return parts;
}

/// Which beginnings of the path the pattern's parts so far can stand for, part by part: no backtracking.
bool parts_match(const std::vector<std::string>& pattern, const std::vector<std::string>& path) {
    std::vector<bool> reached(path.size() + 1, false);
    reached[0] = true;
    for (const std::string& part : pattern) {
        std::vector<bool> next(path.size() + 1, false);
        if (part == "**") {
            bool any = false;
            for (std::size_t i = 0; i <= path.size(); ++i)
                next[i] = any = any || reached[i];
        } else {
            for (std::size_t i = 0; i < path.size(); ++i)
                next[i + 1] = reached[i] && ::fnmatch(part.c_str(), path[i].c_str(), 0) == 0;
        }
        reached = std::move(next);
    }
    return reached.back();
}

} // namespace

bool path_matches(std::string_view pattern, std::string_view path) {
    std::vector<std::string> wanted = parts_of(pattern);
    const std::vector<std::string> given = parts_of(path);
    // "/" alone is no folder of decks; "./" is that of the file.
    if (!pattern.empty() && pattern.back() == '/' && (!wanted.empty() || pattern[0] == '.'))
        wanted.emplace_back("**");
    if (wanted.empty() || given.empty()) return false;
    if (pattern.find('/') == std::string_view::npos)
        return wanted[0] == "**" || ::fnmatch(wanted[0].c_str(), given.back().c_str(), 0) == 0;
    return parts_match(wanted, given);
}

} // namespace drawbead
