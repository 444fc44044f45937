#include "fmu/description.hpp"

#include <fmt/format.h>

#include "core/text.hpp"

namespace floes {

namespace {

std::string start_of(const FmuVariable& one, const FmuDescription& of) {
    if (one.reference == fmu_reference::arrangement) return fmt::format("{}", of.arrangement);
    if (one.reference == fmu_reference::case_name) return markup_escaped(of.case_name);
    return one.type == FmuType::string ? "" : "0";
}

/// "fixed" and "discrete" are no defaults of a real variable.
std::string_view variability_of(const FmuVariable& one) {
    if (one.role == FmuRole::parameter) return " variability=\"fixed\"";
    return one.type == FmuType::real ? "" : " variability=\"discrete\"";
}

std::string common_attributes(const FmuVariable& one) {
    return fmt::format(R"(name="{}" valueReference="{}" description="{}" causality="{}"{})", one.name, one.reference,
                       markup_escaped(one.words), fmu_role_words.at(static_cast<std::size_t>(one.role)),
                       variability_of(one));
}

/// Start, of what hosts set, and unit.
std::string value_attributes(const FmuVariable& one, const FmuDescription& of) {
    std::string text;
    if (one.role != FmuRole::output) text += fmt::format(" start=\"{}\"", start_of(one, of));
    if (!one.unit.empty()) text += fmt::format(" unit=\"{}\"", one.unit);
    return text;
}

std::string units_text() {
    std::string text = "  <UnitDefinitions>\n";
    for (const FmuUnit& unit : fmu_units())
        text += fmt::format("    <Unit name=\"{}\"><BaseUnit {}/></Unit>\n", unit.name, unit.base);
    return text + "  </UnitDefinitions>\n";
}

/// From the capabilities to the variables, the same in both versions.
std::string before_variables(const FmuDescription& of) {
    return units_text() +
           fmt::format(
               "  <LogCategories>\n    <Category name=\"logStatusWarning\"/>\n    <Category name=\"logStatusError\"/>\n"
               "  </LogCategories>\n  <DefaultExperiment startTime=\"0\" stopTime=\"{}\" stepSize=\"{}\"/>\n"
               "  <ModelVariables>\n",
               of.stop_time, of.time_step);
}

std::string variable_2(const FmuVariable& one, const FmuDescription& of) {
    constexpr std::array<std::string_view, 3> types{"Real", "Integer", "String"};
    return fmt::format("    <ScalarVariable {}><{}{}/></ScalarVariable>\n", common_attributes(one),
                       types.at(static_cast<std::size_t>(one.type)), value_attributes(one, of));
}

std::string variable_3(const FmuVariable& one, const FmuDescription& of) {
    constexpr std::array<std::string_view, 3> types{"Float64", "Int32", "String"};
    const std::string_view type = types.at(static_cast<std::size_t>(one.type));
    if (one.type == FmuType::string)
        return fmt::format("    <{} {}><Start value=\"{}\"/></{}>\n", type, common_attributes(one), start_of(one, of),
                           type);
    return fmt::format("    <{} {}{}/>\n", type, common_attributes(one), value_attributes(one, of));
}

std::string text_2(const FmuDescription& of) {
    std::string text = fmt::format(
        "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{}\" generationTool=\"{}\" "
        "variableNamingConvention=\"flat\">\n"
        "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"false\" "
        "canNotUseMemoryManagementFunctions=\"true\" canGetAndSetFMUstate=\"{}\" canSerializeFMUstate=\"{}\"/>\n",
        markup_escaped(of.model_name), of.token, of.program, fmu_identifier, of.can_be_saved, of.can_be_saved);
    text += before_variables(of);
    std::string unknowns;
    int index = 0;
    for (const FmuVariable& one : fmu_variables(of.mover)) {
        ++index;
        text += variable_2(one, of);
        if (one.role == FmuRole::output)
            unknowns += fmt::format("      <Unknown index=\"{}\" dependencies=\"\"/>\n", index);
    }
    return text + fmt::format(
                      "  </ModelVariables>\n  <ModelStructure>\n    <Outputs>\n{0}    </Outputs>\n"
                      "    <InitialUnknowns>\n{0}    </InitialUnknowns>\n  </ModelStructure>\n",
                      unknowns);
}

std::string text_3(const FmuDescription& of) {
    std::string text = fmt::format(
        "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" instantiationToken=\"{}\" generationTool=\"{}\" "
        "variableNamingConvention=\"flat\">\n"
        "  <CoSimulation modelIdentifier=\"{}\" canHandleVariableCommunicationStepSize=\"false\" "
        "fixedInternalStepSize=\"{}\" canGetAndSetFMUState=\"{}\" canSerializeFMUState=\"{}\"/>\n",
        markup_escaped(of.model_name), of.token, of.program, fmu_identifier, of.time_step, of.can_be_saved,
        of.can_be_saved);
    text += before_variables(of);
    text +=
        "    <Float64 name=\"time\" valueReference=\"0\" causality=\"independent\" variability=\"continuous\" "
        "unit=\"s\"/>\n";
    std::string outputs;
    std::string initial;
    for (const FmuVariable& one : fmu_variables(of.mover)) {
        text += variable_3(one, of);
        if (one.role != FmuRole::output) continue;
        outputs += fmt::format("    <Output valueReference=\"{}\" dependencies=\"\"/>\n", one.reference);
        initial += fmt::format("    <InitialUnknown valueReference=\"{}\" dependencies=\"\"/>\n", one.reference);
    }
    return text + "  </ModelVariables>\n  <ModelStructure>\n" + outputs + initial + "  </ModelStructure>\n";
}

}  // namespace

std::string fmu_description(const FmuDescription& of, FmiVersion version) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + (version == FmiVersion::two ? text_2(of) : text_3(of)) +
           "</fmiModelDescription>\n";
}

}  // namespace floes
