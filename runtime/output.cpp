#include "runtime/output.hpp"

#include <algorithm>
#include <cctype>

#include "base/ice.hpp"

namespace sg::runtime {
namespace {

asset::ExrLayer coverage_layer(const Picture& picture) {
    asset::Image image =
        asset::make_image(picture.values.width, picture.values.height, asset::TexelFormat::float32);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            image.set(x, y, 0, picture.coverage[std::size_t{y} * image.width + x]);
        }
    }
    return {"coverage", 1, std::move(image)};
}

}  // namespace

std::optional<PictureFormat> picture_format(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (extension == ".png") return PictureFormat::png;
    if (extension == ".exr") return PictureFormat::exr;
    if (extension == ".pfm") return PictureFormat::pfm;
    return std::nullopt;
}

std::string picture_bytes(const Picture& picture, const DebugView& view, PictureFormat format,
                          const DisplayOptions& display) {
    if (format == PictureFormat::pfm) return asset::pfm_bytes(picture.values);
    if (format == PictureFormat::png) {
        return asset::png_bytes(view.kind == ViewKind::radiance
                                    ? lit_to_display(picture, display.exposure)
                                    : values_to_display(picture, view, display.space));
    }
    std::vector<asset::ExrLayer> layers = {{"", 4, picture.values}};
    if (view.components == 4) layers.push_back(coverage_layer(picture));
    return asset::exr_bytes(layers);
}

std::string layered_exr(const std::vector<View>& views, std::vector<Picture> pictures) {
    SG_ASSERT(views.size() == pictures.size() && !views.empty());
    std::vector<asset::ExrLayer> layers = {coverage_layer(pictures[0])};
    for (std::size_t i = 0; i < views.size(); ++i) {
        layers.push_back({views[i].view.name, 4, std::move(pictures[i].values)});
    }
    return asset::exr_bytes(layers);
}

}  // namespace sg::runtime
