// Which diagnostics a JSON Schema can express, and why not the others.
#pragma once

#include <span>
#include <string_view>

#include "base/diag.hpp"

namespace sg::test {

struct Verdict {
    Code code;
    std::string_view beyond;  // why no schema can say it; empty: the schema refuses it
};
std::span<const Verdict> verdicts();
const Verdict* find_verdict(Code code);

// A case of tests/errors whose code a schema can say, but not of this fault.
struct BeyondCase {
    std::string_view name;
    std::string_view reason;
};
std::span<const BeyondCase> beyond_cases();
const BeyondCase* find_beyond_case(std::string_view name);

// An error whose code a schema can say, but not this one, which is known by a part of its message.
struct BeyondMessage {
    Code code;
    std::string_view part;
    std::string_view reason;
};
const BeyondMessage* find_beyond_message(int code, std::string_view message);

}  // namespace sg::test
