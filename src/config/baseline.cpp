#include "config/baseline.h"

#include "report/json.h"
#include "report/output.h"
#include "report/utf8.h"
#include "rules/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace drawbead {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

fs::path absolute(const std::string& path) {
    std::error_code failure;
    const fs::path whole = fs::absolute(path, failure);
    return (failure ? fs::path(path) : whole).lexically_normal();
}

fs::path folder_of(const std::string& path) {
    return absolute(path).parent_path();
}

Result<std::string> text_of(const std::string& path) {
    const auto failed = [&](int code) {
        return Error{"cannot read the baseline: " + std::generic_category().message(code), path, 0, 0,
                     code == ENOENT ? "--write-baseline makes one" : ""};
    };
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) return failed(errno);
    struct stat status {};
    if (::fstat(::fileno(file), &status) == 0 && S_ISDIR(status.st_mode)) {
        std::fclose(file);
        return failed(EISDIR);
    }
    std::string text;
    char buffer[1 << 16];
    for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, file)) > 0;)
        text.append(buffer, count);
    const bool broken = std::ferror(file) != 0;
    const int code = errno;
    std::fclose(file);
    if (broken) return failed(code);
    return text;
}

/// JSON of any nesting is parsed without recursion; what was meant is looked at below.
Result<Json> parse(const std::string& text, const std::string& path) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        const std::string before = text.substr(0, error.byte > 0 ? error.byte - 1 : 0);
        const auto line = static_cast<uint64_t>(std::count(before.begin(), before.end(), '\n')) + 1;
        const std::size_t newline = before.rfind('\n');
        const std::size_t column = newline == std::string::npos ? before.size() + 1 : before.size() - newline;
        return Error{"this is no baseline: JSON was expected", path, line, static_cast<uint32_t>(column), ""};
    }
}

bool is_fingerprint(const std::string& text) {
    return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool was_run(const Selection& run, const std::string& code) {
    const Rule* rule = find_rule(code);
    return rule == nullptr || run(rule->info); // what no longer exists finds nothing
}

} // namespace

/// A name that JSON and a person can read stays as it is; the bytes of others, and what looks like such
/// bytes, are written as %hh, so that no two decks have one name.
std::string Baseline::name_of(const std::string& deck) const {
    const std::string name = absolute(deck).lexically_relative(folder_of(path_)).generic_string();
    return printable(name) == name && percent_decoded(name) == name ? name : percent_encoded(name);
}

Result<Baseline> Baseline::read(const std::string& path) {
    const Result<std::string> text = text_of(path);
    if (!text) return text.error();
    const Result<Json> json = parse(*text, path);
    if (!json) return json.error();
    const auto wrong = [&](const std::string& what) {
        return Error{"this is no baseline: " + what, path, 0, 0,
                     "'drawbead schema baseline' says what it holds"};
    };
    if (!json->is_object() || !json->contains("schema") || !json->contains("decks"))
        return wrong("no decks in it");
    if ((*json)["schema"] != 1)
        return Error{"this baseline is of another version of the tool", path, 0, 0,
                     "delete it, and write it anew with --write-baseline"};
    if (!(*json)["decks"].is_object()) return wrong("decks is no object");
    Baseline out(path);
    for (const auto& [name, findings] : (*json)["decks"].items()) {
        if (!findings.is_array()) return wrong("deck " + drawbead::quoted(name) + " has no list of findings");
        Counts& known = out.decks_[name].known;
        for (const Json& one : findings) {
            const auto member = [&](const char* key) {
                return one.is_object() && one.contains(key) ? one[key] : Json();
            };
            const Json code = member("code"), id = member("interface"), print = member("fingerprint"),
                       count = member("count");
            const bool good = code.is_string() && (id.is_null() || id.is_number_integer()) &&
                              print.is_string() && is_fingerprint(print.get<std::string>()) &&
                              count.is_number_unsigned();
            if (!good) return wrong("a finding of deck " + drawbead::quoted(name) + " is not complete");
            known[{code.get<std::string>(), id.is_null() ? -1 : id.get<int64_t>(),
                   print.get<std::string>()}] += count.get<uint64_t>();
        }
    }
    return out;
}

void Baseline::apply(DeckResult& result, const Selection& run) const {
    const auto deck = decks_.find(name_of(result.path));
    if (deck == decks_.end() || result.failed()) return;
    std::map<std::string, uint64_t> left;
    for (const auto& [key, count] : deck->second.known)
        left[std::get<2>(key)] += count;
    std::vector<Finding> news;
    for (Finding& finding : result.findings) {
        const auto known = left.find(finding.fingerprint);
        if (known == left.end() || known->second == 0) {
            news.push_back(std::move(finding));
            continue;
        }
        --known->second;
        ++result.known;
    }
    result.findings = std::move(news);
    for (const auto& [key, count] : deck->second.known) {
        const auto& [code, id, print] = key;
        if (left[print] == 0 || !was_run(run, code)) continue;
        result.gone.push_back({print, code, id == -1 ? std::optional<int64_t>() : id, left[print]});
        left[print] = 0;
    }
}

void Baseline::learn(DeckResult& result, const Selection& run) {
    Deck& deck = decks_[name_of(result.path)];
    deck.run = run;
    deck.failed = result.failed();
    for (const Finding& finding : result.findings)
        ++deck.known[{finding.code, finding.interface_id.value_or(-1), finding.fingerprint}];
    result.known += result.findings.size();
    result.findings.clear();
}

Result<Baseline::Change> Baseline::write(const Baseline& before, FileSink& file) {
    Change change;
    std::error_code failure;
    const fs::path folder = folder_of(path_);
    for (const auto& [name, old] : before.decks_) {
        const auto now = decks_.find(name);
        const bool looked_at = now != decks_.end() && !now->second.failed;
        const bool stays =
            looked_at || now != decks_.end() || fs::exists(folder / percent_decoded(name), failure);
        for (const auto& [key, count] : old.known) {
            uint64_t kept = 0;
            if (looked_at && was_run(now->second.run, std::get<0>(key))) {
                const auto found = now->second.known.find(key);
                kept = found == now->second.known.end() ? 0 : std::min(found->second, count);
            } else if (stays) {
                decks_[name].known[key] = kept = count;
            }
            change.removed += count - kept;
            change.added -= kept; // what is in the file afterwards and was not before
        }
    }
    using Layout = JsonWriter::Layout;
    JsonWriter json(file);
    json.begin_object();
    json.member("tool", "drawbead");
    json.member("schema", 1);
    json.key("decks");
    json.begin_object();
    for (const auto& [name, deck] : decks_) {
        if (deck.known.empty()) continue;
        ++change.decks;
        json.key(name);
        json.begin_array();
        for (const auto& [key, count] : deck.known) {
            const auto& [code, id, print] = key;
            json.begin_object(Layout::line);
            json.member("code", code);
            json.key("interface");
            if (id == -1)
                json.null();
            else
                json.value(id);
            json.member("fingerprint", print);
            json.member("count", count);
            json.end();
            change.findings += count;
        }
        json.end();
    }
    json.end();
    json.end();
    change.added += change.findings;
    if (auto written = file.finish(); !written) return written.error();
    return change;
}

} // namespace drawbead
