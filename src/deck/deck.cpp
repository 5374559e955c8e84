#include "deck/deck.h"

#include "deck/expression.h"
#include "deck/keyword_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace drawbead {

namespace {

constexpr std::array<int, 21> known_layouts{41,   42,   44,   51,   90,   100,  110,  120,  130,  140, 2017,
                                            2018, 2019, 2020, 2021, 2022, 2023, 2024, 2025, 2026, 2612};

/// The second card of /BEGIN.
constexpr Field version_fields[] = {{.name = "Invers", .column = 1}, {.name = "Irun", .column = 11}};
constexpr CardSchema version_card{"version", version_fields};

/// /PARAMETER of a number; its text is evaluated once all of them are known.
constexpr Field real_parameter_fields[] = {
    {.name = "name", .column = 1, .kind = Kind::text},
    {.name = "value", .column = 11, .width = 20, .kind = Kind::real},
};
constexpr CardSchema real_parameter_card{"parameter", real_parameter_fields};
constexpr Field integer_parameter_fields[] = {
    {.name = "name", .column = 1, .kind = Kind::text},
    {.name = "value", .column = 11},
};
constexpr CardSchema integer_parameter_card{"parameter", integer_parameter_fields};

/// The card of //SUBMODEL behind its title.
constexpr Field submodel_fields[] = {
    {.name = "off_def", .column = 1},   {.name = "off_nod", .column = 11}, {.name = "off_ele", .column = 21},
    {.name = "off_part", .column = 31}, {.name = "off_mat", .column = 41}, {.name = "off_type", .column = 51},
    {.name = "off_sub", .column = 61},
};
constexpr CardSchema submodel_card{"offsets", submodel_fields};

bool is_known_layout(int version) {
    return std::find(known_layouts.begin(), known_layouts.end(), version) != known_layouts.end();
}

bool is_comment(std::string_view line) {
    return !line.empty() && (line[0] == '#' || line[0] == '$');
}

bool is_blank_line(std::string_view line) {
    return trim(line).empty();
}

/// Whether a line holds numbers and nothing else.
bool looks_like_data(std::string_view line) {
    bool digit = false;
    for (const char c : trim(line)) {
        if (c >= '0' && c <= '9')
            digit = true;
        else if (std::string_view(" \t.+-eEdD,").find(c) == std::string_view::npos)
            return false;
    }
    return digit;
}

} // namespace

DataLines::DataLines(const Deck& deck, const Span& text)
    : bytes_(deck.file(text.file).bytes()), file_(text.file), at_(text.begin), end_(text.end) {}

bool DataLines::next(Span& line) {
    while (at_ < end_) {
        const void* found = std::memchr(bytes_.data() + at_, '\n', end_ - at_);
        const uint64_t newline =
            found ? static_cast<uint64_t>(static_cast<const char*>(found) - bytes_.data()) : end_;
        const char first = bytes_[at_];
        if (first == '#' || first == '$') {
            const auto include = first == '#' ? include_at(bytes_, at_) : std::nullopt;
            at_ = include ? include->next : newline + 1;
            continue;
        }
        line = {file_, at_, newline};
        at_ = newline + 1;
        if (line.end > line.begin && bytes_[line.end - 1] == '\r') --line.end;
        return true;
    }
    return false;
}

bool DataLines::next_filled(Span& line) {
    while (next(line))
        if (!is_blank_line(text(line))) return true;
    return false;
}

/// Follows the marks of the main file and its includes in the order in which the solver meets them.
class DeckReader {
public:
    DeckReader(FileReader& reader, const ReadOptions& options) : reader_(reader), options_(options) {}

    Result<Deck> read(const std::string& path) {
        deck_.path_ = path;
        const auto main = load(path);
        if (!main) return main.error();
        Scope root;
        root.file = *main;
        deck_.scopes_.push_back(std::move(root));
        main_identity_ = reader_.identity(path);
        stack_.push_back(main_identity_);
        read_instance(*main, ScopeId{0}, true);
        if (!begun_) return no_begin(*main);
        if (!ended_)
            notice(Notice::Kind::end_missing,
                   {*main, deck_.file(*main).bytes().size(), deck_.file(*main).bytes().size()}, path);
        finish();
        return std::move(deck_);
    }

private:
    struct OpenSubmodel {
        ScopeId scope;
        Span header;
    };

