// The shared test data beside the repository, which need not be there.
#pragma once

#include <string>

#include "tests/render/workshop.hpp"

namespace sg::proof {

const std::string kData = SG_SOURCE_DIR "/../shared/data/";

bool here(const std::string& file);
std::string bytes_of(const std::string& file);
#define SG_NEEDS(file) \
    if (!here(file)) GTEST_SKIP() << "the shared test data is not here: " << kData << (file)

// A material of one layer with one of these pictures.
truth::Made one_layer(const std::string& file, const std::string& texture, const std::string& layer,
                      const std::string& more = "");

}  // namespace sg::proof
