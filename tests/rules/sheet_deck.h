#pragma once
// A waved sheet under beads, with its main surface written in any of the ways there are, and any of its
// segments the wrong way round.
#include "deck/file_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace drawbead {

struct SheetDeck {
    enum class Surface { part, seg, grshel, surf_of_part, surf_of_seg, set, parts_two };

    struct Bead {
        int id = 1;
        double x = 22;      ///< of its line along y
        double height = 3;  ///< over the sheet; below it when negative
        bool other = false; ///< on surface 2, the same again
    };

    int nx = 10, ny = 8;
    Surface surface = Surface::part;
    bool triangles = false;  ///< every fifth quad as two triangles
    int island_from = 0;     ///< a slit in front of this column of elements
    std::set<int> flipped;   ///< ids of elements the other way round (their SEG lines where there are any)
    bool keep_first = false; ///< a flipped element keeps its first node: 1432, not 4321
    std::set<int> minus;     ///< ids of parts or groups with a minus sign
    std::vector<Bead> beads{Bead{}};
    std::string more; ///< further blocks
    int version = 2022;
    bool in_include = false;  ///< the sheet and its surface
    bool in_submodel = false; ///< with offsets, the include as well
    bool windows_lines = false;
    double fn_last = 0;
    double wave = 1; ///< 0: the sheet is flat

    struct Element {
        int id;
        std::vector<int> n;
        bool second_part;
    };

    int columns() const { return nx + 1 + (island_from > 0); }
    int node_id(int i, int j) const { return 1 + j * columns() + i; }
    double height_at(double x, double y) const {
        return wave * (0.8 * std::sin(0.11 * x) + 0.5 * std::cos(0.13 * y));
    }