    void notice(Notice::Kind kind, Span place, std::string_view subject, std::string_view detail = {}) {
        deck_.notices_.push_back({kind, place, std::string(subject), std::string(detail)});
    }

    Result<FileId> load(const std::string& path) {
        const std::string identity = reader_.identity(path);
        if (const auto known = loaded_.find(identity); known != loaded_.end()) return known->second;
        auto bytes = reader_.read(path);
        if (!bytes) return bytes.error();
        const FileId id{static_cast<uint32_t>(deck_.files_.size())};
        deck_.files_.push_back(std::make_unique<SourceFile>(path, std::move(*bytes), options_.threads));
        loaded_.emplace(identity, id);
        return id;
    }

    Error no_begin(FileId main) const {
        const std::string_view bytes = deck_.file(main).bytes();
        Error error{"", deck_.path_, 0, 0, ""};
        if (bytes.empty()) {
            error.message = "the file is empty";
            error.help = "give a starter deck (NAME_0000.rad)";
        } else if (bytes.substr(0, 4096).find('\0') != std::string_view::npos) {
            error.message = "the file is binary, not a starter deck";
            error.help = "give the text deck (NAME_0000.rad), not a restart or animation file";
        } else if (bytes.find('\n') == std::string_view::npos && bytes.find('\r') != std::string_view::npos) {
            error.message = "the lines of the file end with a carriage return alone: all of it is one line";
            error.help = "convert its line ends (tr '\\r' '\\n')";
        } else {
            error.message = "no /BEGIN keyword: the solver reads nothing of this file";
            error.help =
                "give a starter deck (NAME_0000.rad); engine decks (NAME_0001.rad) hold no drawbeads";
            error.line = 1;
            error.column = 1;
        }
        return error;
    }

    Scope& scope(ScopeId id) { return deck_.scopes_[index(id)]; }

    ScopeId new_scope(ScopeId parent, FileId file, Span included_by) {
        Scope child = scope(parent);
        child.parent = parent;
        child.file = file;
        child.included_by = included_by;
        child.parameters.clear();
        ++child.depth;
        deck_.scopes_.push_back(std::move(child));
        return ScopeId{static_cast<uint32_t>(deck_.scopes_.size() - 1)};
    }

    /// Reads one instance of a file; false when the whole deck has ended.
    void read_instance(FileId id, ScopeId own, bool main) {
        const SourceFile& file = deck_.file(id);
        const std::string_view bytes = file.bytes();
        ScopeId current = own;
        std::vector<OpenSubmodel> submodels;
        std::size_t open_block = none;
        bool any_keyword = false;
        uint64_t end = bytes.size();
        auto close_block = [&](uint64_t at) {
            if (open_block != none) deck_.blocks_[open_block].text.end = at;
            open_block = none;
        };

        uint64_t skip_to = 0;
        for (const uint64_t mark : file.marks()) {
            if (mark < skip_to) continue;
            if (bytes[mark] == '#') {
                if (const auto include = include_at(bytes, mark)) {
                    skip_to = include->next;
                    const std::string_view line = file.line_at(mark).substr(mark - file.line_begin(mark));
                    open_include({id, mark, mark + line.size()}, *include, current);
                    if (stopped_) break;
                } else {
                    directive(file, id, mark);
                }
                continue;
            }
            const uint64_t line_begin =
                std::max(file.line_begin(mark), mark < 4 ? byte_order_mark(bytes) : 0);
            const std::string_view line = file.line_at(mark).substr(mark - file.line_begin(mark));
            const Span header{id, mark, mark + line.size()};
            if (!any_keyword && !main) leading_text(file, id, line_begin);
            any_keyword = true;
            if (mark != line_begin) notice(Notice::Kind::keyword_indented, header, line);
            close_block(line_begin);
            const KeywordLine cut = cut_keyword_line(line);
            if (cut.keyword == "END" && (begun_ || !main)) {
                end = line_begin;
                if (main) ended_ = true;
                break;
            }
            const Span text{id, file.next_line(mark), bytes.size()};
            if (cut.keyword == "BEGIN") {
                read_begin(text, current, main);
                if (!main && !begun_) begun_ = true;
                begun_ = true;
            } else if (cut.keyword == "/SUBMODEL") {
                current = new_scope(current, id, header);
                scope(current).submodel = 0;
                submodels.push_back({current, header});
                submodel_headers_.push_back({current, cut, text, header});
            } else if (cut.keyword == "/ENDSUB") {
                if (!submodels.empty()) {
                    current = scope(submodels.back().scope).parent;
                    submodels.pop_back();
                }
                continue;
            }
            if (!begun_ && cut.keyword.substr(0, 10) != "PARAMETER/") continue;
            open_block = deck_.blocks_.size();
            add_block(cut, header, text, current);
        }
        if (!any_keyword && !main) leading_text(file, id, end);
        close_block(end);
        for (const OpenSubmodel& submodel : submodels)
            notice(Notice::Kind::submodel_not_closed, submodel.header, "//SUBMODEL");
    }

