#include "model/part_reader.h"

#include "model/cards/part.h"
#include "model/cards/property.h"
#include "model/option_reader.h"

#include <charconv>

namespace drawbead {

bool is_encrypted(const Deck& deck, const Block& block) {
    return deck.text(block.text).find("#!/ENCRYPT") != std::string_view::npos;
}

std::vector<Part> read_parts(const Deck& deck, const OptionIndex& index, IssueLog& issues) {
    std::vector<Part> parts;
    for (const Option& option : index.all(Family::part)) {
        OptionReader reader(deck, option.block, issues);
        const Card card = reader.card(part_card);
        const Offsets& offsets = reader.scope().offsets;
        Part part;
        part.id = option.id;
        part.block = option.block;
        part.title = reader.title();
        part.property = reader.reference(card, "prop_ID", offsets.property);
        part.material = reader.reference(card, "mat_ID", offsets.material);
        part.subset = reader.reference(card, "subset_ID", offsets.general);
        parts.push_back(std::move(part));
    }
    return parts;
}

namespace {

/// Type number of a name after /PROP/, −1 when it is not known.
int property_type(std::string_view name) {
    name = name.substr(0, name.find('/'));
    if (name.substr(0, 4) == "TYPE") {
        int type = -1;
        const auto end = name.data() + name.size();
        const auto read = std::from_chars(name.data() + 4, end, type);
        return read.ec == std::errc{} && read.ptr == end ? type : -1;
    }
    for (const PropertyName& known : property_names)
        if (known.name == name) return known.type;
    return -1;
}

/// Thickness of a /PLY (or /PROP/PLY); false when there is none.
bool ply_thickness(const Deck& deck, const OptionIndex& index, int64_t id, IssueLog& issues,
                   double& thickness) {
    const auto block = index.find(Family::ply, id);
    if (!block || is_encrypted(deck, deck.blocks()[*block])) return false;
    OptionReader reader(deck, *block, issues);
    const Card card = reader.card(ply_card);
    thickness = reader.real(card, "Thick");
    return card["Thick"].given();
}

/// Sum over the plies that a stack lists after its fourth card: every second line names one. Empty when a ply
/// is not found or the stack is made of sub-laminates.
bool stack_thickness(const Deck& deck, const OptionIndex& index, OptionReader& reader, IssueLog& issues,
                     double& thickness) {
    thickness = 0;
    bool any = false;
    Span line;
    while (reader.line(line)) {
        const std::string_view text = trim(deck.text(line));
        if (text.empty()) break;
        if (text.substr(0, 3) == "SUB" || text.substr(0, 3) == "INT") return false;
        const Card card = read_card(deck, reader.block().scope, line, stack_ply_card);
        double ply = 0;
        const int64_t id = reader.reference(card, "ply_ID", offset_of(reader.scope(), Family::ply));
        if (!ply_thickness(deck, index, id, issues, ply)) return false;
        thickness += ply;
        any = true;
        reader.skip_card();
    }
    return any;
}

} // namespace

std::vector<Property> read_properties(const Deck& deck, const OptionIndex& index, IssueLog& issues) {
    std::vector<Property> properties;
    for (const Option& option : index.all(Family::property)) {
        const Block& block = deck.blocks()[option.block];
        Property property;
        property.id = option.id;
        property.block = option.block;
        property.type = property_type(subtype(block.keyword));
        const ThicknessCard where =
            property.type < 0 ? ThicknessCard::none : thickness_card_of_type(property.type);
        if (where != ThicknessCard::none && where != ThicknessCard::other && !is_encrypted(deck, block)) {
            OptionReader reader(deck, option.block, issues);
            if (where == ThicknessCard::first) {
                const Card card = reader.card(void_thickness_card);
                property.has_thickness = card.present;
                property.thickness = reader.real(card, "Thick");
            } else {
                reader.skip_card();
                reader.skip_card();
                const Card card = where == ThicknessCard::plies ? Card{} : reader.card(shell_thickness_card);
                property.has_thickness = card.present;
                property.thickness = reader.real(card, "Thick");
                if (where == ThicknessCard::plies) reader.skip_card();
                if (where != ThicknessCard::third && property.thickness == 0) {
                    reader.skip_card();
                    property.has_thickness = stack_thickness(deck, index, reader, issues, property.thickness);
                    if (!property.has_thickness) property.thickness = 0;
                }
            }
        }
        properties.push_back(property);
    }
    return properties;
}

} // namespace drawbead
