#include "validator.hpp"

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

std::string SchemaValidator::refusal(const std::string& document) const {
    nlohmann::json value = nlohmann::json::parse(document);
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
