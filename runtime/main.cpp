// surfgrad-render: arguments, one call, diagnostics, exit code.
#include <fmt/core.h>

#include "runtime/cli.hpp"
#include "runtime/program.hpp"

int main(int argc, char** argv) {
    sg::runtime::CommandLine line = sg::runtime::parse_command_line(argc, argv);
    if (!line.arguments) return line.exit_code;
    sg::Diags diags;
    int code = sg::runtime::run_program(*line.arguments, diags);
    fmt::print(stderr, "{}", sg::render(diags));
    return code;
}
