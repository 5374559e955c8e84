#pragma once
// Small decks in memory, built into models.
#include "model/model.h"

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

namespace drawbead {

struct Built {
    std::unique_ptr<Deck> deck; ///< at a fixed address: the model refers to it
    Model model;

    const Drawbead& bead(std::size_t i = 0) const { return model.drawbeads().at(i); }
    const NodeGroup& group(std::size_t i = 0) const { return model.groups().at(i); }
    const Surface& surface(std::size_t i = 0) const { return model.surfaces().at(i); }

    std::size_t issues(ReadIssue::Kind kind) const {
        std::size_t count = 0;
        for (const ReadIssue& issue : model.issues())
            count += issue.kind == kind;
        return count;
    }
    /// User ids of the nodes of a group.
    std::vector<uint32_t> nodes(std::size_t group = 0) const {
        std::vector<uint32_t> ids;
        for (const NodeRow row : model.groups().at(group).nodes)
            ids.push_back(value(model.nodes().user_id(row)));
        return ids;
    }
    /// User node ids of each segment, in the table's order.
    std::vector<std::vector<uint32_t>> segments(std::size_t surface = 0) const {
        std::vector<std::vector<uint32_t>> all;
        for (const Segment& segment : model.surfaces().at(surface).segments) {
            std::vector<uint32_t> ids;
            for (const NodeRow row : segment.n)
                ids.push_back(value(model.nodes().user_id(row)));
            all.push_back(ids);
        }
        return all;
    }
};

inline constexpr Needs everything = Needs::counts | Needs::coordinates | Needs::blank_elements |
                                    Needs::element_thickness | Needs::surface_users | Needs::attachments;

inline Built build(const std::string& text, Needs needs = everything, MemoryReader reader = {}) {
    reader.add("main_0000.rad", text);
    auto deck = Deck::read("main_0000.rad", reader);
    REQUIRE(deck);
    Built built;
    built.deck = std::make_unique<Deck>(std::move(*deck));
    built.model = Model::build(*built.deck, needs, 2);
    return built;
}

inline std::string begin_of(int version, const std::string& input = "", const std::string& work = "") {
    const std::string standard = "                  Mg                  mm                   s\n";
    std::string number = std::to_string(version);
    number = std::string(10 - number.size(), ' ') + number + "         0\n";
    std::string text = "#RADIOSS STARTER\n/BEGIN\nrun\n" + number;
    if (version >= 100) text += (input.empty() ? standard : input) + (work.empty() ? standard : work);
    return text;
}

/// A line of right-aligned cells of the widths that integers and reals have.
inline std::string cells(std::initializer_list<std::string> texts, std::size_t width) {
    std::string line;
    for (const std::string& text : texts)
        line += std::string(width - text.size(), ' ') + text;
    return line + '\n';
}
inline std::string ids(std::initializer_list<int> numbers) {
    std::string line;
    for (const int number : numbers) {
        const std::string text = std::to_string(number);
        line += std::string(10 - text.size(), ' ') + text;
    }
    return line + '\n';
}
inline std::string reals(std::initializer_list<std::string> texts) {
    return cells(texts, 20);
}
inline std::string node(int id, const std::string& x, const std::string& y, const std::string& z) {
    return cells({std::to_string(id)}, 10).substr(0, 10) + reals({x, y, z});
}

inline const std::string steel =
    "/MAT/ELAST/1\nsteel\n             7.85E-9\n              210000                  .3\n";
inline const std::string sheet = "/PROP/SHELL/1\nsheet\n\n\n         5                           1.0\n";

/// Two shells side by side under three bead nodes: the smallest drawbead.
///
///     4 --- 5 --- 6
///     |  1  |  2  |        bead nodes 101 102 103 at z = 3, y = 5
///     1 --- 2 --- 3
inline std::string mesh() {
    std::string text = steel + sheet + "/PART/1\nblank\n" + ids({1, 1, 0}) + "/NODE\n";
    for (int i = 0; i < 6; ++i)
        text += node(i + 1, std::to_string(10 * (i % 3)) + ".0", std::to_string(10 * (i / 3)) + ".0", "0.0");
    for (int i = 1; i <= 3; ++i)
        text += node(100 + i, std::to_string(5 * i) + ".0", "5.0", "3.0");
    return text + "/SHELL/1\n" + ids({1, 1, 2, 5, 4}) + ids({2, 2, 3, 6, 5});
}
inline const std::string part_surface = "/SURF/PART/1\nblank top\n         1\n";
inline const std::string bead_group = "/GRNOD/NODENS/2\nbead line\n" + ids({101, 102, 103});
/// /INTER/TYPE8 on node group 2 and surface 1.
inline const std::string drawbead_block = "/INTER/TYPE8/1\nbead\n"
                                          "         2         1                   2\n" +
                                          reals({"80.", "100.", "2.", "0.", "0."}) + reals({"60.", "90."});

} // namespace drawbead