    std::vector<Element> elements() const {
        std::vector<Element> all;
        int id = 0;
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const int s = island_from > 0 && i >= island_from ? 1 : 0; // nodes beyond the slit
                const int a = node_id(i + s, j), b = node_id(i + 1 + s, j), c = node_id(i + 1 + s, j + 1),
                          d = node_id(i + s, j + 1);
                const bool second = i >= nx / 2;
                ++id;
                if (triangles && id % 5 == 0) {
                    all.push_back({id, {a, b, c}, second});
                    all.push_back({1000 + id, {a, c, d}, second});
                } else {
                    all.push_back({id, {a, b, c, d}, second});
                }
            }
        return all;
    }

    static std::string cells(const std::vector<int>& numbers) {
        std::string line;
        char cell[16];
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            std::snprintf(cell, sizeof cell, "%10d", numbers[i]);
            line += cell;
            if (i % 10 == 9 && i + 1 < numbers.size()) line += "\n";
        }
        return line + "\n";
    }

    bool lists_segments() const { return surface == Surface::seg || surface == Surface::surf_of_seg; }

    std::vector<int> nodes_of(const Element& e, bool damaged) const {
        std::vector<int> n = e.n;
        if (damaged && flipped.count(e.id)) {
            n.assign(e.n.rbegin(), e.n.rend());
            if (keep_first) std::rotate(n.begin(), n.end() - 1, n.end());
        }
        return n;
    }

    std::string element_blocks() const {
        std::map<std::string, std::string> tables;
        for (const Element& e : elements()) {
            const int part = surface == Surface::parts_two && e.second_part ? 2 : 1;
            std::vector<int> row = nodes_of(e, !lists_segments());
            row.insert(row.begin(), e.id);
            tables[(e.n.size() == 4 ? "/SHELL/" : "/SH3N/") + std::to_string(part)] += cells(row);
        }
        std::string text;
        for (const auto& [header, rows] : tables)
            text.append(header).append("\n").append(rows);
        return text;
    }

    int signed_id(int id) const { return minus.count(id) ? -id : id; }

    std::string surface_blocks(int id) const {
        const std::string number = std::to_string(id);
        const auto list = [&](const std::string& type, int sid, const std::vector<int>& ids) {
            return "/SURF/" + type + "/" + std::to_string(sid) + "\nmain\n" + cells(ids);
        };
        const auto seg = [&](int sid) {
            std::string text = "/SURF/SEG/" + std::to_string(sid) + "\nmain\n";
            int line = 0;
            for (const Element& e : elements()) {
                std::vector<int> row = nodes_of(e, true);
                if (row.size() == 3) row.push_back(row.back());
                row.insert(row.begin(), ++line);
                text += cells(row);
            }
            return text;
        };
        switch (surface) {
        case Surface::part:
            return list("PART", id, {signed_id(1)});
        case Surface::parts_two:
            return list("PART", id, {signed_id(1), signed_id(2)});
        case Surface::seg:
            return seg(id);
        case Surface::surf_of_seg:
            return list("SURF", id, {id + 50}) + seg(id + 50);
        case Surface::surf_of_part:
            return list("SURF", id, {signed_id(id + 50)}) + list("PART", id + 50, {1});
        case Surface::set:
            return "/SET/GENERAL/" + number + "\nmain\n" + (minus.count(1) ? "PART_O    " : "PART      ") +
                   cells({1});
        case Surface::grshel: {
            std::vector<int> quads, threes;
            for (const Element& e : elements())
                (e.n.size() == 4 ? quads : threes).push_back(e.id);
            std::string text = "/GRSHEL/SHEL/" + number + "\nquads\n" + cells(quads);
            if (threes.empty()) return text + list("GRSHEL", id, {signed_id(id)});
            return text + "/GRSH3N/SH3N/" + number + "\ntriangles\n" + cells(threes) +
                   list("GRSHEL", id + 60, {signed_id(id)}) + list("GRSH3N", id + 61, {signed_id(id)}) +
                   list("SURF", id, {id + 60, id + 61});
        }
        }
        return {};
    }

    static std::string real(double v) {
        char cell[32];
        std::snprintf(cell, sizeof cell, "%20.10g", v);
        return cell;
    }

    std::string sheet() const {
        std::string text = "/NODE\n";
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i < columns(); ++i) {
                const int step = island_from > 0 && i > island_from ? i - 1 : i;
                const double x = 5 * step + 0.7 * std::sin(step + 2.0 * j),
                             y = 5 * j + 0.5 * std::cos(j + 1.7 * step);
                char id[16];
                std::snprintf(id, sizeof id, "%10d", node_id(i, j));
                text += id + real(x) + real(y) + real(height_at(x, y)) + "\n";
            }
        text += element_blocks() + surface_blocks(1);
        for (const Bead& bead : beads)
            if (bead.other) return text + surface_blocks(2);
        return text;
    }

    /// Text by file name; "deck.rad" is the main one.
    std::map<std::string, std::string> files() const {
        const bool wide = version >= 130;
        char number[16];
        std::snprintf(number, sizeof number, "%10d", version);
        std::string text =
            std::string("#RADIOSS STARTER\n/BEGIN\nsheet\n") + number +
            "         0\n                  Mg                  mm                   s\n"
            "                  Mg                  mm                   s\n"
            "/MAT/ELAST/1\nsteel\n            7.85e-09\n            210000.0                 0.3\n"
            "/PROP/SHELL/1\nsheet\n        24         4\n                 0.0\n"
            "         5                           1.0                 0.0\n"
            "/PART/1\nleft\n         1         1         0\n";
        if (surface == Surface::parts_two) text += "/PART/2\nright\n         1         1         0\n";
        std::map<std::string, std::string> all;
        if (in_submodel) {
            all["sheet.inc"] = "#RADIOSS STARTER\n" + sheet() + "#enddata\n";
            text += "//SUBMODEL/9\nblank\n         0    100000    200000         0         0         0\n"
                    "#include sheet.inc\n//ENDSUB\n";
        } else if (in_include) {
            all["sheet.inc"] = "#RADIOSS STARTER\n" + sheet() + "#enddata\n";
            text += "#include sheet.inc\n";
        } else {
            text += sheet();
        }
        text += "/NODE\n";
        std::vector<int> held;
        for (const Bead& bead : beads)
            for (int k = 0; k < 7; ++k) {
                const double x = bead.x + 0.3 * k, y = 5.3 + 4.1 * k;
                const int node = 5000 + 100 * bead.id + k;
                held.push_back(node);
                char id[16];
                std::snprintf(id, sizeof id, "%10d", node);
                text += id + real(x) + real(y) + real(height_at(x, y) + bead.height) + "\n";
            }
        text += "/GRNOD/NODE/900\nheld\n" + cells(held) + "/BCS/1\nheld\n   111 111         0       900\n";
        for (const Bead& bead : beads) {
            std::vector<int> nodes;
            for (int k = 0; k < 7; ++k)
                nodes.push_back(5000 + 100 * bead.id + k);
            text += "/GRNOD/NODENS/" + std::to_string(100 + bead.id) + "\nbead line\n" + cells(nodes);
            text += "/INTER/TYPE8/" + std::to_string(bead.id) + "\nbead\n";
            std::string references = cells({100 + bead.id, bead.other ? 2 : 1});
            references.pop_back();
            text += references + (version >= 110 ? "                   2\n" : "         2\n");
            text += (wide ? real(60) : std::string(20, ' ')) + real(40) + (wide ? real(4) : "") + "\n";
            if (version >= 2022) text += real(fn_last) + real(0) + "\n";
            if (version < 2022) text += "\n";
        }
        text += more + "/END\n";
        all["deck.rad"] = text;
        if (windows_lines)
            for (auto& [name, content] : all) {
                std::string crlf;
                for (const char c : content)
                    crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
                content = crlf;
            }
        return all;
    }
};

inline MemoryReader reader_of(const std::map<std::string, std::string>& files) {
    MemoryReader reader;
    for (const auto& [name, text] : files)
        reader.add(name, text);
    return reader;
}

} // namespace drawbead
