// The reader of scenes on any bytes: no crash, no hang; what it takes can be evaluated, what it refuses has a
// place.
#include "cli/scene_file.h"

#include <cmath>
#include <cstdlib>

using namespace drawbead;

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void look_at(const TimeTable& table) {
    require(!table.times().empty() && table.times().size() == table.values().size());
    for (std::size_t i = 0; i < table.times().size(); ++i) {
        require(std::isfinite(table.times()[i]) && std::isfinite(table.values()[i]));
        require(i == 0 || table.times()[i - 1] < table.times()[i]);
    }
    table.value(0.5);
    table.corners(0, 1);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Result<Scene> scene = parse_scene(text, "folder/scene.yaml");
    if (!scene) {
        require(!scene.error().message.empty() && scene.error().path == "folder/scene.yaml");
        return 0;
    }
    require(!scene->deck.empty() && (scene->solver || scene->manual));
    require(!scene->time.trace.empty() || scene->time.end);
    require(scene->output.every > 0);
    require(!scene->deck_motion || scene->moves.empty());
    for (const SceneMove& move : scene->moves)
        require(move.motion < scene->motions.size() && move.place.line > 0);
    for (const Motion& motion : scene->motions) {
        for (const Motion::Term& term : motion.terms)
            look_at(term.table);
        if (motion.turn) look_at(motion.turn->angle);
        motion.placement(0.25);
    }
    for (const Scene::Table& table : scene->tables)
        require(table.first < table.last && table.place.line > 0);
    const Result<void> covered = check_tables(*scene, 1);
    require(covered || (!covered.error().message.empty() && covered.error().line > 0));
    return 0;
}
