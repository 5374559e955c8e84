#include "config/baseline.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

using namespace drawbead;
namespace fs = std::filesystem;

namespace {

/// A folder that is taken away again.
class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "drawbead.XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& text) const {
        fs::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name) << text;
        return *this / name;
    }
    std::string text(const std::string& name) const {
        std::ostringstream out;
        out << std::ifstream(path_ / name).rdbuf();
        return out.str();
    }

private:
    fs::path path_;
};

Finding finding(const std::string& code, int64_t id, char print) {
    Finding f;
    f.code = code;
    f.interface_id = id;
    f.fingerprint = std::string(16, print);
    return f;
}

DeckResult result(const std::string& path, std::vector<Finding> findings) {
    DeckResult out;
    out.path = path;
    out.findings = std::move(findings);
    return out;
}

Result<Baseline::Change> write(Baseline& baseline, const Baseline& before, const std::string& path) {
    const Result<std::unique_ptr<FileSink>> file = FileSink::replace(path);
    REQUIRE(file);
    return baseline.write(before, **file);
}

Baseline read(const std::string& path) {
    auto baseline = Baseline::read(path);
    REQUIRE(baseline);
    return std::move(*baseline);
}

std::string error_of(const std::string& path) {
    const auto baseline = Baseline::read(path);
    return baseline ? "" : to_string(baseline.error()).substr(path.size());
}

} // namespace

TEST_CASE("what is written is known afterwards, as often as it was there") {
    const Folder folder;
    const std::string deck = folder.write("a/x_0000.rad", ""), path = folder / "b.json";
    Baseline written(path);
    DeckResult first =
        result(deck, {finding("LIN001", 1, 'a'), finding("LIN001", 1, 'a'), finding("PAR002", 2, 'b')});
    written.learn(first, {});
    CHECK(first.findings.empty());
    CHECK(first.known == 3);
    const auto change = write(written, Baseline(path), path);
    REQUIRE(change);
    CHECK(change->findings == 3);
    CHECK(change->decks == 1);
    CHECK(change->added == 3);
    CHECK(change->removed == 0);

    const Baseline known = read(path);
    DeckResult again = result(deck, {finding("LIN001", 1, 'a'), finding("LIN001", 1, 'a'),
                                     finding("LIN001", 1, 'a'), finding("LIN002", 1, 'c')});
    known.apply(again, {});
    CHECK(again.known == 2);
    REQUIRE(again.findings.size() == 2); // one more than there were, and a new one
    CHECK(again.findings[1].code == "LIN002");
    REQUIRE(again.gone.size() == 1);
    CHECK(again.gone[0].code == "PAR002");
    CHECK(again.gone[0].interface_id == 2);
    // A rule that was not run has nothing that is gone; neither has a deck that could not be read.
    DeckResult partly = result(deck, {});
    known.apply(partly, Selection{{"LIN"}, {}});
    REQUIRE(partly.gone.size() == 1);
    CHECK(partly.gone[0].count == 2);
    DeckResult failed = result(deck, {});
    failed.failure = "gone";
    known.apply(failed, {});
    CHECK(failed.gone.empty());
    DeckResult other = result(folder / "x_0000.rad", {finding("LIN001", 1, 'a')});
    known.apply(other, {});
    CHECK(other.findings.size() == 1);
}

TEST_CASE("a folder may move with its baseline") {
    const Folder folder;
    const std::string deck = folder.write("old/lib/x_0000.rad", ""), path = folder / "old/b.json";
    Baseline written(path);
    DeckResult first = result(deck, {finding("LIN001", 1, 'a')});
    written.learn(first, {});
    REQUIRE(write(written, Baseline(path), path));
    CHECK(folder.text("old/b.json").find("\"lib/x_0000.rad\"") != std::string::npos);
    fs::rename(folder / "old", folder / "new");
    DeckResult moved = result(folder / "new/lib/x_0000.rad", {finding("LIN001", 1, 'a')});
    read(folder / "new/b.json").apply(moved, {});
    CHECK(moved.known == 1);
}

