#include "report/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace drawbead {

namespace {

constexpr double width = 860, height = 560, left = 104, right = 210, top = 50, bottom = 70;
constexpr double least_error = 1e-10; ///< what is smaller is drawn here

std::string fixed(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '&')
            out += "&amp;";
        else if (c == '"')
            out += "&quot;";
        else if (static_cast<unsigned char>(c) < 32)
            out += '?';
        else
            out += c;
    }
    return out;
}

/// Decades of both axes.
struct Scale {
    double x0 = 0, x1 = 1, y0 = -1, y1 = 0;

    double x(double evaluations) const {
        return left + (std::log10(evaluations) - x0) / (x1 - x0) * (width - left - right);
    }
    double y(double error) const {
        return top + (y1 - std::log10(std::max(error, least_error))) / (y1 - y0) * (height - top - bottom);
    }
};

class Drawing {
public:
    Drawing(OutputSink& out, const AccuracyReport& report) : out_(out), r_(report) {
        double lo = 1e300, hi = 1, best = 1, worst = least_error;
        for (const AccuracyRow& row : r_.rows) {
            const auto n = static_cast<double>(std::max<uint64_t>(row.evaluations, 1));
            lo = std::min(lo, n);
            hi = std::max(hi, n);
            best = std::min(best, std::max(row.error, least_error));
            worst = std::max(worst, row.error);
        }
        if (r_.rows.empty()) lo = 1, hi = 10;
        scale_.x0 = std::floor(std::log10(lo) + 1e-9);
        scale_.x1 = std::max(std::ceil(std::log10(hi) - 1e-9), scale_.x0 + 1);
        // The tolerances that are marked are always in view.
        scale_.y0 = std::min(std::floor(std::log10(best) + 1e-9), -4.5);
        scale_.y1 = std::max(std::ceil(std::log10(worst) - 1e-9), -1.0);
    }

    void draw() {
        out_.write("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + fixed(width) + "\" height=\"" +
                   fixed(height) + "\" viewBox=\"0 0 " + fixed(width) + " " + fixed(height) +
                   "\" font-family=\"sans-serif\" font-size=\"12\">\n");
        out_.write("<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n");
        text(left, 28, "Error against cost, " + escaped(r_.scene.empty() ? r_.deck : r_.scene), "start", 15);
        axes();
        front();
        points();
        legend();
        out_.write("</svg>\n");
    }

private:
    void line(double x0, double y0, double x1, double y1, const std::string& style) {
        out_.write("<line x1=\"" + fixed(x0) + "\" y1=\"" + fixed(y0) + "\" x2=\"" + fixed(x1) + "\" y2=\"" +
                   fixed(y1) + "\" " + style + "/>\n");
    }
    void text(double x, double y, const std::string& what, const char* anchor, int size = 12,
              const std::string& more = {}) {
        out_.write("<text x=\"" + fixed(x) + "\" y=\"" + fixed(y) + "\" text-anchor=\"" + anchor +
                   "\" font-size=\"" + std::to_string(size) + "\" " + more + ">" + what + "</text>\n");
    }

