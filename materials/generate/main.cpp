// surfgrad-make-textures DIR: writes the sample textures into DIR (materials/textures in this repository).
#include <fmt/core.h>

#include "base/files.hpp"
#include "textures.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: surfgrad-make-textures DIR\n");
        return 2;
    }
    std::vector<std::pair<std::filesystem::path, std::string>> contents;
    for (const sg::samples::TextureRecipe& recipe : sg::samples::texture_recipes())
        contents.emplace_back(std::filesystem::path(argv[1]) / recipe.file,
                              sg::samples::make_texture(recipe));
    sg::RealFiles files;
    sg::Diags diags;
    sg::write_or_report(files, contents, diags);
    fmt::print(stderr, "{}", sg::render(diags));
    return diags.exit_code();
}
