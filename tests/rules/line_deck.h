#pragma once
// A sheet under one bead along a curve, whose list can be damaged in many ways, and its clean twin.
#include "deck/file_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace drawbead {

struct LineDeck {
    enum class Group { nodens, node, set, set_of_nodes, two_clauses };

    int nodes = 14;
    double step = 4.1;
    std::vector<int> gaps; ///< before these nodes the line pauses for eight steps
    bool curved = true;
    bool mixed_ids = false; ///< user ids do not ascend along the line
    std::vector<int> order; ///< of the list; empty: along the line
    bool split = false;     ///< the clean twin of `gaps`: one interface per piece
    Group group = Group::nodens;
    bool shared = false;    ///< a /BCS uses the bead's group
    bool continued = false; ///< an include stands in the middle of the list
    double fn = 80, ft = 100, fn_last = 0, ft_last = 0;
    int version = 2022;
    int iform_column = 0; ///< 0: where the version has it
    int unit = 0;         ///< 1: a /UNIT in kg, m, s of the interface's own
    bool in_include = false, in_submodel = false, windows_lines = false, reversed_sheet = false;
    bool history = false; ///< a /TH/INTER
    int repeated = -1;    ///< this node stands twice in the list

    static std::string right(const std::string& text, std::size_t width) {
        return std::string(width - std::min(width, text.size()), ' ') + text;
    }
    static std::string cells(const std::vector<int>& numbers, std::size_t per_line = 10,
                             const std::string& first = {}) {
        std::string text;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            if (per_line == 9 && i % 9 == 0) text += right(i == 0 ? first : "", 10);
            text += right(std::to_string(numbers[i]), 10);
            if (i % per_line == per_line - 1 || i + 1 == numbers.size()) text += "\n";
        }
        return text;
    }
    static std::string real(double v) {
        char cell[40];
        std::snprintf(cell, sizeof cell, "%.17g", v);
        return right(cell, 20);
    }

    int id_of(int k) const { return 5001 + (mixed_ids ? (k * 37 + 11) % 509 : k); }
    double along(int k) const {
        double s = 10;
        for (int i = 1; i <= k; ++i)
            s += std::count(gaps.begin(), gaps.end(), i) ? 8 * step : step;
        return s;
    }
    std::vector<double> place(int k) const {
        const double s = along(k), r = 90;
        if (!curved) return {20 + 0.1 * s, s, 3};
        return {20 + r * (1 - std::cos(s / r)), 5 + r * std::sin(s / r), 3};
    }

    /// Arc length of a node of the whole line, as the solver sums it.
    double arc(int k) const {
        double s = 0;
        for (int i = 1; i <= k; ++i) {
            const std::vector<double> a = place(i - 1), b = place(i);
            s += std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) +
                           (b[2] - a[2]) * (b[2] - a[2]));
        }
        return s;
    }

    /// The list of one interface as positions along the line.
    std::vector<std::vector<int>> lists() const {
        std::vector<int> all = order;
        for (int k = 0; order.empty() && k < nodes; ++k)
            all.push_back(k);
        if (repeated >= 0) all.insert(all.begin() + repeated + 1, all[static_cast<std::size_t>(repeated)]);
        std::vector<std::vector<int>> out(1);
        for (const int k : all) {
            if (split && std::count(gaps.begin(), gaps.end(), k)) out.emplace_back();
            out.back().push_back(k);
        }
        return out;
    }

    std::string group_block(int id, const std::vector<int>& list) const {
        std::vector<int> ids;
        for (const int k : list)
            ids.push_back(id_of(k));
        const std::string number = std::to_string(id) + "\nbead line\n";
        const auto half = ids.begin() + static_cast<std::ptrdiff_t>(ids.size() / 2);
        switch (group) {
        case Group::nodens:
            if (continued)
                return "/GRNOD/NODENS/" + number + cells({ids.begin(), half}) + "#include licence.inc\n" +
                       cells({half, ids.end()});
            return "/GRNOD/NODENS/" + number + cells(ids);
        case Group::node:
            return "/GRNOD/NODE/" + number + cells(ids);
        case Group::set:
            return "/SET/GENERAL/" + number + cells(ids, 9, "NODENS    ");
        case Group::set_of_nodes:
            return "/SET/GENERAL/" + number + cells(ids, 9, "NODE      ");
        case Group::two_clauses:
            return "/SET/GENERAL/" + number + cells({ids.begin(), half}, 9, "NODENS    ") +
                   cells({half, ids.end()}, 9, "NODENS    ");
        }
        return {};
    }

    /// Force per length of the interface's own unit, N/m: work units are N/mm.
    double in_unit(double v) const { return unit != 0 ? 1000 * v : v; }

    std::string interface_block(int id, int group_id, double first, double last) const {
        std::string head = "/INTER/TYPE8/" + std::to_string(id);
        if (unit != 0) head += "/" + std::to_string(unit);
        const int column = iform_column != 0 ? iform_column : version >= 110 ? 31 : 21;
        std::string references = right(std::to_string(group_id), 10) + right("1", 10);
        references += right("2", static_cast<std::size_t>(column + 9 - 20));
        const auto at = [&](double from, double to, double s) {
            return to == 0 ? from : s <= 0 ? from : s >= 1 ? to : from + s * (to - from);
        };
        const double fa = at(fn, fn_last, first), fb = fn_last == 0 ? 0 : at(fn, fn_last, last);
        const double ta = at(ft, ft_last, first), tb = ft_last == 0 ? 0 : at(ft, ft_last, last);
        const bool wide = version >= 130;
        std::string text = head + "\nbead\n" + references + "\n";
        text += (wide ? real(in_unit(fa)) : right("", 20)) + real(in_unit(ta));
        text += (wide ? real(unit != 0 ? 0.004 : 4) : std::string()) + "\n";
        return text + (version >= 2022 ? real(in_unit(fb)) + real(in_unit(tb)) + "\n" : "\n");
    }

    std::map<std::string, std::string> files() const {
        std::string text =
            "#RADIOSS STARTER\n/BEGIN\nline\n" + right(std::to_string(version), 10) +
            "         0\n                  Mg                  mm                   s\n"
            "                  Mg                  mm                   s\n"
            "/MAT/ELAST/1\nsteel\n            7.85e-09\n            210000.0                 0.3\n"
            "/PROP/SHELL/1\nsheet\n        24         4\n                 0.0\n"
            "         5                           1.0                 0.0\n"
            "/PART/1\nsheet\n         1         1         0\n";
        if (unit != 0) text += "/UNIT/1\nsi\n                  kg                   m                   s\n";
        const int n = 40;
        text += "/NODE\n";
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                text += right(std::to_string(1 + j * (n + 1) + i), 10) + real(5 * i) + real(5 * j) + real(0) +
                        "\n";
        text += "/SHELL/1\n";
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const int a = 1 + j * (n + 1) + i;
                std::vector<int> row{a, a + 1, a + n + 2, a + n + 1};
                if (reversed_sheet) std::reverse(row.begin(), row.end());
                row.insert(row.begin(), 1 + j * n + i);
                text += cells(row);
            }
        text += "/SURF/PART/1\nmain\n         1\n";

        std::string bead = "/NODE\n";
        std::vector<int> held;
        for (int k = 0; k < nodes; ++k) {
            held.push_back(id_of(k));
            bead += right(std::to_string(id_of(k)), 10);
            for (const double v : place(k))
                bead += real(v);
            bead += "\n";
        }
        const double whole = arc(nodes - 1);
        int id = 0;
        std::string groups, interfaces;
        for (const std::vector<int>& list : lists()) {
            ++id;
            groups += group_block(100 + id, list);
            interfaces +=
                interface_block(id, in_submodel ? 3100 + id : 100 + id, split ? arc(list.front()) / whole : 0,
                                split ? arc(list.back()) / whole : 1);
        }
        // The conditions have a list of their own, unless they share the bead's.
        groups += "/GRNOD/NODE/900\nheld\n" + cells(held) + "/BCS/1\nheld\n   111 111         0" +
                  (shared ? "       101" : "       900") + "\n";
        std::map<std::string, std::string> all;
        if (in_submodel) {
            all["bead.inc"] = "#RADIOSS STARTER\n" + bead + groups + "#enddata\n";
            text += "//SUBMODEL/9\ntool\n      3000    100000    200000         0         0         0\n"
                    "#include bead.inc\n//ENDSUB\n";
        } else if (in_include) {
            all["bead.inc"] = "#RADIOSS STARTER\n" + bead + groups + "#enddata\n";
            text += "#include bead.inc\n";
        } else {
            text += bead + groups;
        }
        if (continued) all["licence.inc"] = "a text for people\n";
        text += interfaces;
        if (history) {
            text += "/TH/INTER/1\nth\nDEF\n";
            std::vector<int> ids;
            for (int i = 1; i <= id; ++i)
                ids.push_back(i);
            text += cells(ids);
        }
        all["deck.rad"] = text + "/END\n";
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

} // namespace drawbead