    void axes() {
        const double x_end = width - right, y_end = height - bottom;
        for (int d = static_cast<int>(scale_.x0); d <= static_cast<int>(scale_.x1); ++d) {
            const double x = scale_.x(std::pow(10.0, d));
            line(x, top, x, y_end, "stroke=\"#dddddd\"");
            text(x, y_end + 18, "10<tspan dy=\"-5\" font-size=\"9\">" + std::to_string(d) + "</tspan>",
                 "middle");
        }
        for (int d = static_cast<int>(std::ceil(scale_.y0)); d <= static_cast<int>(scale_.y1); ++d) {
            const double y = scale_.y(std::pow(10.0, d));
            line(left, y, x_end, y, "stroke=\"#dddddd\"");
            std::string label = d <= -7 ? "10<tspan dy=\"-5\" font-size=\"9\">" + std::to_string(d + 2) +
                                              "</tspan><tspan dy=\"5\"> %</tspan>"
                                        : number(d + 2) + " %";
            if (d == static_cast<int>(std::round(std::log10(least_error)))) label = "&#8804; " + label;
            text(left - 8, y + 4, label, "end");
        }
        for (const AccuracyPick& pick : r_.picks) {
            const double y = scale_.y(pick.tolerance);
            line(left, y, x_end, y, "stroke=\"#b03030\" stroke-dasharray=\"5 4\"");
        }
        if (r_.known_to < std::pow(10.0, scale_.y1)) {
            const double y = scale_.y(r_.known_to);
            line(left, y, x_end, y, "stroke=\"#808080\" stroke-dasharray=\"2 3\"");
            text(x_end + 6, y + 4, "Ft is known to about this", "start", 11, "fill=\"#606060\"");
        }
        out_.write("<rect x=\"" + fixed(left) + "\" y=\"" + fixed(top) + "\" width=\"" + fixed(x_end - left) +
                   "\" height=\"" + fixed(y_end - top) + "\" fill=\"none\" stroke=\"black\"/>\n");
        text(0.5 * (left + x_end), y_end + 48, "evaluations of the law at a point", "middle", 13);
        text(22, 0.5 * (top + y_end), "largest relative error of all quantities and beads", "middle", 13,
             "transform=\"rotate(-90 22 " + fixed(0.5 * (top + y_end)) + ")\"");
    }

    static std::string number(int decade) {
        if (decade >= 0) return std::to_string(static_cast<long long>(std::llround(std::pow(10.0, decade))));
        return "0." + std::string(static_cast<std::size_t>(-decade - 1), '0') + "1";
    }

    /// The lowest error so far, from cheap to dear.
    void front() {
        std::vector<const AccuracyRow*> rows;
        for (const AccuracyRow& row : r_.rows)
            if (row.on_front) rows.push_back(&row);
        std::stable_sort(rows.begin(), rows.end(), [](const AccuracyRow* a, const AccuracyRow* b) {
            return a->evaluations != b->evaluations ? a->evaluations < b->evaluations : a->error > b->error;
        });
        std::string path;
        double best = 1e300, y = 0;
        for (const AccuracyRow* row : rows) {
            if (!(row->error < best)) continue;
            best = row->error;
            const double x = scale_.x(static_cast<double>(std::max<uint64_t>(row->evaluations, 1)));
            path += path.empty() ? "M" : " L" + fixed(x) + " " + fixed(y) + " L";
            y = scale_.y(row->error);
            path += fixed(x) + " " + fixed(y);
        }
        if (!path.empty())
            out_.write("<path d=\"" + path + "\" fill=\"none\" stroke=\"black\" stroke-width=\"1.5\"/>\n");
    }

    static std::string word(const AccuracyRow& row, const std::string& key) {
        for (const auto& [name, value] : row.settings)
            if (name == key) return value;
        return {};
    }

    /// How the line becomes points: one colour each.
    static std::string family_of(const AccuracyRow& row) {
        const std::string line = word(row, "line");
        if (line == "nodes") return "nodes, " + word(row, "tributary");
        return line == "adaptive" ? line : line + " points per hop";
    }
    static bool is_plain(const AccuracyRow& row) {
        return word(row, "projection") == "exact" && word(row, "search") == "exact" &&
               word(row, "sum") == "compensated" && word(row, "number") == "double";
    }

