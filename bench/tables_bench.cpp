// Kernels of node and element tables, and ids to rows.
#include "model/id_map.h"
#include "model/line_kernels.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cstdio>
#include <numeric>
#include <random>
#include <string>
#include <vector>

using namespace drawbead;

namespace {

constexpr uint32_t line_count = 50000;

/// Node lines whose coordinates are printed by `format` (three reals of 20 columns).
std::string node_text(const char* format) {
    std::string text = "#RADIOSS STARTER\n/NODE\n";
    char line[128];
    for (uint32_t i = 0; i < line_count; ++i) {
        const double x = 0.731 * (i % 300), y = 0.733 * (i / 300) - 300,
                     z = 1e-4 * (i * 2654435761u >> 12) - 50;
        std::snprintf(line, sizeof line, format, i + 1, x, y, z);
        text += line;
    }
    return text;
}

void read_nodes(benchmark::State& state, const char* format) {
    const std::string text = node_text(format);
    const auto kernel = static_cast<Kernel>(state.range(0));
    if (!runs_here(kernel)) {
        state.SkipWithError("not on this processor");
        return;
    }
    std::vector<uint32_t> id(line_count);
    std::vector<Vec3> x(line_count);
    for (auto _ : state) {
        LineRange range{text.data() + text.find("/NODE\n") + 6, text.data() + text.size(), text};
        NodeRows rows{id.data(), x.data(), line_count, 0, 0, 1};
        read_node_lines(kernel, {}, range, rows);
        if (rows.count != line_count) state.SkipWithError("a line was not taken");
        benchmark::DoNotOptimize(x.data());
    }
    state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * text.size()));
}
BENCHMARK_CAPTURE(read_nodes, fixed, "%10u%20.6f%20.6f%20.6f\n")->Arg(0)->Arg(1)->ArgName("avx2");
BENCHMARK_CAPTURE(read_nodes, exponents, "%10u%20.12E%20.12E%20.12E\n")->Arg(0)->Arg(1)->ArgName("avx2");
BENCHMARK_CAPTURE(read_nodes, digits17, "%10u%20.14f%20.14f%20.14f\n")->Arg(0)->Arg(1)->ArgName("avx2");

void read_shells(benchmark::State& state, const char* rest) {
    std::string text = "/SHELL/1\n";
    char line[128];
    for (uint32_t i = 1; i <= line_count; ++i) {
        std::snprintf(line, sizeof line, "%10u%10u%10u%10u%10u%s\n", i, i, i + 1, i + 302, i + 301, rest);
        text += line;
    }
    const auto kernel = static_cast<Kernel>(state.range(0));
    if (!runs_here(kernel)) {
        state.SkipWithError("not on this processor");
        return;
    }
    std::vector<uint32_t> values(5 * line_count);
    std::vector<std::string_view> more(line_count);
    for (auto _ : state) {
        LineRange range{text.data() + 9, text.data() + text.size(), text};
        IdRows rows{values.data(), more.data(), 5, line_count, 0};
        read_id_lines(kernel, {}, range, rows);
        if (rows.count != line_count) state.SkipWithError("a line was not taken");
        benchmark::DoNotOptimize(values.data());
    }
    state.SetBytesProcessed(static_cast<int64_t>(state.iterations() * text.size()));
}
BENCHMARK_CAPTURE(read_shells, plain, "")->Arg(0)->Arg(1)->ArgName("avx2");
BENCHMARK_CAPTURE(read_shells, thickness, "                                           0.8")
    ->Arg(0)
    ->Arg(1)
    ->ArgName("avx2");

enum class Order { natural, shuffled, by_part, scattered };

std::vector<uint32_t> make_ids(Order order, uint32_t count) {
    std::vector<uint32_t> ids(count);
    std::iota(ids.begin(), ids.end(), 1u);
    std::mt19937 random(1);
    if (order == Order::shuffled) std::shuffle(ids.begin(), ids.end(), random);
    if (order == Order::by_part)
        for (uint32_t& id : ids)
            id = id / 10000 * 1000000 + id % 10000 + 1;
    if (order == Order::scattered)
        for (uint32_t& id : ids)
            id = static_cast<uint32_t>(random() % 2147483647u + 1);
    return ids;
}

void make_map(benchmark::State& state, Order order) {
    const auto ids = make_ids(order, 2000000);
    for (auto _ : state)
        benchmark::DoNotOptimize(IdMap(ids, static_cast<unsigned>(state.range(0))));
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * ids.size()));
}
void look_up(benchmark::State& state, Order order) {
    const auto ids = make_ids(order, 2000000);
    const IdMap map(ids, 1);
    for (auto _ : state) {
        uint32_t sum = 0;
        for (const uint32_t id : ids)
            sum += map.row(id);
        benchmark::DoNotOptimize(sum);
    }
    state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * ids.size()));
}
#define DRAWBEAD_ID_BENCH(order)                                                                             \
    BENCHMARK_CAPTURE(make_map, order, Order::order)                                                         \
        ->Arg(1)                                                                                             \
        ->Arg(2)                                                                                             \
        ->ArgName("threads")                                                                                 \
        ->UseRealTime()                                                                                      \
        ->Unit(benchmark::kMillisecond);                                                                     \
    BENCHMARK_CAPTURE(look_up, order, Order::order)->Unit(benchmark::kMillisecond)
DRAWBEAD_ID_BENCH(natural);
DRAWBEAD_ID_BENCH(shuffled);
DRAWBEAD_ID_BENCH(by_part);
DRAWBEAD_ID_BENCH(scattered);

} // namespace