    void add_block(const KeywordLine& cut, const Span& header, const Span& text, ScopeId own) {
        Block block;
        block.keyword = cut.keyword;
        block.header = header;
        block.text = text;
        block.scope = own;
        block.id_given = !cut.id.empty();
        if (cut.id.empty()) block.id = 1;
        pending_ids_.push_back({cut.id, cut.unit});
        deck_.blocks_.push_back(block);
    }

    void leading_text(const SourceFile& file, FileId id, uint64_t end) {
        for (uint64_t at = 0; at < end; at = file.next_line(at)) {
            const std::string_view line = file.line_at(at);
            if (is_comment(line) || is_blank_line(line)) continue;
            // Licence texts and notes are dropped on purpose; numbers were meant to be read.
            if (looks_like_data(line))
                notice(Notice::Kind::include_text_dropped, {id, at, at + line.size()}, file.path());
            return;
        }
    }

    void directive(const SourceFile& file, FileId id, uint64_t mark) {
        const std::string_view line = file.line_at(mark);
        const Span place{id, mark, mark + line.size()};
        if (line.substr(0, 8) == "#enddata") {
            for (uint64_t at = file.next_line(mark); at < file.bytes().size(); at = file.next_line(at)) {
                const std::string_view text = file.line_at(at);
                if (is_comment(text) || is_blank_line(text)) continue;
                if (text[0] == '/' && cut_keyword_line(text).keyword == "END") return; // no data
                notice(Notice::Kind::data_after_enddata, place, file.path());
                return;
            }
        } else if (line.substr(0, 9) == "#!/ENCRYP") {
            notice(Notice::Kind::encrypted, place, line);
        }
    }

    void open_include(const Span& place, const IncludeDirective& include, ScopeId from) {
        const std::string& path = include.path;
        if (path.empty()) {
            notice(Notice::Kind::include_missing, place, path, "no path given");
            return;
        }
        std::string found;
        const SourceFile& including = deck_.file(place.file);
        std::vector<std::string> candidates;
        const auto add_candidates = [&](const std::string& written) {
            candidates.push_back(join_path(including.path(), written));
            candidates.push_back(join_path(deck_.path_, written));
            for (const std::string& folder : options_.include_path)
                candidates.push_back(join_path(folder + "/x", written));
        };
        add_candidates(path);
        if (path.find('\\') != std::string::npos) { // written on Windows
            std::string slashes = path;
            std::replace(slashes.begin(), slashes.end(), '\\', '/');
            add_candidates(slashes);
        }
        for (const std::string& candidate : candidates) {
            if (!reader_.exists(candidate)) continue;
            found = candidate;
            break;
        }
        if (found.empty()) {
            if (include.run_on) return; // "#includes of the tool": a comment, unless there is such a file
            notice(Notice::Kind::include_missing, place, path);
            return;
        }
        const std::string identity = reader_.identity(found);
        if (!options_.include_root.empty()) {
            const std::string root = reader_.identity(options_.include_root);
            if (identity.compare(0, root.size(), root) != 0 ||
                (identity.size() > root.size() && root.back() != '/' && identity[root.size()] != '/')) {
                notice(Notice::Kind::include_outside_root, place, path, options_.include_root);
                return;
            }
        }
        if (std::find(stack_.begin(), stack_.end(), identity) != stack_.end()) {
            notice(Notice::Kind::include_cycle, place, path);
            return;
        }
        if (stack_.size() > options_.max_depth || ++instances_ > options_.max_files) {
            notice(Notice::Kind::include_too_deep, place, path,
                   stack_.size() > options_.max_depth ? "depth" : "count");
            if (instances_ > options_.max_files) stopped_ = true;
            return;
        }
        const auto file = load(found);
        if (!file) {
            notice(Notice::Kind::include_unreadable, place, path, file.error().message);
            return;
        }
        const ScopeId own = new_scope(from, *file, place);
        stack_.push_back(identity);
        read_instance(*file, own, false);
        stack_.pop_back();
    }

