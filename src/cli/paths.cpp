#include "cli/paths.h"

#include "base/nearest.h"

#include <algorithm>
#include <filesystem>
#include <fnmatch.h>
#include <set>
#include <system_error>

namespace drawbead {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view starter_end = "_0000.RAD";

bool ends_with(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool is_hidden(const fs::path& path) {
    const std::string name = path.filename().string();
    return name.size() > 1 && name[0] == '.' && name != "..";
}

/// The entries of a folder by name; a folder that cannot be read sets `error`.
std::vector<fs::directory_entry> entries_of(const fs::path& folder, std::error_code& error) {
    std::vector<fs::directory_entry> entries;
    fs::directory_iterator it(folder.empty() ? fs::path(".") : folder, error);
    for (; !error && it != fs::directory_iterator(); it.increment(error))
        entries.push_back(*it);
    std::sort(entries.begin(), entries.end());
    return entries;
}

/// A link to a folder does not count as one: following it could go round in circles.
bool is_real_folder(const fs::directory_entry& entry) {
    std::error_code error;
    return entry.is_directory(error) && !entry.is_symlink(error);
}

void collect(const fs::path& folder, std::vector<DeckPath>& found) {
    std::error_code error;
    const std::vector<fs::directory_entry> entries = entries_of(folder, error);
    if (error) {
        found.push_back({folder.string(), "cannot read the folder: " + error.message(), ""});
        return;
    }
    for (const fs::directory_entry& entry : entries) {
        // "." as an argument must not lead to "./a", which no one would type.
        const fs::path path = folder == "." || folder == "./" ? entry.path().filename() : entry.path();
        std::error_code ignored;
        if (is_real_folder(entry)) {
            if (!is_hidden(path)) collect(path, found);
        } else if (is_starter_name(path.filename().string()) && !entry.is_directory(ignored)) {
            found.push_back({path.string(), "", ""});
        }
    }
}

/// Matches the components of a pattern from `at` on, below `folder`.
void match(const fs::path& folder, const std::vector<std::string>& pattern, std::size_t at,
           std::vector<fs::path>& found) {
    const std::string& part = pattern[at];
    const bool last = at + 1 == pattern.size();
    std::error_code error;
    if (part == "**") {
        if (!last) match(folder, pattern, at + 1, found);
        for (const fs::directory_entry& entry : entries_of(folder, error)) {
            if (is_real_folder(entry) && !is_hidden(entry.path()))
                match(folder / entry.path().filename(), pattern, at, found);
            else if (last && !is_hidden(entry.path()))
                found.push_back(folder / entry.path().filename());
        }
        return;
    }
    if (part.find_first_of("*?[") == std::string::npos) {
        const fs::path path = folder / part;
        if (!fs::exists(path, error)) return;
        if (last)
            found.push_back(path);
        else
            match(path, pattern, at + 1, found);
        return;
    }
    for (const fs::directory_entry& entry : entries_of(folder, error)) {
        const fs::path name = entry.path().filename();
        if (::fnmatch(part.c_str(), name.c_str(), FNM_PERIOD) != 0) continue;
        if (last)
            found.push_back(folder / name);
        else if (entry.is_directory(error))
            match(folder / name, pattern, at + 1, found);
    }
}

std::vector<fs::path> expand(const std::string& pattern) {
    std::vector<std::string> parts;
    const fs::path path(pattern);
    for (const fs::path& part : path.relative_path())
        if (!part.empty()) parts.push_back(part.string());
    std::vector<fs::path> found;
    if (!parts.empty()) match(path.root_path(), parts, 0, found);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

/// What a missing file was probably meant to be: a neighbour with nearly the same name. The end that all
/// decks share does not count as likeness.
std::string missing_help(const fs::path& path) {
    std::string name = path.filename().string();
    const std::string end = is_starter_name(name) ? name.substr(name.size() - starter_end.size()) : "";
    name.erase(name.size() - end.size());
    std::error_code error;
    std::vector<std::string> candidates;
    for (const fs::directory_entry& entry : entries_of(path.parent_path(), error)) {
        const std::string candidate = entry.path().filename().string();
        if (ends_with(candidate, end))
            candidates.push_back(candidate.substr(0, candidate.size() - end.size()));
    }
    const std::optional<std::string> best = nearest(name, candidates);
    return best ? "did you mean '" + (path.parent_path() / (*best + end)).string() + "'?" : "";
}

void add_folder(const fs::path& folder, std::vector<DeckPath>& found) {
    const std::size_t before = found.size();
    collect(folder, found);
    if (found.size() == before)
        found.push_back({folder.string(), "no starter deck (*_0000.rad) in this folder or below",
                         "name the file itself if it is called otherwise"});
}

void add_argument(const std::string& argument, std::vector<DeckPath>& found) {
    std::error_code error;
    const fs::file_status status = fs::status(argument, error);
    if (argument == "-") {
        found.push_back({argument, "", ""});
    } else if (fs::is_directory(status)) {
        add_folder(argument, found);
    } else if (fs::exists(status)) {
        found.push_back({argument, "", ""});
    } else if (error && status.type() != fs::file_type::not_found) {
        found.push_back({argument, "cannot read: " + error.message(), ""});
    } else if (argument.find_first_of("*?[") != std::string::npos) {
        const std::vector<fs::path> matches = expand(argument);
        if (matches.empty()) found.push_back({argument, "no file matches this pattern", ""});
        for (const fs::path& path : matches) {
            if (fs::is_directory(path, error))
                add_folder(path, found);
            else
                found.push_back({path.string(), "", ""});
        }
    } else {
        found.push_back({argument, argument.empty() ? "an empty path" : "no such file or folder",
                         argument.empty() ? "" : missing_help(argument)});
    }
}

/// What tells decks apart: links and dots resolved.
std::string identity(const DeckPath& deck) {
    if (deck.failed() || deck.path == "-") return deck.path;
    std::error_code error;
    const fs::path real = fs::canonical(deck.path, error);
    return error ? deck.path : real.string();
}

} // namespace

bool is_starter_name(std::string_view file_name) {
    return ends_with(upper_case(file_name), starter_end);
}

std::vector<DeckPath> find_decks(const std::vector<std::string>& arguments) {
    std::vector<DeckPath> found;
    for (const std::string& argument : arguments)
        add_argument(argument, found);
    std::set<std::string> seen;
    found.erase(std::remove_if(found.begin(), found.end(),
                               [&](const DeckPath& deck) { return !seen.insert(identity(deck)).second; }),
                found.end());
    return found;
}

} // namespace drawbead
