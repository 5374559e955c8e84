#pragma once
// What holds for one deck: defaults, its configuration file, the overrides of that file, the command line.
#include "config/config.h"
#include "rules/check.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace drawbead {

/// Every value with where it comes from.
struct Settings {
    std::string file; ///< the configuration file; empty: none
    Chosen<std::vector<std::string>> select, ignore;
    std::map<std::string, Chosen<Severity>> severity;
    Chosen<std::string> fail_on;
    Chosen<std::vector<std::string>> include_path;
    std::vector<Chosen<double>> limits; ///< by place in limit_table()

    Selection selection() const { return {select.value, ignore.value}; }
    Limits rule_limits() const;
    std::map<std::string, Severity> severities() const;
};

/// `deck`: its path, absolute or from the current folder.
Settings settle(const Config*, const std::string& deck, const Choices& command_line);

/// The settings as a configuration file, with the origin of each value in a comment.
std::string show(const Settings&, const std::string& deck);

/// Which configuration holds for a deck: reads each file once. Not for several threads at once.
class ConfigFinder {
public:
    /// `file`: for all decks instead of what is found; `isolated`: none for any.
    ConfigFinder(std::string file, bool isolated) : file_(std::move(file)), isolated_(isolated) {}

    /// nullptr: none. `deck` is a path; only its folder matters.
    Result<std::shared_ptr<const Config>> find(const std::string& deck);

private:
    std::string file_;
    bool isolated_;
    std::map<std::string, std::shared_ptr<const Config>> by_folder_, by_file_;

    Result<std::shared_ptr<const Config>> read(const std::string& path);
};

inline constexpr const char* config_name = ".drawbead.yaml";

} // namespace drawbead