    // ---- /BEGIN
    // --------------------------------------------------------------------------------------------------

    void read_begin(const Span& text, ScopeId own, bool main) {
        Scope& here = scope(own);
        const bool inside_submodel = is_inside_submodel(own);
        DataLines lines(deck_, limited(text));
        Span line;
        if (!lines.next(line)) {
            if (main || !begun_) set_version_up(own, 0, text);
            return;
        }
        if (!begun_) deck_.run_name_ = trim(lines.text(line));
        int version = 0;
        Span version_line = line;
        if (lines.next(line)) {
            version_line = line;
            const Card card = read_card(deck_, own, line, version_card);
            if (const Cell& cell = card["Invers"]; cell.given()) {
                version = static_cast<int>(cell.integer);
                // Layout 44 has cells of 8 columns: the next one may begin in columns 9 and 10.
                const IntegerCell narrow = parse_integer(lines.text(line).substr(0, 8));
                if (!card.free_format && !is_known_layout(version) && narrow.value >= 41 &&
                    narrow.value <= 44)
                    version = static_cast<int>(narrow.value);
            }
        }
        if (begun_ && !main) {
            if (version != here.version) {
                notice(Notice::Kind::version_in_include, version_line, std::to_string(version),
                       std::to_string(deck_.root().version));
                set_version(here, version, version_line);
            }
        } else {
            set_version_up(own, version, version_line);
        }
        std::array<std::string_view, 3> input, work;
        if (lines.next(line)) input = unit_cells(lines.text(line));
        if (lines.next(line)) work = unit_cells(lines.text(line));
        if (begun_ && !main && !inside_submodel) return;
        UnitSystem read_input = units_from(input, work, version_line);
        here.input = read_input;
        if (!begun_ || main) {
            for (ScopeId at = own; index(at) != 0; at = scope(at).parent)
                scope(scope(at).parent).input = read_input;
            deck_.work_ = units_from(work, input, version_line);
        }
    }

    bool is_inside_submodel(ScopeId id) const {
        for (ScopeId at = id; index(at) != 0; at = deck_.scope(at).parent)
            for (const SubmodelHeader& header : submodel_headers_)
                if (header.scope == at) return true;
        return false;
    }

    /// Text up to the next keyword line: the block of /BEGIN is not closed yet when it is read.
    Span limited(const Span& text) const {
        const SourceFile& file = deck_.file(text.file);
        const auto& marks = file.marks();
        for (auto mark = std::lower_bound(marks.begin(), marks.end(), text.begin); mark != marks.end();
             ++mark)
            if (file.bytes()[*mark] == '/') return {text.file, text.begin, file.line_begin(*mark)};
        return text;
    }

    void set_version(Scope& here, int version, const Span& place, bool tell = true) {
        here.version = version;
        here.layout = is_known_layout(version) ? version : known_layouts.back();
        if (!tell) return;
        if (!is_known_layout(version)) notice(Notice::Kind::version_unknown, place, std::to_string(version));
        if (version >= 41 && version <= 44)
            notice(Notice::Kind::version_too_old, place, std::to_string(version));
    }

    /// The deck's own version: files that are still open around the /BEGIN go on with it after its include.
    void set_version_up(ScopeId own, int version, const Span& place) {
        set_version(scope(own), version, place);
        for (ScopeId at = own; index(at) != 0; at = scope(at).parent)
            set_version(scope(scope(at).parent), version, place, false);
    }

    static std::array<std::string_view, 3> unit_cells(std::string_view line) {
        std::array<std::string_view, 3> cells;
        for (std::size_t i = 0; i < 3; ++i)
            if (line.size() > 20 * i) cells[i] = trim(line.substr(20 * i, 20));
        return cells;
    }

