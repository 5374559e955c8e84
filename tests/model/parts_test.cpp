#include "models.h"

using namespace drawbead;

TEST_CASE("elastic constants of every law that has them") {
    struct Law {
        std::string name, canonical;
    };
    const Law isotropic[] = {
        {"LAW1", "LAW1"},       {"LAW01", "LAW1"},       {"ELAST", "LAW1"},
        {"LAW2", "LAW2"},       {"PLAS_JOHNS", "LAW2"},  {"JOHNS", "LAW2"},
        {"ZERIL", "LAW2"},      {"PLAS_ZERIL", "LAW2"},  {"LAW13", "LAW13"},
        {"RIGID", "LAW13"},     {"DAMA", "LAW22"},       {"PLAS_DAM", "LAW23"},
        {"PLAS_BRIT", "LAW27"}, {"HILL", "LAW32"},       {"LAW36", "LAW36"},
        {"PLAS_TAB", "LAW36"},  {"HILL_TAB", "LAW43"},   {"COWPER", "LAW44"},
        {"ZHAO", "LAW48"},      {"GURSON", "LAW52"},     {"BARLAT3", "LAW57"},
        {"BARLAT", "LAW57"},    {"PLAS_T3", "LAW60"},    {"HANSEL", "LAW63"},
        {"UGINE_ALZ", "LAW64"}, {"LAW66", "LAW66"},      {"HILL_MMC", "LAW72"},
        {"LAW73", "LAW73"},     {"SAMP", "LAW76"},       {"YUMODEL", "LAW78"},
        {"LAW80", "LAW80"},     {"LAW84", "LAW84"},      {"BARLAT2000", "LAW87"},
        {"LAW87", "LAW87"},     {"LAW109", "LAW109"},    {"JOHNS_VOCE_DRUCKER", "LAW104"},
        {"VEGTER", "LAW110"},   {"PLAS_RATE", "LAW121"},
    };
    std::string text = begin_of(2022);
    int id = 0;
    for (const Law& law : isotropic)
        text += "/MAT/" + law.name + "/" + std::to_string(++id) + "\nm\n" + reals({"7.8-9"}) +
                reals({"200000.", ".25"});
    const Built built = build(text + "/END\n");
    REQUIRE(built.model.materials().size() == std::size(isotropic));
    for (std::size_t i = 0; i < std::size(isotropic); ++i) {
        const Material& material = built.model.materials()[i];
        INFO(isotropic[i].name);
        CHECK(material.law == isotropic[i].canonical);
        CHECK(material.stiffness == Material::Stiffness::known);
        CHECK(material.density == 7.8e-9);
        CHECK(material.young == 200000);
        CHECK(material.bulk == Approx(200000 / 1.5));
    }
}

TEST_CASE("laws whose moduli stand elsewhere, or nowhere") {
    const Built built = build(
        begin_of(2022) + "/MAT/ELAST/1\nincompressible\n" + reals({"1e-9"}) + reals({"3000.", ".5"}) +
        "/MAT/LAW93/2\nhill\n" + reals({"1e-9"}) + reals({"100.", "200.", "150.", "50.", "0."}) +
        reals({"50.", "50.", "0.", "0."}) + "/MAT/COMPSH/3\ncomposite\n" + reals({"1e-9"}) +
        reals({"100.", "400.", ".1"}) + "/MAT/VOID/4\nvoid\n" + reals({"1e-9", "210000.", ".3"}) +
        "/MAT/LAW0/5\nnothing\n" + "/MAT/PLAS_PREDEF/6\nname\nSTEEL\n" + "/MAT/GAS/7\ngas\n" + reals({"1."}) +
        "/MAT/FOAM_PLAS/8\nfoam\n" + reals({"1e-9"}) + "/MAT/LAW200/9\nnew\n" + reals({"1e-9"}) +
        "/MAT/LAW36/10\nsecret\n#!/ENCRYPT\nx8s7df6\n" + "/MAT/PLAS_PREDEF/11\nname\nPPT40\n/END\n");
    const auto& m = built.model.materials();
    CHECK(m[0].bulk == Approx(3000 / (3 * 0.002)));
    CHECK(m[1].young == 200);
    CHECK(m[1].bulk == Approx(200));
    CHECK(m[2].young == Approx(400 / (1 - .1 * .4)));
    CHECK(m[2].bulk == m[2].young);
    CHECK(m[3].is_void);
    CHECK(m[3].stiffness == Material::Stiffness::known);
    CHECK(m[3].young == 210000);
    CHECK(m[3].bulk == Approx(175000));
    CHECK(m[4].is_void);
    CHECK(m[4].stiffness == Material::Stiffness::none);
    CHECK(m[5].young == Approx(210000));
    CHECK(m[6].stiffness == Material::Stiffness::none);
    CHECK(m[7].stiffness == Material::Stiffness::none);
    CHECK(m[8].stiffness == Material::Stiffness::unknown);
    CHECK(m[8].law == "LAW200");
    CHECK(m[9].stiffness == Material::Stiffness::encrypted);
    CHECK(m[10].stiffness == Material::Stiffness::unknown);
}

