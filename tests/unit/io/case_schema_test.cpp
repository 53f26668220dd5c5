#include "stridor/io/case/case_schema.hpp"

#include "stridor/parameters/fields/field.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <string>

namespace stridor::io {
namespace {

using Json = nlohmann::json;

bool lists(const Json& array, const std::string& name) {
    return std::find(array.begin(), array.end(), name) != array.end();
}

TEST(CaseSchema, DescribesEveryFieldOnce) {
    const Json schema = Json::parse(json_schema());
    EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    EXPECT_EQ(schema["additionalProperties"], false);
    std::size_t described = 0;
    for (const auto& [name, section] : schema["properties"].items())
        if (name == "temperature")
            ++described;  // its value; the lists are no fields
        else if (name == "structure")
            described += static_cast<std::size_t>(
                std::count_if(parameters::fields().begin(), parameters::fields().end(),
                              [&, &keys = section["properties"]](const parameters::Field& field) {
                                  return field.section == "structure" && keys.contains(std::string(field.name));
                              }));  // the other keys are no fields
        else if (name == "joint")
            described += section["oneOf"][0]["properties"].size();
        else if (name != "chart" && name != "title" && name != "document")  // words are no fields
            described += section["properties"].size();
    EXPECT_EQ(described + 1, parameters::fields().size());
    EXPECT_TRUE(schema["properties"]["document"]["properties"].contains("author"));
    const Json& preload = schema["properties"]["contact"]["properties"]["preload"];
    EXPECT_EQ(preload["exclusiveMinimum"], 0.0);
    EXPECT_NE(preload["description"].get<std::string>().find("(F); N, above 0"), std::string::npos);
}

TEST(CaseSchema, RequiresWhatTheReaderRequires) {
    const Json schema = Json::parse(json_schema());
    EXPECT_TRUE(lists(schema["required"], "drive"));
    // joint and plate, or a structure
    EXPECT_EQ(schema["allOf"][1]["if"]["required"], Json::array({"structure"}));
    EXPECT_EQ(schema["allOf"][1]["else"]["required"], Json::array({"joint", "plate"}));
    for (const char* key : {"mass", "file", "builder", "contacts", "blocks", "position", "stiffness_scale"})
        EXPECT_TRUE(schema["properties"]["structure"]["properties"].contains(key)) << key;
    // a contact of its own, unless there are several joints with theirs
    EXPECT_EQ(schema["allOf"][0]["then"]["required"], Json::array({"contact"}));
    EXPECT_EQ(schema["allOf"][0]["else"]["not"]["required"], Json::array({"contact"}));
    const Json& each = schema["properties"]["joint"]["oneOf"][1]["items"];
    for (const char* name : {"name", "contact", "mass", "incidence_angle"})
        EXPECT_TRUE(lists(each["required"], name)) << name;
    EXPECT_TRUE(lists(each["properties"]["contact"]["required"], "preload"));
    EXPECT_FALSE(lists(each["required"], "axial_stiffness"));
    EXPECT_FALSE(lists(schema["required"], "run"));
    EXPECT_TRUE(lists(schema["allOf"][1]["else"]["properties"]["contact"]["required"], "preload"));
    // what may follow the temperature must be there without a table only
    EXPECT_FALSE(lists(schema["properties"]["contact"]["required"], "kinetic_friction"));
    EXPECT_EQ(schema["if"]["not"]["anyOf"][0]["required"], Json::array({"temperature"}));
    EXPECT_TRUE(lists(schema["then"]["properties"]["contact"]["required"], "kinetic_friction"));
    const Json& of_each = schema["then"]["properties"]["joint"]["items"];
    EXPECT_TRUE(lists(of_each["required"], "axial_stiffness"));
    EXPECT_TRUE(lists(of_each["properties"]["contact"]["required"], "kinetic_friction"));
    EXPECT_FALSE(lists(schema["required"], "temperature"));
    // a pair of materials may be known over the temperature, without a table in the case
    EXPECT_EQ(schema["properties"]["temperature"]["required"], Json::array({"value"}));
    const Json& without_pair = schema["allOf"].back();
    EXPECT_EQ(without_pair["if"]["not"]["anyOf"][0]["properties"]["contact"]["required"], Json::array({"pair"}));
    EXPECT_EQ(without_pair["if"]["not"]["anyOf"][1]["properties"]["joint"]["type"], "array");
    EXPECT_EQ(without_pair["then"]["properties"]["temperature"]["required"], Json::array({"at"}));
    for (const char* name : {"at", "axial_stiffness", "k1i", "joint"})
        EXPECT_TRUE(schema["properties"]["temperature"]["properties"].contains(name)) << name;
    // of several joints each may have lists below its name
    const Json& named = schema["properties"]["temperature"]["properties"]["joint"]["additionalProperties"];
    EXPECT_TRUE(named["properties"].contains("axial_stiffness"));
    EXPECT_TRUE(named["properties"].contains("mu_d"));
    EXPECT_TRUE(named["properties"]["contact"]["properties"].contains("kinetic_friction"));
    EXPECT_FALSE(lists(schema["properties"]["contact"]["required"], "impact"));
    const Json& drive = schema["properties"]["drive"];
    EXPECT_EQ(drive["required"], Json::array({"kind"}));
    ASSERT_EQ(drive["allOf"].size(), 5U);
    EXPECT_EQ(drive["allOf"][1]["if"]["properties"]["kind"]["const"], "constant");
    EXPECT_EQ(drive["allOf"][1]["then"]["required"], Json::array({"kind", "velocity"}));
    EXPECT_EQ(drive["allOf"][3]["then"]["required"], Json::array({"kind", "frequency", "velocity", "ramp"}));
    EXPECT_EQ(drive["properties"]["velocity"]["not"], (Json{{"const", 0}}));
}

TEST(CaseSchema, OffersNamesForChoicesAndAxes) {
    const Json schema = Json::parse(json_schema());
    EXPECT_EQ(schema["properties"]["drive"]["properties"]["kind"]["enum"],
              Json::array({"sinusoidal", "constant", "sampled", "trapezoidal", "force"}));
    const Json& axis = schema["properties"]["chart"]["properties"]["x"];
    EXPECT_TRUE(lists(axis["properties"]["parameter"]["enum"], "contact.preload"));
    EXPECT_FALSE(lists(axis["properties"]["parameter"]["enum"], "drive.kind"));
}

}  // namespace
}  // namespace stridor::io
