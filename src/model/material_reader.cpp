#include "model/cards/material.h"
#include "model/option_reader.h"
#include "model/part_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace drawbead {

namespace {

/// Name, number and cards of a law; number −1 and no cards when it is not known.
struct Law {
    std::string name;
    int number = -1;
    bool known = false;
    ElasticCards cards = ElasticCards::none;
};

Law law_of(std::string_view name) {
    name = name.substr(0, name.find('/'));
    Law law;
    law.name = name;
    int number = -1;
    if (name.substr(0, 3) == "LAW") {
        const auto end = name.data() + name.size();
        const auto read = std::from_chars(name.data() + 3, end, number);
        if (read.ec != std::errc{} || read.ptr != end) return law;
    }
    for (const LawName& known : law_names) {
        if (known.name != name && (number < 0 || known.law != number)) continue;
        law.known = true;
        law.number = known.law;
        law.cards = known.cards;
        break;
    }
    if (!law.known && std::find(std::begin(unnamed_isotropic_laws), std::end(unnamed_isotropic_laws),
                                number) != std::end(unnamed_isotropic_laws)) {
        law.known = true;
        law.number = number;
        law.cards = ElasticCards::isotropic;
    }
    if (law.known && law.number >= 0) law.name = "LAW" + std::to_string(law.number);
    return law;
}

double bulk_modulus(double young, double poisson) {
    return young / (3 * (1 - 2 * poisson));
}

/// LAW93: the solver takes the largest Young's modulus, and the largest entry of the 3D stiffness as bulk
/// modulus.
void take_hill(OptionReader& reader, Material& material) {
    const Card first = reader.card(hill_card);
    const Card second = reader.card(hill_shear_card);
    const double e1 = reader.real(first, "E11"), e2 = reader.real(first, "E22"),
                 e3 = reader.real(first, "E33");
    const double n12 = reader.real(first, "nu12");
    const double n13 = reader.real(second, "nu13"), n23 = reader.real(second, "nu23");
    material.young = std::max({e1, e2, e3});
    if (e1 <= 0 || e2 <= 0 || e3 <= 0) return;
    const double n21 = n12 * e2 / e1, n31 = n13 * e3 / e1, n32 = n23 * e3 / e2;
    const double determinant = 1 - n12 * n21 - n23 * n32 - n31 * n13 - 2 * n21 * n32 * n13;
    if (!(determinant > 0)) return;
    const double c11 = e1 * (1 - n23 * n32) / determinant, c22 = e2 * (1 - n13 * n31) / determinant,
                 c33 = e3 * (1 - n12 * n21) / determinant;
    const double c12 = e1 * (n21 + n31 * n23) / determinant, c13 = e1 * (n31 + n21 * n32) / determinant,
                 c23 = e2 * (n32 + n12 * n31) / determinant;
    material.bulk = std::max({c11, c22, c33, c12, c13, c23});
}

/// LAW15, 19, 25: the plane-stress modulus of the stiffer direction serves as both.
void take_composite(OptionReader& reader, Material& material) {
    const Card card = reader.card(composite_card);
    const double e1 = reader.real(card, "E11"), e2 = reader.real(card, "E22"),
                 n12 = reader.real(card, "nu12");
    const double n21 = e1 > 0 ? n12 * e2 / e1 : 0;
    material.young = std::max(e1, e2) / (1 - n12 * n21);
    material.bulk = material.young;
}

Material read_material(const Deck& deck, const Option& option, IssueLog& issues) {
    const Block& block = deck.blocks()[option.block];
    const Law law = law_of(subtype(block.keyword));
    Material material;
    material.id = option.id;
    material.block = option.block;
    material.law = law.name;
    material.is_void = law.cards == ElasticCards::voided;
    if (is_encrypted(deck, block)) {
        material.stiffness = Material::Stiffness::encrypted;
        return material;
    }
    if (!law.known) return material;
    material.stiffness = Material::Stiffness::known;
    OptionReader reader(deck, option.block, issues);
    if (law.cards == ElasticCards::predefined) {
        Span line;
        std::string_view name;
        if (reader.line(line)) name = trim(deck.text(line));
        name = name.substr(0, name.find_first_of(" \t"));
        material.stiffness = Material::Stiffness::unknown;
        for (const PredefinedMaterial& known : predefined_materials)
            if (known.name == name) {
                material.stiffness = Material::Stiffness::known;
                material.young =
                    known.young * conversion_factor(UnitSystem{}, deck.work_units(), pressure_dimension);
                material.bulk = bulk_modulus(material.young, known.poisson);
            }
        return material;
    }
    if (law.cards == ElasticCards::voided) {
        const Card card = reader.card(void_card);
        material.density = reader.real(card, "Rho");
        material.young = reader.real(card, "E");
        material.bulk = bulk_modulus(material.young, reader.real(card, "nu"));
        if (material.young == 0) material.stiffness = Material::Stiffness::none;
        return material;
    }
    const Card first = reader.card(density_card);
    material.density = reader.real(first, "Rho");
    switch (law.cards) {
    case ElasticCards::isotropic: {
        const Card card = reader.card(isotropic_card);
        double poisson = reader.real(card, "nu");
        if (law.number == 1 && poisson == 0.5) poisson = 0.499;
        material.young = reader.real(card, "E");
        material.bulk = bulk_modulus(material.young, poisson);
        break;
    }
    case ElasticCards::hill:
        take_hill(reader, material);
        break;
    case ElasticCards::composite:
        take_composite(reader, material);
        break;
    default:
        material.stiffness = Material::Stiffness::none;
    }
    return material;
}

} // namespace

std::vector<Material> read_materials(const Deck& deck, const OptionIndex& index, IssueLog& issues) {
    std::vector<Material> materials;
    for (const Option& option : index.all(Family::material))
        materials.push_back(read_material(deck, option, issues));
    return materials;
}

} // namespace drawbead