TEST_CASE("writing again says what came and went, and keeps what was not looked at") {
    const Folder folder;
    const std::string path = folder / "b.json";
    const std::string here = folder.write("here_0000.rad", ""), there = folder.write("there_0000.rad", ""),
                      lost = folder / "lost_0000.rad", broken = folder.write("broken_0000.rad", "");
    Baseline first(path);
    for (const std::string& deck : {here, there, lost, broken}) {
        DeckResult one = result(deck, {finding("LIN001", 1, 'a'), finding("PAR002", 1, 'b')});
        first.learn(one, {});
    }
    REQUIRE(write(first, Baseline(path), path));
    const std::string before = folder.text("b.json");

    Baseline second(path);
    DeckResult one = result(here, {finding("LIN002", 1, 'c')}), failed = result(broken, {});
    failed.failure = "no";
    second.learn(one, Selection{{"LIN"}, {}});
    second.learn(failed, Selection{{"LIN"}, {}});
    const auto change = write(second, read(path), path);
    REQUIRE(change);
    CHECK(change->added == 1);            // LIN002
    CHECK(change->removed == 3);          // LIN001 of the deck that was looked at, both of the lost one
    CHECK(change->findings == 2 + 2 + 2); // PAR002 was not run
    CHECK(folder.text("b.json").find("lost_0000.rad") == std::string::npos);

    Baseline third(path); // the same again gives the same bytes
    DeckResult same = result(here, {finding("LIN002", 1, 'c')});
    third.learn(same, Selection{{"LIN"}, {}});
    const std::string now = folder.text("b.json");
    const auto none = write(third, read(path), path);
    REQUIRE(none);
    CHECK(none->added == 0);
    CHECK(none->removed == 0);
    CHECK(folder.text("b.json") == now);
    CHECK(now != before);
}

TEST_CASE("damaged baselines have an error with a place or a next step") {
    const Folder folder;
    CHECK(error_of(folder / "none.json").find("--write-baseline makes one") != std::string::npos);
    CHECK(error_of(folder / "").find("cannot read the baseline") != std::string::npos);
    const auto error = [&](const std::string& text) { return error_of(folder.write("b.json", text)); };
    CHECK(error("").find("JSON was expected") != std::string::npos);
    CHECK(error("{\n  \"a\": 1,\n  x\n}").starts_with(":3:3: error: this is no baseline: JSON was expected"));
    CHECK(error("[]").find("no decks in it") != std::string::npos);
    CHECK(error("{\"schema\": 2, \"decks\": {}}").find("another version") != std::string::npos);
    CHECK(error("{\"schema\": 1, \"decks\": []}").find("decks is no object") != std::string::npos);
    CHECK(error("{\"schema\": 1, \"decks\": {\"a\": 1}}").find("deck 'a' has no list") != std::string::npos);
    for (const char* entry :
         {"1", "{}", "{\"code\": \"A\", \"interface\": 1, \"fingerprint\": \"xyz\", \"count\": 1}",
          "{\"code\": 1, \"interface\": 1, \"fingerprint\": \"0123456789abcdef\", \"count\": 1}",
          "{\"code\": \"A\", \"interface\": 1.5, \"fingerprint\": \"0123456789abcdef\", \"count\": 1}",
          "{\"code\": \"A\", \"interface\": 1, \"fingerprint\": \"0123456789abcdef\", \"count\": -1}"})
        CHECK(error("{\"schema\": 1, \"decks\": {\"a\": [" + std::string(entry) + "]}}")
                  .find("is not complete") != std::string::npos);
    CHECK(error(std::string(1000000, '[')).find("error") != std::string::npos);
    CHECK(error("{\"schema\": 1, \"decks\": {}}").empty());
}
