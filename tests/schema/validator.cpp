#include "validator.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace sg::test {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

SchemaValidator::SchemaValidator(const std::string& schema_text)
    : schema_(std::make_unique<valijson::Schema>()) {
    nlohmann::json schema = nlohmann::json::parse(schema_text);
    Adapter adapter(schema);
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(adapter, *schema_);
}
SchemaValidator::~SchemaValidator() = default;

namespace {

// To draft-07 a number without a fraction is an integer, however it is written; valijson looks at the
// parser's type.
void with_whole_numbers(nlohmann::json& value) {
    if (value.is_structured()) {
        for (nlohmann::json& part : value) with_whole_numbers(part);
    } else if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number == std::trunc(number) && std::abs(number) < 1e15)
            value = static_cast<std::int64_t>(number);
    }
}

}  // namespace

std::string SchemaValidator::refusal(const std::string& document) const {
    nlohmann::json value = nlohmann::json::parse(document);
    with_whole_numbers(value);
    Adapter adapter(value);
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(*schema_, adapter, &results)) return "";
    std::string out;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
        for (const std::string& step : error.context) out += step;
        out += ": " + error.description + "\n";
    }
    return out.empty() ? "refused without a reason\n" : out;
}

}  // namespace sg::test
