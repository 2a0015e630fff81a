#include "tests/proof/shared_data.hpp"

namespace sg::proof {

bool here(const std::string& file) {
    RealFiles files;
    return files.exists(kData + file);
}

std::string bytes_of(const std::string& file) {
    RealFiles files;
    return files.read(kData + file).bytes;
}

truth::Made one_layer(const std::string& file, const std::string& texture, const std::string& layer,
                      const std::string& more) {
    truth::Recipe recipe;
    recipe.json = R"({"version": 1, "textures": {"map": {"file": "map.)" + file.substr(file.rfind('.') + 1) +
                  "\", " + texture + R"(}}, "bump": [{"layers": [{"texture": "map", )" + layer + "}]}]" +
                  more + "}";
    recipe.files["map." + file.substr(file.rfind('.') + 1)] = bytes_of(file);
    recipe.entries = {"normal", "debug"};
    return truth::make(recipe);
}

}  // namespace sg::proof
