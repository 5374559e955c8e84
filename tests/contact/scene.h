#pragma once
// A scene that was run through the real solver: mesh, beads and what the solver made of them
// (make_fixtures.py).
#include "contact/bead_contact.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <vector>

namespace drawbead {

struct Scene {
    struct Row {
        int bead = 0, place = 0;
        uint32_t node = 0;
        std::array<uint32_t, 4> segment{}; ///< user node ids
        bool inside = false;
        double xi = 0, eta = 0;
        std::array<double, 4> h{};
        double d = 0, g = 0, pen = 0, depth = 0, k = 0, slope_read = 0, slope = 0, l2 = 0, l = 0, fn = 0,
               ft = 0, s = 0, s_total = 0;
        Vec3 x;
    };
    struct Surface {
        std::vector<SegmentNodes> segment;
        std::vector<SegmentStiffness> stiffness;
        std::vector<double> k;
    };
    struct Bead {
        std::size_t surface = 0;
        bool ordered = true;
        int iform = 2;
        double fn = 0, ft = 0, fn_last = 0, ft_last = 0, depth = 0;
        std::vector<uint32_t> node;   ///< rows
        std::vector<uint32_t> warned; ///< user ids of warning 346
    };

    std::string name;
    std::vector<uint32_t> id;
    std::vector<Vec3> x;
    std::vector<Surface> surface;
    std::vector<Bead> bead;
    bool admesh_idt = false;
    std::set<int> messages;
    Vec3 moved; ///< of the blank, in the first traced cycle
    std::vector<Row> row;

    SegmentMesh mesh(const Bead& b) const { return {surface[b.surface].segment, x, id, {}, {}}; }
    std::vector<Vec3> positions(const Bead& b) const {
        std::vector<Vec3> at;
        for (const uint32_t node : b.node)
            at.push_back(x[node]);
        return at;
    }
};

inline Scene read_scene(const std::string& path) {
    std::ifstream in(path);
    Scene scene;
    std::string word;
    std::size_t count = 0;
    in >> word >> scene.name >> word >> count;
    scene.id.resize(count);
    scene.x.resize(count);
    for (std::size_t k = 0; k < count; ++k)
        in >> scene.id[k] >> scene.x[k].x >> scene.x[k].y >> scene.x[k].z;
    in >> word >> count;
    scene.surface.resize(count);
    for (auto& surface : scene.surface) {
        in >> word >> count;
        surface.segment.resize(count);
        for (auto& n : surface.segment) {
            double young = 0, thickness = 0, bulk = 0;
            in >> n[0] >> n[1] >> n[2] >> n[3] >> young >> thickness >> bulk;
            SegmentStiffness s;
            if (bulk > 0) {
                std::array<Vec3, 8> solid;
                Vec3 middle;
                for (Vec3& p : solid) {
                    uint32_t node = 0;
                    in >> node;
                    p = scene.x[node];
                    middle += 0.125 * p;
                }
                Corners face{scene.x[n[0]], scene.x[n[1]], scene.x[n[2]], scene.x[n[3]]};
                if (!faces_away(face, middle)) n = turned(n);
                s = of_solid_face(area(face), bulk, one_point_volume(solid));
                if (thickness > 0) s = coated(s, of_shell(young, thickness));
            } else if (thickness > 0) {
                s = of_shell(young, thickness);
            }
            surface.stiffness.push_back(s);
            surface.k.push_back(s.k);
        }
    }
    int admesh = 0;
    in >> word >> count >> admesh;
    scene.admesh_idt = admesh == 1;
    scene.bead.resize(count);
    for (auto& b : scene.bead) {
        in >> b.surface >> b.ordered >> b.iform >> b.fn >> b.ft >> b.fn_last >> b.ft_last >> b.depth >> count;
        b.node.resize(count);
        for (auto& node : b.node)
            in >> node;
        in >> count;
        b.warned.resize(count);
        for (auto& node : b.warned)
            in >> node;
    }
    in >> word >> count;
    for (std::size_t k = 0; k < count; ++k) {
        int code = 0;
        in >> code;
        scene.messages.insert(code);
    }
    in >> word >> scene.moved.x >> scene.moved.y >> scene.moved.z >> word >> count;
    scene.row.resize(count);
    for (auto& r : scene.row) {
        in >> r.bead >> r.place >> r.node;
        for (auto& node : r.segment)
            in >> node;
        in >> r.inside >> r.xi >> r.eta;
        for (auto& h : r.h)
            in >> h;
        in >> r.d >> r.g >> r.pen >> r.depth >> r.k >> r.slope_read >> r.slope >> r.l2 >> r.l >> r.fn >>
            r.ft >> r.s >> r.s_total >> r.x.x >> r.x.y >> r.x.z;
    }
    return scene;
}

} // namespace drawbead
