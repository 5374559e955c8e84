#include "study/hard_scene.h"

#include "contact/bead_contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace drawbead {

SheetSpec::SheetSpec() {
    straight(52.25, 0.25);
}

void SheetSpec::straight(double x, double height, double y, double spacing, std::size_t nodes) {
    bead.clear();
    for (std::size_t i = 0; i < nodes; ++i)
        bead.push_back({x, y + spacing * static_cast<double>(i), height});
}

namespace {

/// An order that depends on the seed alone.
std::vector<uint32_t> order_of(std::size_t count, unsigned seed) {
    std::vector<uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    if (seed == 0) return order;
    std::mt19937 random(seed);
    for (std::size_t k = count; k > 1; --k)
        std::swap(order[k - 1], order[random() % k]);
    return order;
}

struct Sheet {
    std::vector<Vec3> x;
    std::vector<uint32_t> id;
    std::vector<SegmentNodes> segment;

    explicit Sheet(const SheetSpec& spec) {
        const uint32_t row = spec.cells + 1;
        const std::vector<uint32_t> ids = order_of(std::size_t{row} * row, spec.shuffle);
        for (uint32_t j = 0; j < row; ++j)
            for (uint32_t i = 0; i < row; ++i) {
                x.push_back(spec.place({spec.size * i, spec.size * j, 0}));
                id.push_back(ids[x.size() - 1] + 1);
            }
        std::vector<SegmentNodes> quads;
        for (uint32_t j = 0; j < spec.cells; ++j)
            for (uint32_t i = 0; i < spec.cells; ++i) {
                const uint32_t n = row * j + i;
                if (spec.triangles) {
                    quads.push_back({n, n + 1, n + row + 1, n + row + 1});
                    quads.push_back({n, n + row + 1, n + row, n + row});
                } else {
                    quads.push_back({n, n + 1, n + row + 1, n + row});
                }
            }
        for (const uint32_t s : order_of(quads.size(), spec.shuffle))
            segment.push_back(spec.flipped ? turned(quads[s]) : quads[s]);
    }
};

} // namespace

SheetOutcome evaluate(const SheetSpec& spec, Law law) {
    const Sheet sheet(spec);
    SegmentMesh mesh;
    mesh.segment = sheet.segment;
    mesh.x = sheet.x;
    mesh.node_id = sheet.id;
    SegmentStiffness stiffness = of_shell(spec.young, spec.thickness);
    if (spec.solid) stiffness.half_thickness = 0;

    EvaluationScene scene;
    EvaluationBead bead;
    bead.id = 1;
    bead.iform = spec.iform;
    bead.law = spec.law;
    bead.t_start = spec.t_start;
    bead.t_stop = spec.t_stop;
    for (const Vec3& x : spec.bead) {
        bead.nodes.push_back(static_cast<int64_t>(bead.x.size()) + 100001);
        bead.x.push_back(spec.place(x));
    }
    const BeadInput input{bead.x, spec.law.fn_first, spec.law.depth, 0};
    ContactOptions options;
    options.layer_ratio = 0;
    options.travel = HUGE_VAL; // the whole surface
    SurfaceContact contact = surface_contact(
        mesh, std::span(&input, 1), [&](uint32_t) { return stiffness; }, stiffness.k,
        std::vector<double>(sheet.segment.size(), stiffness.k), options);
    bead.track = contact.track[0];
    bead.slope = contact.bead[0].slope;
    for (const BeadNodeContact& node : contact.bead[0].node)
        bead.slope_read.push_back(node.slope_read);
    bead.motion.assign(bead.x.size(), 0);
    EvaluationSurface surface;
    surface.mesh = std::move(contact.mesh);
    surface.motion.assign(surface.mesh.x.size(), 1);
    for (const Vec3& x : surface.mesh.x)
        surface.mass.push_back(spec.mass ? spec.mass(x) : spec.node_mass);
    surface.stiffness.assign(surface.mesh.segment.size(), stiffness);
    surface.thickness.assign(surface.mesh.segment.size(), spec.solid ? 0 : spec.thickness);
    scene.motions = {spec.tool, spec.blank};
    scene.surfaces.push_back(std::move(surface));
    scene.beads.push_back(std::move(bead));
    scene.time = spec.time;
    for (std::size_t n = 0; n <= spec.steps && spec.time.empty(); ++n)
        scene.time.push_back(spec.end * static_cast<double>(n) / static_cast<double>(spec.steps));
    for (std::size_t n = 0; n < scene.time.size(); ++n)
        scene.dt.push_back(n > 0 ? scene.time[n] - scene.time[n - 1] : 0);

    std::vector<MotionSteps> steps;
    for (const Motion& motion : scene.motions)
        steps.push_back(integrate(motion, scene.time, scene.dt));
    const EffectSet stages =
        spec.all_stages ? EffectSet::all() : plan(scene, steps, 0, law, PlanOptions{}).needed();
    const std::unique_ptr<BeadRun> run = make_run(scene, steps, 0, law, stages);
    run->keep_samples(scene.time.size());
    run->advance(0, scene.time.size());
    run->finish();
    SheetOutcome out{run->history(), run->counts(), {}};
    if (auto samples = run->take_samples(); !samples.empty()) out.last = std::move(samples.back().nodes);
    return out;
}

Motion::Term speed(std::size_t axis, TimeTable table) {
    return {true, axis, 1, 1, std::move(table)};
}
Motion::Term way(std::size_t axis, TimeTable table) {
    return {false, axis, 1, 1, std::move(table)};
}

} // namespace drawbead
