#include "config/settings.h"

#include "config/glob.h"
#include "report/json.h"
#include "rules/text.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace drawbead {

namespace {

namespace fs = std::filesystem;

fs::path absolute(const std::string& path) {
    std::error_code failure;
    const fs::path whole = fs::absolute(path, failure);
    return (failure ? fs::path(path) : whole).lexically_normal();
}

/// As short as it can be said from the current folder.
std::string shown_path(const fs::path& path) {
    std::error_code failure;
    const fs::path here = fs::current_path(failure);
    if (failure) return path.string();
    const std::string relative = path.lexically_relative(here).string();
    return relative.empty() || relative.starts_with("../../") ? path.string() : relative;
}

void apply(const Choices& choices, Settings& settings) {
    if (choices.select) settings.select = *choices.select;
    if (choices.ignore) settings.ignore = *choices.ignore;
    for (const auto& [word, severity] : choices.severity)
        settings.severity[word] = severity;
    if (choices.fail_on) settings.fail_on = *choices.fail_on;
    if (choices.include_path) settings.include_path = *choices.include_path;
    for (const auto& [place, value] : choices.limits)
        settings.limits[place] = value;
}

bool is_for(const Override& one, const std::string& deck) {
    for (const std::string& pattern : one.paths)
        if (path_matches(pattern, deck)) return true;
    return false;
}

/// A word as YAML takes it back.
std::string yaml_word(const std::string& word) {
    const bool plain = !word.empty() &&
                       word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTU"
                                              "VWXYZ0123456789_-./+") == std::string::npos &&
                       word[0] != '-' && word[0] != '.';
    if (plain) return word;
    std::string text = "\"";
    for (const char c : word)
        text += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return text + '"';
}

std::string yaml_list(const std::vector<std::string>& words) {
    std::string text = "[";
    for (const std::string& word : words)
        text += (text.size() > 1 ? ", " : "") + yaml_word(word);
    return text + "]";
}

std::string with_origin(std::string line, const Origin& origin) {
    line += std::string(line.size() < 40 ? 40 - line.size() : 1, ' ');
    return line + "# " + printable(origin.text()) + '\n';
}

} // namespace

Limits Settings::rule_limits() const {
    Limits out;
    for (std::size_t i = 0; i < limits.size(); ++i)
        out.*limit_table()[i].value = limits[i].value;
    return out;
}

std::map<std::string, Severity> Settings::severities() const {
    std::map<std::string, Severity> out;
    for (const auto& [word, chosen] : severity)
        out[word] = chosen.value;
    return out;
}

Settings settle(const Config* config, const std::string& deck, const Choices& command_line) {
    Settings settings;
    settings.fail_on.value = "error";
    for (const LimitInfo& limit : limit_table())
        settings.limits.push_back({limit.usual, {}});
    if (config != nullptr) {
        settings.file = config->path;
        apply(config->choices, settings);
        const fs::path folder = absolute(config->path).parent_path();
        const std::string relative = absolute(deck).lexically_relative(folder).generic_string();
        for (const Override& one : config->overrides)
            if (is_for(one, relative)) apply(one.choices, settings);
    }
    apply(command_line, settings);
    return settings;
}

std::string show(const Settings& settings, const std::string& deck) {
    std::string out = "# " + printable(deck) + ": " +
                      (settings.file.empty() ? "no configuration file" : printable(settings.file)) + '\n';
    const bool all = settings.select.value.empty();
    out +=
        with_origin("select: " + (all ? "[ALL]" : yaml_list(settings.select.value)), settings.select.origin);
    out += with_origin("ignore: " + yaml_list(settings.ignore.value), settings.ignore.origin);
    out += with_origin("fail-on: " + settings.fail_on.value, settings.fail_on.origin);
    out +=
        with_origin("include-path: " + yaml_list(settings.include_path.value), settings.include_path.origin);
    out += settings.severity.empty() ? with_origin("severity: {}", {}) : "severity:\n";
    for (const auto& [word, severity] : settings.severity)
        out += with_origin("  " + word + ": " + std::string(name(severity.value)), severity.origin);
    out += "limits:\n";
    std::string_view rule;
    for (std::size_t i = 0; i < settings.limits.size(); ++i) {
        const LimitInfo& limit = limit_table()[i];
        if (limit.rule != rule) out += "  " + std::string(limit.rule) + ":\n";
        rule = limit.rule;
        out += with_origin("    " + limit.key() + ": " + json_number(settings.limits[i].value),
                           settings.limits[i].origin);
    }
    return out;
}

Result<Config> read_config(const std::string& path) {
    const auto failed = [&](int code) {
        return Error{"cannot read the configuration: " + std::generic_category().message(code), path, 0, 0,
                     ""};
    };
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) return failed(errno);
    struct stat status {};
    if (::fstat(::fileno(file), &status) == 0 && S_ISDIR(status.st_mode)) {
        std::fclose(file);
        return failed(EISDIR);
    }
    constexpr std::size_t most = (std::size_t{1} << 20) + 1; // one byte more than is read
    std::string text(most, '\0');
    text.resize(std::fread(text.data(), 1, most, file));
    const bool broken = std::ferror(file) != 0;
    const int code = errno;
    std::fclose(file);
    if (broken) return failed(code);
    return parse_config(text, path);
}

Result<std::shared_ptr<const Config>> ConfigFinder::read(const std::string& path) {
    if (const auto known = by_file_.find(path); known != by_file_.end()) return known->second;
    Result<Config> config = read_config(path);
    if (!config) return config.error();
    return by_file_[path] = std::make_shared<const Config>(std::move(*config));
}

Result<std::shared_ptr<const Config>> ConfigFinder::find(const std::string& deck) {
    if (isolated_) return std::shared_ptr<const Config>();
    if (!file_.empty()) return read(file_);
    const fs::path first = absolute(deck).parent_path();
    std::shared_ptr<const Config> found;
    std::vector<std::string> passed;
    for (fs::path folder = first;; folder = folder.parent_path()) {
        if (const auto known = by_folder_.find(folder.string()); known != by_folder_.end()) {
            found = known->second;
            break;
        }
        passed.push_back(folder.string());
        const fs::path file = folder / config_name;
        std::error_code failure;
        // Whatever is there and cannot be read is an error, not a reason to look further up.
        if (fs::exists(fs::symlink_status(file, failure))) {
            const auto config = read(shown_path(file));
            if (!config) return config.error();
            found = *config;
            break;
        }
        if (folder == folder.parent_path()) break;
    }
    for (const std::string& folder : passed)
        by_folder_[folder] = found;
    return found;
}

} // namespace drawbead
