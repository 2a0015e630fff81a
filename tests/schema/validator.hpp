// A third party's JSON Schema validator (valijson, draft-07) over what `surfgradc schema` prints.
#pragma once

#include <memory>
#include <string>

namespace valijson {
class Schema;
}

namespace sg::test {

class SchemaValidator {
public:
    // Throws where valijson cannot read the schema.
    explicit SchemaValidator(const std::string& schema_text);
    ~SchemaValidator();
    SchemaValidator(const SchemaValidator&) = delete;
    SchemaValidator& operator=(const SchemaValidator&) = delete;
    // "" if the document is as the schema says, else the places and reasons of the refusal, a line each.
    [[nodiscard]] std::string refusal(const std::string& document) const;

private:
    std::unique_ptr<valijson::Schema> schema_;
};

}  // namespace sg::test
