// What surfgrad-render does, step by step.
#pragma once

#include "base/diag.hpp"
#include "runtime/cli.hpp"

namespace sg::runtime {

// Gives the exit code: 0 fine, 1 the input is wrong, 2 the command line is wrong, 4 the system failed, or
// what surfgradc left with. Messages are in `diags`; the list of devices goes to stdout.
int run_program(const Arguments& arguments, Diags& diags);

}  // namespace sg::runtime
