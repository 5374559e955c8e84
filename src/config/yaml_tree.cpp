#include "config/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <streambuf>

namespace drawbead {

namespace {

constexpr std::size_t largest_text = std::size_t{1} << 20, deepest = 16;

/// Thrown only inside this file: yaml-cpp reports by exceptions too.
struct Refused {
    YAML::Mark mark;
    std::string message, help;
};

/// Builds the tree from the parser's events.
class Builder final : public YAML::EventHandler {
public:
    YamlNode root;

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add(mark, "", anchor, YamlNode::Kind::empty);
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        throw Refused{mark, "aliases are not read here", "write the value again"};
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        YamlNode& node = add(mark, tag, anchor, YamlNode::Kind::scalar);
        node.quoted = tag == "!";
        node.text = value;
        if (node.text.empty() && !node.quoted) node.kind = YamlNode::Kind::empty;
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(add(mark, tag, anchor, YamlNode::Kind::list), mark);
    }
    void OnSequenceEnd() override { open_.pop_back(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(add(mark, tag, anchor, YamlNode::Kind::map), mark);
    }
    void OnMapEnd() override { open_.pop_back(); }

private:
    struct Open {
        YamlNode* node;
        bool key_is_next = true;
    };
    std::vector<Open> open_; ///< from the root; only the last one grows, so that the pointers hold

    void open(YamlNode& node, const YAML::Mark& mark) {
        if (open_.size() == deepest) throw Refused{mark, "this is nested too deeply", ""};
        open_.push_back({&node});
    }

    YamlNode& add(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YamlNode::Kind kind) {
        if (anchor != 0)
            throw Refused{mark, "anchors are not read here", "write the value where it is needed"};
        if (!tag.empty() && tag != "!" && tag != "?") throw Refused{mark, "tags are not read here", ""};
        YamlNode node;
        node.kind = kind;
        node.line = static_cast<uint64_t>(std::max(mark.line, 0)) + 1;
        node.column = static_cast<uint32_t>(std::max(mark.column, 0)) + 1;
        if (open_.empty()) return root = std::move(node);
        Open& parent = open_.back();
        if (parent.node->kind == YamlNode::Kind::list)
            return parent.node->items.emplace_back(std::move(node));
        auto& entries = parent.node->entries;
        parent.key_is_next = !parent.key_is_next;
        if (parent.key_is_next) {
            const YamlNode& of = entries.back().first;
            if (kind == YamlNode::Kind::empty) // a value that is not there is missed at its key
                node.line = of.line, node.column = of.column;
            return entries.back().second = std::move(node);
        }
        if (kind == YamlNode::Kind::list || kind == YamlNode::Kind::map)
            throw Refused{mark, "a key must be a word", ""};
        return entries.emplace_back(YamlEntry{std::move(node), {}}).first;
    }
};

/// The offset of the first byte that is no UTF-8, no tab, no line end and no printable character.
std::size_t first_bad_byte(std::string_view text) {
    std::size_t i = 0;
    const auto byte = [&](std::size_t at) {
        return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
    };
    while (i < text.size()) {
        const unsigned first = byte(i);
        if (first < 0x80) {
            if ((first < 0x20 && first != '\t' && first != '\n' && first != '\r') || first == 0x7f) return i;
            ++i;
            continue;
        }
        const std::size_t more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : 1;
        if (first < 0xc2 || first > 0xf4) return i;
        for (std::size_t k = 1; k <= more; ++k)
            if ((byte(i + k) & 0xc0) != 0x80) return i;
        const unsigned second = byte(i + 1);
        if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
            (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
            return i;
        i += more + 1;
    }
    return std::string_view::npos;
}

/// A text as a stream, without a copy and without an iostream of the text's own.
class TextBuffer final : public std::streambuf {
public:
    explicit TextBuffer(std::string_view text) {
        char* begin = const_cast<char*>(text.data()); // only read
        setg(begin, begin, begin + text.size());
    }
};

/// A key that stands twice in its map; nullptr when there is none.
const YamlNode* repeated_key(const YamlNode& node) {
    std::vector<const YamlNode*> keys;
    for (const auto& [key, value] : node.entries)
        keys.push_back(&key);
    std::stable_sort(keys.begin(), keys.end(),
                     [](const YamlNode* a, const YamlNode* b) { return a->text < b->text; });
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (keys[i]->text == keys[i - 1]->text) return keys[i];
    for (const auto& [key, value] : node.entries)
        if (const YamlNode* found = repeated_key(value)) return found;
    for (const YamlNode& item : node.items)
        if (const YamlNode* found = repeated_key(item)) return found;
    return nullptr;
}

Error error_at(std::string message, const std::string& path, const YAML::Mark& mark, std::string help) {
    return {std::move(message), path, static_cast<uint64_t>(std::max(mark.line, 0)) + 1,
            static_cast<uint32_t>(std::max(mark.column, 0)) + 1, std::move(help)};
}

} // namespace

Result<YamlNode> read_yaml(std::string_view text, const std::string& path) {
    if (text.size() > largest_text) return Error{"the file is larger than 1 MB", path, 0, 0, ""};
    if (const std::size_t bad = first_bad_byte(text); bad != std::string_view::npos) {
        const std::string_view before = text.substr(0, bad);
        const auto line = static_cast<uint64_t>(std::count(before.begin(), before.end(), '\n')) + 1;
        const std::size_t newline = before.rfind('\n');
        const std::size_t column = newline == std::string_view::npos ? bad + 1 : bad - newline;
        return Error{"this byte is no text in UTF-8", path, line, static_cast<uint32_t>(column),
                     "save the file as plain UTF-8"};
    }
    try {
        TextBuffer buffer(text);
        std::istream stream(&buffer);
        YAML::Parser parser(stream);
        Builder builder;
        if (!parser.HandleNextDocument(builder)) return YamlNode{};
        Builder second;
        if (parser.HandleNextDocument(second) && second.root.line != 0)
            return Error{"a second document begins here", path, second.root.line, second.root.column,
                         "one file holds one configuration"};
        if (const YamlNode* key = repeated_key(builder.root))
            return Error{"key '" + key->text + "' stands twice", path, key->line, key->column, ""};
        return std::move(builder.root);
    } catch (const Refused& refused) {
        return error_at(refused.message, path, refused.mark, refused.help);
    } catch (const YAML::Exception& error) {
        return error_at("this is no YAML: " + error.msg, path, error.mark, "");
    }
}

} // namespace drawbead