    /// Factors of one unit card; a blank cell takes the other card's.
    UnitSystem units_from(const std::array<std::string_view, 3>& cells,
                          const std::array<std::string_view, 3>& other, const Span& place) {
        UnitSystem units;
        struct Slot {
            double* factor;
            std::string* name;
            char base;
        };
        const std::array<Slot, 3> slots{{{&units.mass, &units.mass_name, 'g'},
                                         {&units.length, &units.length_name, 'm'},
                                         {&units.time, &units.time_name, 's'}}};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string_view code = cells[i].empty() ? other[i] : cells[i];
            if (code.empty()) continue;
            if (const auto factor = unit_factor(code, slots[i].base)) {
                *slots[i].factor = *factor;
                *slots[i].name = code;
            } else {
                notice(Notice::Kind::unit_not_understood, place, code);
            }
        }
        return units;
    }

    // ---- after all blocks are known
    // ------------------------------------------------------------------------------

    void finish() {
        collect_parameters();
        evaluate_parameters();
        resolve_ids();
        read_units();
        apply_submodels();
    }

    struct RawParameter {
        std::string name;
        Parameter::Kind kind;
        bool expression = false;
        std::string text;
        Span place;
        ScopeId scope;
        bool local = false;
        enum class State : uint8_t { waiting, running, done, failed } state = State::waiting;
        double value = 0;
    };

    void collect_parameters() {
        for (const Block& block : deck_.blocks_) {
            if (block.keyword.substr(0, 10) != "PARAMETER/") continue;
            const std::string_view type = block.keyword.substr(10);
            RawParameter raw;
            raw.scope = block.scope;
            raw.local = type.substr(0, 6) == "LOCAL/";
            const std::size_t slash = type.find('/');
            const std::string_view kind = slash == std::string_view::npos ? type : type.substr(slash + 1);
            raw.kind = kind.substr(0, 3) == "INT" ? Parameter::Kind::integer
                       : kind == "TEXT"           ? Parameter::Kind::text
                                                  : Parameter::Kind::real;
            raw.expression = kind.size() > 5 && kind.substr(kind.size() - 5) == "_EXPR";
            DataLines lines(deck_, block);
            Span line;
            if (!lines.next(line) || !lines.next(line)) {
                notice(Notice::Kind::bad_parameter, block.header, "");
                continue;
            }
            const std::string_view card = lines.text(line);
            raw.name = trim(card.substr(0, 10));
            raw.place = line;
            if (raw.expression) {
                raw.text = card.size() > 10 ? card.substr(10, 90) : std::string_view{};
                for (int more = 0; more < 9 && lines.next_filled(line); ++more) {
                    const std::string_view next = lines.text(line);
                    // The columns of the name are blank, or the expression goes on in them.
                    raw.text += trim(next.substr(0, 10)).empty()
                                    ? next.substr(std::min<std::size_t>(10, next.size()), 90)
                                    : next.substr(0, 100);
                }
            } else if (raw.kind == Parameter::Kind::text) {
                if (lines.next(line)) raw.text = lines.text(line);
            } else {
                const Card cells = read_card(deck_, block.scope, line,
                                             raw.kind == Parameter::Kind::integer ? integer_parameter_card
                                                                                  : real_parameter_card);
                raw.name = cells["name"].text;
                raw.text = cells["value"].text;
            }
            if (raw.name.empty())
                notice(Notice::Kind::bad_parameter, line, "");
            else
                raw_parameters_.push_back(std::move(raw));
        }
    }

    const RawParameter* find_raw(ScopeId from, std::string_view name) {
        const RawParameter* global = nullptr;
        for (ScopeId at = from;; at = deck_.scope(at).parent) {
            for (const RawParameter& raw : raw_parameters_)
                if (raw.name == name && raw.local && raw.scope == at) return &raw;
            if (index(at) == 0) break;
        }
        for (const RawParameter& raw : raw_parameters_)
            if (raw.name == name && !raw.local) global = &raw;
        return global;
    }

    std::optional<double> value_of(RawParameter& raw, int depth) {
        using State = RawParameter::State;
        if (raw.state == State::done) return raw.value;
        if (raw.state != State::waiting || depth > 100 || raw.kind == Parameter::Kind::text)
            return std::nullopt;
        raw.state = State::running;
        std::optional<double> value;
        if (raw.expression) {
            value = evaluate_expression(raw.text, [&](std::string_view name) -> std::optional<double> {
                const RawParameter* other = find_raw(raw.scope, name);
                return other ? value_of(const_cast<RawParameter&>(*other), depth + 1) : std::nullopt;
            });
            if (value && raw.kind == Parameter::Kind::integer) value = std::trunc(*value);
        } else {
            const RealCell cell = parse_real(raw.text);
            if (cell.state == NumberState::ok || cell.state == NumberState::trailing ||
                cell.state == NumberState::blank)
                value = raw.kind == Parameter::Kind::integer ? std::trunc(cell.value) : cell.value;
        }
        raw.state = value ? State::done : State::failed;
        raw.value = value.value_or(0);
        return value;
    }

    void evaluate_parameters() {
        for (RawParameter& raw : raw_parameters_) {
            Parameter parameter{raw.kind, 0, raw.text, raw.place};
            if (raw.kind != Parameter::Kind::text) {
                const auto value = value_of(raw, 0);
                if (!value) notice(Notice::Kind::bad_parameter, raw.place, raw.name, trim(raw.text));
                parameter.value = value.value_or(0);
            }
            ParameterTable& table = raw.local ? scope(raw.scope).parameters : deck_.global_parameters_;
            table.insert_or_assign(raw.name, std::move(parameter));
        }
    }

    int64_t header_number(std::string_view text, const Block& block) {
        if (text.empty()) return 0;
        if (text[0] == '&') {
            const Parameter* parameter = deck_.parameter(block.scope, text.substr(1));
            if (parameter && parameter->kind != Parameter::Kind::text &&
                std::abs(parameter->value) <= 2147483647)
                return static_cast<int64_t>(parameter->value);
            notice(Notice::Kind::unknown_parameter, block.header, text.substr(1));
            return 0;
        }
        const IntegerCell cell = parse_integer(text);
        if (cell.state != NumberState::ok) notice(Notice::Kind::header_id_overflow, block.header, text);
        return cell.value;
    }

    void resolve_ids() {
        for (std::size_t i = 0; i < deck_.blocks_.size(); ++i) {
            Block& block = deck_.blocks_[i];
            if (block.id_given) block.id = header_number(pending_ids_[i].id, block);
            block.unit = header_number(pending_ids_[i].unit, block);
        }
    }

    void read_units() {
        for (const Block& block : deck_.blocks_) {
            if (block.keyword == "UNIT" && block.id_given) {
                DataLines lines(deck_, block);
                Span line;
                if (!lines.next(line) || !lines.next(line)) continue;
                deck_.units_.insert_or_assign(block.id, units_from(unit_cells(lines.text(line)), {}, line));
            } else if (block.keyword.substr(0, 5) == "UNIT/") {
                global_unit(block);
            }
        }
    }

    /// `/UNIT/LENGTH/mm` of layouts below 100: one header, no data, input and work alike.
    void global_unit(const Block& block) {
        const std::string_view what = block.keyword.substr(5);
        const std::size_t slash = what.find('/');
        if (slash == std::string_view::npos) return;
        const std::string_view quantity = what.substr(0, slash), code = trim(what.substr(slash + 1));
        const char base = quantity == "MASS"     ? 'g'
                          : quantity == "LENGTH" ? 'm'
                          : quantity == "TIME"   ? 's'
                                                 : '\0';
        if (base == '\0') return;
        const auto factor = unit_factor(code, base);
        if (!factor) {
            notice(Notice::Kind::unit_not_understood, block.header, code);
            return;
        }
        auto set = [&](UnitSystem& units) {
            (base == 'g' ? units.mass : base == 'm' ? units.length : units.time) = *factor;
            (base == 'g' ? units.mass_name : base == 'm' ? units.length_name : units.time_name) = code;
        };
        for (Scope& s : deck_.scopes_)
            set(s.input);
        set(deck_.work_);
    }

    struct SubmodelHeader {
        ScopeId scope;
        KeywordLine cut;
        Span text;
        Span header;
    };

    /// Offsets add up from the outside in; scopes are stored parents first.
    void apply_submodels() {
        std::vector<const SubmodelHeader*> header_of(deck_.scopes_.size(), nullptr);
        for (const SubmodelHeader& header : submodel_headers_)
            header_of[index(header.scope)] = &header;
        for (std::size_t i = 1; i < deck_.scopes_.size(); ++i) {
            Scope& own = deck_.scopes_[i];
            const Scope& parent = deck_.scope(own.parent);
            own.offsets = parent.offsets;
            own.submodel = parent.submodel;
            own.unit_id = parent.unit_id;
            if (header_of[i]) read_submodel(own, ScopeId{static_cast<uint32_t>(i)}, parent, *header_of[i]);
        }
    }

    void read_submodel(Scope& own, ScopeId id, const Scope& parent, const SubmodelHeader& header) {
        const IntegerCell number = parse_integer(header.cut.id);
        own.submodel = Deck::global_id(number.value, parent.offsets.submodel);
        if (!header.cut.unit.empty()) own.unit_id = parse_integer(header.cut.unit).value;
        std::string_view version = header.cut.rest;
        if (version.size() > 1 && version[0] == 'V' && parse_integer(version.substr(1)).value != own.version)
            notice(Notice::Kind::submodel_version, header.header, version);
        DataLines lines(deck_, limited(header.text));
        Span line;
        if (!lines.next(line) || !lines.next(line)) return;
        const Card card = read_card(deck_, id, line, submodel_card);
        std::array<int64_t, std::size(submodel_fields)> offset{};
        for (std::size_t i = 0; i < offset.size(); ++i)
            offset[i] = offset_from(card.cells[i], submodel_fields[i].name, number.value);
        auto specific = [&](std::size_t i) { return offset[i] ? offset[i] : offset[0]; };
        own.offsets.general += offset[0];
        own.offsets.node += specific(1);
        own.offsets.element += specific(2);
        own.offsets.part += specific(3);
        own.offsets.material += specific(4);
        own.offsets.property += specific(5);
        own.offsets.submodel += specific(6);
    }

    /// One offset of a submodel; what is wrong with its cell is noticed.
    int64_t offset_from(const Cell& cell, std::string_view field, int64_t submodel) {
        const std::string where = std::string(field) + " of submodel " + std::to_string(submodel);
        switch (cell.state) {
        case CellState::garbage:
            notice(Notice::Kind::offset_not_understood, cell.place, cell.text,
                   where + " is not a number: the solver reads 0");
            break;
        case CellState::not_finite:
            notice(Notice::Kind::offset_not_understood, cell.place, cell.text,
                   where + " is larger than any id can be");
            break;
        case CellState::trailing:
            notice(Notice::Kind::offset_not_understood, cell.place, cell.text,
                   where + " is read as " + std::to_string(cell.integer) + ": the rest is dropped");
            break;
        case CellState::unknown_parameter:
            notice(Notice::Kind::unknown_parameter, cell.place, cell.text.substr(cell.text.find('&') + 1),
                   where);
            break;
        default:
            break;
        }
        return cell.given() ? cell.integer : 0;
    }

    struct PendingId {
        std::string_view id, unit;
    };

    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    FileReader& reader_;
    const ReadOptions& options_;
    Deck deck_;
    std::map<std::string, FileId> loaded_;
    std::vector<std::string> stack_; ///< identities of the files being read
    std::string main_identity_;
    uint32_t instances_ = 0;
    bool begun_ = false, ended_ = false, stopped_ = false;
    std::vector<PendingId> pending_ids_; ///< parallel to the deck's blocks
    std::vector<SubmodelHeader> submodel_headers_;
    std::vector<RawParameter> raw_parameters_;
};

Result<Deck> Deck::read(const std::string& path, FileReader& reader, const ReadOptions& options) {
    return DeckReader(reader, options).read(path);
}

const Parameter* Deck::parameter(ScopeId from, std::string_view name) const {
    for (ScopeId at = from;; at = scope(at).parent) {
        const ParameterTable& table = scope(at).parameters;
        if (const auto found = table.find(name); found != table.end()) return &found->second;
        if (index(at) == 0) break;
    }
    const auto found = global_parameters_.find(name);
    return found == global_parameters_.end() ? nullptr : &found->second;
}

const UnitSystem* Deck::unit(int64_t id) const {
    const auto found = units_.find(id);
    return found == units_.end() ? nullptr : &found->second;
}

std::optional<double> Deck::factor(ScopeId where, int64_t unit_id, Dimension dimension) const {
    const Scope& own = scope(where);
    const int64_t wanted = unit_id ? unit_id : own.unit_id;
    if (wanted == 0) return conversion_factor(own.input, work_, dimension);
    const UnitSystem* from = unit(wanted);
    if (!from) return std::nullopt;
    return conversion_factor(*from, work_, dimension);
}

} // namespace drawbead
