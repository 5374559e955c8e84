# Flags that every target of the project shares. Results must not change with the build: no contraction, no fast-math.
find_package(Threads REQUIRED)
add_library(drawbead_flags INTERFACE)
target_compile_features(drawbead_flags INTERFACE cxx_std_20)
target_compile_options(drawbead_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror -ffp-contract=off
    # g++ 12 reports both inside its own std::string.
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict>")
target_link_libraries(drawbead_flags INTERFACE Threads::Threads)
if(DRAWBEAD_SANITIZE)
    target_compile_options(drawbead_flags INTERFACE
        -O1 # the kernels of the force laws take minutes at -O2 under sanitizers
        -fsanitize=${DRAWBEAD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g)
    target_link_options(drawbead_flags INTERFACE -fsanitize=${DRAWBEAD_SANITIZE})
endif()
if(DRAWBEAD_FUZZ)
    target_compile_options(drawbead_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# drawbead_room(NAME SOURCES … USES rooms… LIBRARIES targets…): one static library per room. A room sees only the
# headers of the rooms it uses: each room exports its own folder under the name <room>/ and nothing else.
function(drawbead_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;USES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
    set(target drawbead_${name})
    add_library(${target} STATIC ${ROOM_SOURCES})
    set(view ${PROJECT_BINARY_DIR}/rooms/${name})
    file(MAKE_DIRECTORY ${view})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/src/${name} ${view}/${name} SYMBOLIC)
    target_include_directories(${target} PUBLIC ${view})
    target_link_libraries(${target} PUBLIC drawbead_flags ${ROOM_LIBRARIES} PRIVATE ${ROOM_PRIVATE_LIBRARIES})
    foreach(used IN LISTS ROOM_USES)
        target_link_libraries(${target} PUBLIC drawbead_${used})
    endforeach()
endfunction()
