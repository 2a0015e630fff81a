#include "runtime/picture.hpp"

#include <array>

#include "base/ice.hpp"

namespace sg::runtime {
namespace {

// The mean of one block, for the pixel (x, y) of the smaller picture.
void shrink_pixel(const Picture& from, std::uint32_t factor, bool alpha_is_data, std::uint32_t x,
                  std::uint32_t y, Picture& to) {
    std::array<double, 4> sum{};
    double covered = 0;
    for (std::uint32_t j = y * factor; j < (y + 1) * factor; ++j) {
        for (std::uint32_t i = x * factor; i < (x + 1) * factor; ++i) {
            double weight = from.coverage[std::size_t{j} * from.values.width + i];
            covered += weight;
            if (weight == 0) continue;
            for (int c = 0; c < 4; ++c) sum[static_cast<std::size_t>(c)] += weight * from.values.at(i, j, c);
        }
    }
    if (covered == 0) return;
    double share = covered / (double{static_cast<double>(factor)} * factor);
    for (int c = 0; c < 4; ++c) to.values.set(x, y, c, sum[static_cast<std::size_t>(c)] / covered);
    if (!alpha_is_data) to.values.set(x, y, 3, share);
    to.coverage[std::size_t{y} * to.values.width + x] = static_cast<float>(share);
}

}  // namespace

Picture shrink(const Picture& picture, std::uint32_t factor, bool alpha_is_data) {
    SG_ASSERT(factor > 0 && picture.values.width % factor == 0 && picture.values.height % factor == 0);
    if (factor == 1) return picture;
    std::uint32_t width = picture.values.width / factor, height = picture.values.height / factor;
    Picture out{asset::make_image(width, height, asset::TexelFormat::float32), {}};
    out.coverage.resize(std::size_t{width} * height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) shrink_pixel(picture, factor, alpha_is_data, x, y, out);
    }
    return out;
}

}  // namespace sg::runtime
