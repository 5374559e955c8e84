// Every traced cycle of every scene, from the folder of full traces that DRAWBEAD_TRUTH names (too large to
// keep here).
#include "scene.h"

#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>

using namespace drawbead;

namespace {

/// Rows of a gzipped table by column name.
class Trace {
public:
    explicit Trace(const std::string& path) : pipe_(popen(("gzip -dc '" + path + "'").c_str(), "r")) {
        std::vector<std::string> names = cells();
        for (std::size_t k = 0; k < names.size(); ++k)
            column_[names[k]] = k;
    }
    Trace(const Trace&) = delete;
    Trace& operator=(const Trace&) = delete;
    ~Trace() { pclose(pipe_); }

    bool next() {
        const std::vector<std::string> row = cells();
        value_.clear();
        for (const std::string& cell : row)
            value_.push_back(std::strtod(cell.c_str(), nullptr));
        return value_.size() == column_.size() && !value_.empty();
    }
    double operator[](const char* name) const { return value_[column_.at(name)]; }
    uint32_t id(const char* name) const { return static_cast<uint32_t>((*this)[name]); }
    Vec3 vector(const char* x, const char* y, const char* z) const {
        return {(*this)[x], (*this)[y], (*this)[z]};
    }

private:
    std::FILE* pipe_;
    std::map<std::string, std::size_t> column_;
    std::vector<double> value_;

    std::vector<std::string> cells() {
        std::vector<std::string> out(1);
        int c = 0;
        while ((c = std::fgetc(pipe_)) != EOF && c != '\n') {
            if (c == ',')
                out.emplace_back();
            else if (c != '\r')
                out.back() += static_cast<char>(c);
        }
        return out;
    }
};

struct Replayed {
    std::size_t rows = 0, same_bits = 0, other_segment = 0, refined = 0;
    double drift = 0; ///< largest distance of a traced corner from where the blank's motion puts it
};

Replayed replay(const Scene& scene, const std::string& trace_path) {
    Replayed out;
    std::vector<NearMesh> mesh;
    std::vector<std::vector<Track>> track;
    std::vector<std::vector<Vec3>> blank;
    for (const auto& bead : scene.bead) {
        const std::vector<Vec3> x = scene.positions(bead);
        mesh.push_back(near_mesh(scene.mesh(bead), x, whole_surface));
        const StartSearch search(mesh.back(), x);
        track.emplace_back();
        for (const Vec3& p : x)
            track.back().push_back(solver_start(search, mesh.back(), p).value());
        blank.push_back(mesh.back().x);
        for (Vec3& p : blank.back())
            p += scene.moved;
    }
    Trace row(trace_path);
    long cycle = -1;
    while (row.next()) {
        const long now = static_cast<long>(row["ncycle"]);
        if (now != cycle && cycle >= 0) { // the blank moves as one: x += dt v, as the solver adds it up
            const double dt = row["dt1"];
            const Vec3 v = row.vector("vx1", "vy1", "vz1");
            for (auto& nodes : blank)
                for (Vec3& p : nodes)
                    p += dt * v;
        }
        cycle = now;
        const std::size_t b = row.id("nin") - 1, i = row.id("inod") - 1;
        const NearMesh& m = mesh[b];
        SolverHit hit = solver_step(track[b][i], m, blank[b], row.vector("xi", "yi", "zi"));
        const std::array<uint32_t, 4> theirs{row.id("seg_n1"), row.id("seg_n2"), row.id("seg_n3"),
                                             row.id("seg_n4")};
        bool known = true;
        for (const uint32_t node : theirs)
            known = known && std::binary_search(m.node_id.begin(), m.node_id.end(), node);
        if (!known) { // adaptive meshing has made nodes that the deck does not have
            ++out.refined;
            continue;
        }
        ++out.rows;
        std::array<uint32_t, 4> ours;
        for (std::size_t k = 0; k < 4; ++k)
            ours[k] = m.node_id[m.segment[hit.segment][k]];
        if (ours != theirs) {
            ++out.other_segment;
            continue;
        }
        // Where a window opens late, the way before it is known to rounding only: project on the traced
        // corners.
        const Corners corners{row.vector("x1", "y1", "z1"), row.vector("x2", "y2", "z2"),
                              row.vector("x3", "y3", "z3"), row.vector("x4", "y4", "z4")};
        for (std::size_t k = 0; k < 4; ++k)
            out.drift = std::max(out.drift, distance(corners[k], blank[b][m.segment[hit.segment][k]]));
        hit = solver_project(corners, theirs[2] == theirs[3], row.vector("xi", "yi", "zi"));
        out.same_bits += hit.xi == row["ssc"] && hit.eta == row["ttc"] && hit.d == row["dist"];
        if (hit.inside != (row["xface"] != 0)) ++out.other_segment;
    }
    return out;
}

} // namespace

TEST_CASE("all traced cycles are the solver's") {
    const char* truth = std::getenv("DRAWBEAD_TRUTH");
    if (!truth) {
        WARN("DRAWBEAD_TRUTH is not set: the full traces are not replayed");
        return;
    }
    std::size_t rows = 0, refined = 0;
    for (const auto& entry : std::filesystem::directory_iterator(DRAWBEAD_TESTS_DIR "/contact/data")) {
        const Scene scene = read_scene(entry.path().string());
        const auto trace = std::filesystem::path(truth) / scene.name / "trace.csv.gz";
        if (!std::filesystem::exists(trace)) continue;
        const Replayed out = replay(scene, trace.string());
        CAPTURE(scene.name, out.rows);
        REQUIRE(out.other_segment == 0);
        REQUIRE(out.same_bits == out.rows);
        REQUIRE(out.drift <= (scene.moved == Vec3{} ? 0 : 1e-10));
        rows += out.rows, refined += out.refined;
    }
    WARN(rows << " rows replayed to the last bit; " << refined << " left out on an adaptively refined mesh");
    REQUIRE(rows > 0);
}
