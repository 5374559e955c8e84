#include "report/evaluation.h"
#include "report/json.h"

#include <bit>
#include <cstring>

namespace drawbead {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

std::string base64(const std::string& bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> uint32_t {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
        };
        const uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
        out += letters[group >> 18 & 63];
        out += letters[group >> 12 & 63];
        out += i + 1 < bytes.size() ? letters[group >> 6 & 63] : '=';
        out += i + 2 < bytes.size() ? letters[group & 63] : '=';
    }
    return out;
}

template <class T>
void append(std::string& bytes, const T& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

template <class T>
constexpr std::string_view type_name() {
    if constexpr (std::is_same_v<T, double>) return "Float64";
    if constexpr (std::is_same_v<T, int64_t>) return "Int64";
    return "UInt8";
}

template <class T>
void array(OutputSink& out, std::string_view name, std::size_t components, const std::vector<T>& values) {
    std::string bytes;
    append(bytes, static_cast<uint64_t>(values.size() * sizeof(T)));
    for (const T& value : values)
        append(bytes, value);
    out.write("        <DataArray type=\"");
    out.write(type_name<T>());
    out.write("\" Name=\"");
    out.write(name);
    out.write("\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">");
    out.write(base64(bytes));
    out.write("</DataArray>\n");
}

} // namespace

void write_vtu(OutputSink& out, std::span<const SampledBead> beads) {
    std::vector<double> points, force, normal, restraint, distance, penetration;
    std::vector<int64_t> node, interface_id, connectivity, offsets;
    std::vector<uint8_t> types;
    constexpr uint8_t vertex = 1, line = 3;
    for (const SampledBead& bead : beads) {
        const auto first = static_cast<int64_t>(node.size());
        for (const SampledNode& one : bead.nodes) {
            node.push_back(one.id);
            interface_id.push_back(bead.interface_id);
            distance.push_back(one.distance);
            penetration.push_back(one.penetration);
            for (std::size_t k = 0; k < 3; ++k) {
                points.push_back(one.x[k]);
                normal.push_back(one.normal[k]);
                restraint.push_back(one.restraint[k]);
                force.push_back(one.normal[k] + one.restraint[k]);
            }
        }
        const auto last = static_cast<int64_t>(node.size());
        for (int64_t i = first; i + 1 < last; ++i) {
            connectivity.insert(connectivity.end(), {i, i + 1});
            offsets.push_back(static_cast<int64_t>(connectivity.size()));
            types.push_back(line);
        }
        if (last == first + 1) {
            connectivity.push_back(first);
            offsets.push_back(static_cast<int64_t>(connectivity.size()));
            types.push_back(vertex);
        }
    }
    out.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
              "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n");
    out.write("    <Piece NumberOfPoints=\"" + std::to_string(node.size()) + "\" NumberOfCells=\"" +
              std::to_string(types.size()) + "\">\n");
    out.write("      <PointData Vectors=\"force\">\n");
    array(out, "force", 3, force);
    array(out, "normal_force", 3, normal);
    array(out, "restraint", 3, restraint);
    array(out, "distance", 1, distance);
    array(out, "penetration", 1, penetration);
    array(out, "node", 1, node);
    array(out, "interface", 1, interface_id);
    out.write("      </PointData>\n      <Points>\n");
    array(out, "Points", 3, points);
    out.write("      </Points>\n      <Cells>\n");
    array(out, "connectivity", 1, connectivity);
    array(out, "offsets", 1, offsets);
    array(out, "types", 1, types);
    out.write("      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
}

void write_pvd(OutputSink& out, std::span<const VtuStep> steps) {
    out.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" "
              "byte_order=\"LittleEndian\">\n  <Collection>\n");
    for (const VtuStep& step : steps) {
        std::string file;
        for (const char c : step.file)
            file += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
        out.write("    <DataSet timestep=\"" + json_number(step.time) + "\" part=\"0\" file=\"" + file +
                  "\"/>\n");
    }
    out.write("  </Collection>\n</VTKFile>\n");
}

} // namespace drawbead
