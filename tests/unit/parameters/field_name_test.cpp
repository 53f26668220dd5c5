#include "stridor/parameters/fields/field_name.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::parameters {
namespace {

using support::Thrown;
using support::thrown_by;

Thrown refusal(std::string_view name) {
    const Thrown thrown = thrown_by([&] { field_named(name); });
    EXPECT_EQ(thrown.kind, ErrorKind::input) << name;
    return thrown;
}

TEST(FieldName, IsKeyLastPartOrSymbol) {
    for (const char* name : {"contact.kinetic_friction", "kinetic_friction", "mu_d"})
        EXPECT_EQ(key_of(field_named(name)), "contact.kinetic_friction");
    EXPECT_EQ(key_of(field_named("F")), "contact.preload");
    EXPECT_EQ(key_of(field_named("title")), "title");
    EXPECT_EQ(key_of(field_named("temperature")), "temperature.value");
    EXPECT_TRUE(fields_called("value").empty());
}

TEST(FieldName, OfEveryFieldIsItsKey) {
    for (const Field& field : fields()) {
        EXPECT_EQ(&field_named(key_of(field)), &field);
        const std::string_view symbol = field.symbol.empty() ? field.name : field.symbol;
        EXPECT_TRUE(field.name == "mass" || is_of_builder(field) || &field_named(symbol) == &field) << symbol;
    }
}

TEST(FieldName, OfSeveralFieldsNamesThem) {
    EXPECT_TRUE(refusal("mass").says("Write joint.mass or plate.mass."));
}

TEST(FieldName, IsABuildersOnlyWhereNothingElseIsCalledSo) {
    EXPECT_EQ(key_of(field_named("position")), "structure.position");
    EXPECT_EQ(key_of(field_named("stiffness")), "plate.stiffness");
    EXPECT_EQ(key_of(field_named("structure.stiffness")), "structure.stiffness");
}

TEST(FieldName, ThatIsUnknownSuggestsTheKeyThatWasMeant) {
    EXPECT_TRUE(refusal("contact.prelaod").says("Did you mean contact.preload?"));
    EXPECT_TRUE(refusal("prelaod").says("Did you mean contact.preload?"));
    EXPECT_TRUE(refusal("joint.preload").says("Did you mean contact.preload?"));
    EXPECT_TRUE(refusal("contact.mu_d").says("Did you mean contact.kinetic_friction?"));
    EXPECT_TRUE(refusal("joint.stiffness").says("Did you mean joint.axial_stiffness or joint.flexural_stiffness?"));
    EXPECT_TRUE(refusal("colour").says("`stridor check FILE`"));
    EXPECT_TRUE(refusal("").says("`stridor check FILE`"));
}

TEST(FieldName, OfAQuantityIsNoChoice) {
    EXPECT_EQ(key_of(quantity_named("f_exc")), "drive.frequency");
    EXPECT_TRUE(thrown_by([] { quantity_named("run.initial"); }).says("is no quantity"));
}

}  // namespace
}  // namespace stridor::parameters
