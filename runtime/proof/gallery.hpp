// The gallery: figures as one static page.
#pragma once

#include "runtime/proof/figure_run.hpp"

namespace sg::proof {

// index.html and its pictures, by name. The page needs no network, and no script but its own.
std::vector<std::pair<std::filesystem::path, std::string>> gallery_files(
    const std::vector<DrawnFigure>& figures);

}  // namespace sg::proof