    void points() {
        static constexpr std::array<const char*, 8> colours{"#1b6ca8", "#d9822b", "#2e8b57", "#8e44ad",
                                                            "#c0392b", "#16a0a0", "#7f6000", "#555555"};
        for (const AccuracyRow& row : r_.rows) {
            const auto [place, is_new] = colour_.emplace(family_of(row), "");
            if (is_new) {
                place->second = colours[families_.size() % colours.size()];
                families_.push_back(place->first);
            }
            const double x = scale_.x(static_cast<double>(std::max<uint64_t>(row.evaluations, 1))),
                         y = scale_.y(row.error);
            const std::string title = "<title>" + escaped(row.brief) + "</title>", colour = place->second;
            if (!is_plain(row))
                out_.write("<path d=\"M" + fixed(x - 4) + " " + fixed(y - 4) +
                           " l8 8 m0 -8 l-8 8\" stroke=\"" + colour +
                           "\" stroke-width=\"1.4\" fill=\"none\">" + title + "</path>\n");
            else if (word(row, "kinks") == "stepped")
                out_.write("<circle cx=\"" + fixed(x) + "\" cy=\"" + fixed(y) + "\" r=\"3.5\" fill=\"" +
                           colour + "\" fill-opacity=\"0.75\">" + title + "</circle>\n");
            else
                out_.write("<rect x=\"" + fixed(x - 3.5) + "\" y=\"" + fixed(y - 3.5) +
                           "\" width=\"7\" height=\"7\" fill=\"none\" stroke-width=\"1.6\" stroke=\"" +
                           colour + "\">" + title + "</rect>\n");
        }
        for (const AccuracyPick& pick : r_.picks) {
            if (!pick.row) continue;
            const AccuracyRow& row = r_.rows[*pick.row];
            out_.write("<circle cx=\"" + fixed(scale_.x(static_cast<double>(row.evaluations))) + "\" cy=\"" +
                       fixed(scale_.y(row.error)) +
                       "\" r=\"8\" fill=\"none\" stroke=\"#b03030\" stroke-width=\"1.8\"/>\n");
        }
    }

    void legend() {
        const double x = width - right + 16;
        double y = height - bottom - 18.0 * (static_cast<double>(families_.size()) + 6);
        y = std::max(y, top + 110);
        for (const std::string& family : families_) {
            out_.write("<circle cx=\"" + fixed(x) + "\" cy=\"" + fixed(y - 4) + "\" r=\"4\" fill=\"" +
                       colour_[family] + "\"/>\n");
            text(x + 12, y, escaped(family), "start", 11);
            y += 18;
        }
        out_.write("<rect x=\"" + fixed(x - 4) + "\" y=\"" + fixed(y - 8) +
                   "\" width=\"7\" height=\"7\" fill=\"none\" stroke=\"black\" stroke-width=\"1.6\"/>\n");
        text(x + 12, y, "the same, steps split at kinks", "start", 11);
        y += 18;
        out_.write("<path d=\"M" + fixed(x - 4) + " " + fixed(y - 8) +
                   " l8 8 m0 -8 l-8 8\" stroke=\"black\" stroke-width=\"1.4\" fill=\"none\"/>\n");
        text(x + 12, y, "another projection, search,", "start", 11);
        y += 14;
        text(x + 12, y, "sum or number", "start", 11);
        y += 18;
        line(x - 6, y - 4, x + 7, y - 4, "stroke=\"black\" stroke-width=\"1.5\"");
        text(x + 12, y, "Pareto front", "start", 11);
        y += 18;
        line(x - 6, y - 4, x + 7, y - 4, "stroke=\"#b03030\" stroke-dasharray=\"5 4\"");
        text(x + 12, y, "tolerances", "start", 11);
        y += 18;
        out_.write("<circle cx=\"" + fixed(x) + "\" cy=\"" + fixed(y - 4) +
                   "\" r=\"6\" fill=\"none\" stroke=\"#b03030\" stroke-width=\"1.8\"/>\n");
        text(x + 12, y, "cheapest within them", "start", 11);
    }

    OutputSink& out_;
    const AccuracyReport& r_;
    Scale scale_;
    std::map<std::string, std::string> colour_;
    std::vector<std::string> families_;
};

} // namespace

void write_accuracy_svg(OutputSink& out, const AccuracyReport& report) {
    Drawing(out, report).draw();
}

} // namespace drawbead
