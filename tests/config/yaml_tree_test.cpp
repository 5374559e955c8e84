#include "config/yaml_tree.h"

#include <catch2/catch.hpp>

using namespace drawbead;

namespace {

std::string error_of(const std::string& text) {
    const auto node = read_yaml(text, "c");
    return node ? "" : to_string(node.error());
}

} // namespace

TEST_CASE("maps, lists and scalars with their places") {
    const auto root = read_yaml("a: 1\nb: [x, 'y']\nc:\n  - {d: ''}\n", "c");
    REQUIRE(root);
    REQUIRE(root->entries.size() == 3);
    CHECK(root->entries[0].second.text == "1");
    CHECK_FALSE(root->entries[0].second.quoted);
    const YamlNode& list = root->entries[1].second;
    REQUIRE(list.items.size() == 2);
    CHECK(list.items[1].text == "y");
    CHECK(list.items[1].quoted);
    CHECK(list.items[1].line == 2);
    CHECK(list.items[1].column == 8);
    CHECK(root->entries[2].second.items[0].entries[0].second.kind == YamlNode::Kind::scalar);
    CHECK(read_yaml("", "c")->kind == YamlNode::Kind::empty);
    CHECK(read_yaml("# only this\n", "c")->kind == YamlNode::Kind::empty);
    CHECK(read_yaml("---\na: 1\n...\n", "c")->entries.size() == 1);
}

TEST_CASE("what is no configuration is refused, with its place") {
    CHECK(error_of("a: 1\na: 2\n") == "c:2:1: error: key 'a' stands twice");
    CHECK(error_of("x:\n  - b: {q: 1, r: 2, q: 3}\n") == "c:2:21: error: key 'q' stands twice");
    CHECK(error_of("a: &x 1\n").starts_with("c:1:4: error: anchors are not read here"));
    CHECK(error_of("a: *x\n").starts_with("c:1:4: error: "));
    CHECK(error_of("a: !!int 1\n").starts_with("c:1:4: error: tags are not read here"));
    CHECK(error_of("[1, 2]: 3\n").starts_with("c:1:1: error: a key must be a word"));
    CHECK(error_of("a: 1\n---\nb: 2\n").starts_with("c:3:1: error: a second document begins here"));
    CHECK(error_of("a: [1\n").find("this is no YAML") != std::string::npos);
    CHECK(error_of("a: 1\nb\xff: 2\n") ==
          "c:2:2: error: this byte is no text in UTF-8; save the file as plain UTF-8");
    CHECK(error_of(std::string("a: \0 b", 6)).starts_with("c:1:4: error: this byte"));
    CHECK(error_of("\xff\xfe"
                   "a")
              .starts_with("c:1:1: error: this byte"));
}

TEST_CASE("bombs are refused soon") {
    CHECK(error_of(std::string(100000, '[')).find("error") != std::string::npos);
    CHECK(error_of(std::string(20, '[') + std::string(20, ']')).find("nested too deeply") !=
          std::string::npos);
    CHECK(error_of(std::string(100000, '{')).find("error") != std::string::npos);
    std::string deep;
    for (int i = 0; i < 600; ++i)
        deep += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
    CHECK(error_of(deep).find("error") != std::string::npos);
    CHECK(error_of("a: &a [x,x]\nb: &b [*a,*a]\nc: [*b,*b]\n").find("anchors") != std::string::npos);
    CHECK(error_of(std::string((std::size_t{1} << 20) + 1, '#')) == "c: error: the file is larger than 1 MB");
}