TEST_CASE("LAW93: bulk modulus is the largest entry of the stiffness") {
    // Isotropic constants: C11 = E (1 − ν) / ((1 + ν)(1 − 2ν))
    const Built built = build(begin_of(2022) + "/MAT/ORTH_HILL/1\nhill\n" + reals({"1e-9"}) +
                              reals({"210000.", "210000.", "210000.", "80769.", ".3"}) +
                              reals({"80769.", "80769.", ".3", ".3"}) + "/END\n");
    CHECK(built.model.materials()[0].bulk == Approx(210000 * .7 / (1.3 * .4)));
}

TEST_CASE("old layouts: void without Poisson ratio, cells of 16 columns") {
    const Built old =
        build(begin_of(130) + "/MAT/VOID/1\nvoid\n" + reals({"1e-9", "3000.", ".3"}) + "/END\n");
    CHECK(old.model.materials()[0].bulk == Approx(1000));
    const Built oldest =
        build(begin_of(44) + "/MAT/ELAST/1\nsteel\n" + cells({"7.8e-9"}, 16) + cells({"210000.", ".3"}, 16) +
              "/PROP/SHELL/1\nsheet\n\n\n" + cells({"5", "0"}, 8).substr(0, 16) + cells({"1.5"}, 16) +
              "/PART/3\nblank\n" + cells({"1", "1"}, 8) + "/END\n");
    CHECK(oldest.model.materials()[0].young == 210000);
    CHECK(oldest.model.properties()[0].thickness == 1.5);
    CHECK(oldest.model.parts()[0].material == 1);
}

TEST_CASE("thickness of every kind of property") {
    const std::string third = "p\n\n\n" + std::string(20, ' ') + reals({"1.25"});
    const std::string stack =
        "p\n\n\n" + std::string(20, ' ') + reals({""}) + "\n" + ids({71}) + "\n" + ids({72}) + "\n";
    const Built built =
        build(begin_of(2022) + "/PROP/TYPE1/1\n" + third + "/PROP/SH_ORTH/2\n" + third + "/PROP/TYPE10/3\n" +
              third + "/PROP/SH_SANDW/4\n" + third + "/PROP/SH_FABR/5\n" + third + "/PROP/STACK/6\n" + third +
              "/PROP/VOID/7\nv\n" + reals({"0.7"}) + "/PROP/VOID/8\nv\n" + "/PROP/TYPE51/9\n" + stack +
              "/PROP/TYPE17/10\n" + stack + "/PLY/71\nply\n" + cells({"1"}, 10).substr(0, 10) +
              reals({"0.25"}) + "/PROP/PLY/72\nply\n" + cells({"1"}, 10).substr(0, 10) + reals({"0.5"}) +
              "/PROP/SOLID/11\ns\n/PROP/PCOMPP/12\np\n\n" + "/PROP/NEW/13\np\n/PROP/SHELL/14\nshort\n/END\n");
    const auto& p = built.model.properties();
    struct Expected {
        int type;
        bool has;
        double thickness;
    };
    const Expected expected[] = {{1, true, 1.25},  {9, true, 1.25},  {10, true, 1.25}, {11, true, 1.25},
                                 {16, true, 1.25}, {17, true, 1.25}, {0, true, 0.7},   {0, false, 0},
                                 {51, true, 0.75}, {17, true, 0.75}, {19, false, 0},   {14, false, 0},
                                 {52, false, 0},   {-1, false, 0},   {1, false, 0}};
    REQUIRE(p.size() == std::size(expected));
    for (std::size_t i = 0; i < p.size(); ++i) {
        INFO(i);
        CHECK(p[i].type == expected[i].type);
        CHECK(p[i].has_thickness == expected[i].has);
        CHECK(p[i].thickness == expected[i].thickness);
    }
}

TEST_CASE("a blank's part without property or material is reported, other parts are not") {
    const Built built =
        build(begin_of(2022) + "/PART/1\nblank\n" + ids({5, 6}) + "/PART/2\ntool\n" + ids({7, 8}) +
              "/NODE\n" + node(1, "0.", "0.", "0.") + node(2, "1.", "0.", "0.") + node(3, "1.", "1.", "0.") +
              "/SH3N/1\n" + ids({1, 1, 2, 3}) + "/SH3N/2\n" + ids({2, 1, 2, 3}) + part_surface +
              "/GRNOD/NODENS/2\nb\n" + ids({1, 2}) + drawbead_block + "/END\n");
    CHECK(built.issues(ReadIssue::Kind::property_missing) == 1);
    CHECK(built.issues(ReadIssue::Kind::material_missing) == 1);
    CHECK(built.model.issues()[0].subject == "part 1");
    CHECK(built.model.issues()[0].detail == "5");
}
