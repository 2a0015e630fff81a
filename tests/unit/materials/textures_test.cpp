// The sample textures: the committed files are what the generator makes, and mean what materials/README.md
// says.
#include "materials/generate/textures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "asset/image.hpp"
#include "base/files.hpp"

namespace sg::samples {
namespace {

const std::filesystem::path kFolder = std::filesystem::path(SG_SOURCE_DIR) / "materials" / "textures";

TEST(SampleTextures, TheCommittedFilesAreFresh) {
    RealFiles files;
    std::size_t sum = 0;
    for (const TextureRecipe& recipe : texture_recipes()) {
        const Files::ReadResult committed = files.read(kFolder / recipe.file);
        ASSERT_EQ(committed.status, Files::Status::ok) << recipe.file;
        sum += committed.bytes.size();
        EXPECT_TRUE(committed.bytes == make_texture(recipe))
            << recipe.file << " is stale: run surfgrad-make-textures " << kFolder;
    }
    EXPECT_LT(sum, 680u * 1024);  // what a clone has to carry
}

struct Slope {
    double s, t;
};

// Decoded by the words of the recipe alone.
Slope slope_at(const asset::Image& image, const TextureRecipe& recipe, std::uint32_t x, std::uint32_t y) {
    const double reach = recipe.zero == 127.5 ? 127.5 : 127.0;
    auto value = [&](int c) { return (255.0 * image.at(x, y, c) - recipe.zero) / reach; };
    const double nx = value(0), ny = recipe.green_up ? -value(1) : value(1);
    const double nz = recipe.two_channels ? std::sqrt(1.0 - nx * nx - ny * ny) : value(2);
    return {-nx / nz, -ny / nz};
}

asset::Image decoded(const TextureRecipe& recipe) {
    RealFiles files;
    Diags diags;
    auto image = asset::read_image(files.read(kFolder / recipe.file).bytes, recipe.file, Place{}, diags);
    EXPECT_TRUE(image) << render(diags);
    return image ? *image : asset::make_image(1, 1, asset::TexelFormat::unorm8);
}

TEST(SampleTextures, SlopesAreThoseOfTheHeights) {
    for (const TextureRecipe& recipe : texture_recipes()) {
        if (recipe.content != Content::normal) continue;
        const asset::Image image = decoded(recipe);
        const double texel = 1.0 / recipe.size;
        double agreement = 0.0, size = 0.0;
        for (std::uint32_t y = 0; y < recipe.size; ++y) {
            for (std::uint32_t x = 0; x < recipe.size; ++x) {
                const double s = (x + 0.5) * texel, t = (y + 0.5) * texel, step = 0.25 * texel;
                const Slope found = slope_at(image, recipe, x, y);
                const Slope expected{(recipe.height(s + step, t) - recipe.height(s - step, t)) / (2 * step),
                                     (recipe.height(s, t + step) - recipe.height(s, t - step)) / (2 * step)};
                agreement += found.s * expected.s + found.t * expected.t;
                size += found.s * found.s + found.t * found.t;
            }
        }
        EXPECT_NEAR(agreement / size, 1.0, 0.2)
            << recipe.file;  // a texel's mean is tamer than the slope in its middle
    }
}

TEST(SampleTextures, TheyTileWithoutMeanSlope) {
    for (const TextureRecipe& recipe : texture_recipes()) {
        if (recipe.content != Content::normal) continue;
        const asset::Image image = decoded(recipe);
        Slope mean{0, 0};
        for (std::uint32_t y = 0; y < recipe.size; ++y) {
            for (std::uint32_t x = 0; x < recipe.size; ++x) {
                const Slope slope = slope_at(image, recipe, x, y);
                mean.s += slope.s / recipe.size / recipe.size;
                mean.t += slope.t / recipe.size / recipe.size;
            }
        }
        EXPECT_NEAR(mean.s, 0.0, 0.005) << recipe.file;  // half a code, where flat ground cannot be exact
        EXPECT_NEAR(mean.t, 0.0, 0.005) << recipe.file;
        for (const double u : {0.0, 0.1, 0.37, 0.77}) {
            EXPECT_NEAR(recipe.height(u, 0.0), recipe.height(u, 1.0), 1e-12) << recipe.file;
            EXPECT_NEAR(recipe.height(-0.25, u), recipe.height(0.75, u), 1e-12) << recipe.file;
        }
    }
}

// No texture may look the same with x or y turned round: their steep slopes lean one way.
TEST(SampleTextures, EachIsLopsided) {
    for (const TextureRecipe& recipe : texture_recipes()) {
        if (recipe.content != Content::normal) continue;
        const asset::Image image = decoded(recipe);
        double skew = 0.0, size = 0.0;
        for (std::uint32_t y = 0; y < recipe.size; ++y) {
            for (std::uint32_t x = 0; x < recipe.size; ++x) {
                const Slope slope = slope_at(image, recipe, x, y);
                const Slope turned = slope_at(image, recipe, recipe.size - 1 - x, recipe.size - 1 - y);
                skew += std::abs(slope.s + turned.s) + std::abs(slope.t + turned.t);
                size += std::abs(slope.s) + std::abs(slope.t);
            }
        }
        EXPECT_GT(skew / size, 0.2) << recipe.file;
    }
}

}  // namespace
}  // namespace sg::samples
