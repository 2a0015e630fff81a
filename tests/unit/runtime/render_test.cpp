// Small renders of the hand-written sample, checked by their numbers.
#include "runtime/render.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "runtime/gpu/device.hpp"
#include "runtime/mesh/shapes.hpp"
#include "tests/unit/runtime/sample_artefact.hpp"

namespace sg::runtime {
namespace {

constexpr std::uint32_t kSide = 64;

glm::dvec4 at(const Picture& picture, std::uint32_t x, std::uint32_t y) {
    const asset::Image& v = picture.values;
    return {v.at(x, y, 0), v.at(x, y, 1), v.at(x, y, 2), v.at(x, y, 3)};
}

class Render : public testing::Test {
protected:
    static void SetUpTestSuite() {
        Diags diags;
        device_ = new std::optional<gpu::Device>(gpu::Device::create({"", true}, diags));
        ASSERT_TRUE(*device_) << sg::render(diags);
    }
    static void TearDownTestSuite() {
        auto log = (*device_)->log();
        delete device_;
        EXPECT_EQ(log->messages(), std::vector<std::string>{});
    }
    void SetUp() override { load("off"); }

    void load(const std::string& two_sided) {
        ASSERT_EQ(files_.write_all(test::sample_files("dir", two_sided)), "");
        auto artefact = read_artefact(files_, "dir/sample.json", diags_);
        ASSERT_TRUE(artefact) << sg::render(diags_);
        artefact_ = std::move(*artefact);
    }
    void use(asset::Mesh mesh, const glm::mat4& world = glm::mat4(1)) {
        scene_.content = {};
        scene_.content.meshes.push_back(std::move(mesh));
        scene_.content.instances.push_back({"", 0, world});
        scene_.camera = default_camera(bounds_of(scene_.content), 1);
    }
    Picture draw(const std::string& view) {
        auto textures = load_textures(files_, artefact_, "dir", diags_);
        auto found = find_view(artefact_, view, diags_);
        RenderOptions options{kSide, kSide, supersample_, 0, {}};
        options.parameters.resize(16);
        if (!textures || !found) return {};
        auto picture = runtime::render(**device_, artefact_, *textures, scene_, *found, options, diags_);
        EXPECT_TRUE(picture) << sg::render(diags_);
        return picture ? std::move(*picture) : Picture{};
    }
    static double covered(const Picture& picture) {
        double sum = 0;
        for (float c : picture.coverage) sum += c;
        return sum;
    }
    static void for_each_covered(const Picture& picture,
                                 const std::function<void(std::uint32_t, std::uint32_t)>& check) {
        int count = 0;
        for (std::uint32_t y = 0; y < picture.values.height; ++y) {
            for (std::uint32_t x = 0; x < picture.values.width; ++x) {
                if (picture.coverage[std::size_t{y} * picture.values.width + x] != 1) continue;
                check(x, y);
                ++count;
            }
        }
        EXPECT_GT(count, 100);
    }

    static std::optional<gpu::Device>* device_;
    MemoryFiles files_;
    Diags diags_;
    Artefact artefact_;
    Scene scene_;
    std::uint32_t supersample_ = 1;
};
std::optional<gpu::Device>* Render::device_ = nullptr;

TEST_F(Render, PositionsLieOnTheSphereRelativeToTheCamera) {
    use(*make_shape("sphere"));
    Picture picture = draw("position");
    for_each_covered(picture, [&](std::uint32_t x, std::uint32_t y) {
        glm::dvec3 world = glm::dvec3(at(picture, x, y)) + scene_.camera.position;
        EXPECT_NEAR(glm::length(world), 1, 4e-3);
        EXPECT_GT(glm::dot(world, scene_.camera.position), 0) << "the far side is seen";
    });
    EXPECT_EQ(at(picture, 0, 0), glm::dvec4(0));
}

TEST_F(Render, TheAxesPointWhereTheyShould) {
    use(*make_shape("sphere"));
    scene_.camera = {{0, 0, 5}, {0, 0, 0}};
    Picture picture = draw("base-normal");
    glm::dvec3 middle = glm::normalize(glm::dvec3(at(picture, kSide / 2, kSide / 2)));
    EXPECT_GT(middle.z, 0.99);
    EXPECT_GT(at(picture, kSide * 3 / 4, kSide / 2).x, 0.4) << "x points right";
    EXPECT_GT(at(picture, kSide / 2, kSide / 4).y, 0.4) << "y points up";
}

TEST_F(Render, DepthAndPlaceGiveThePositionBack) {
    use(*make_shape("torus"));
    for (double ortho : {0.0, 3.0}) {
        scene_.camera.ortho_height = ortho;
        Picture position = draw("position"), unprojected = draw("unprojected");
        for_each_covered(position, [&](std::uint32_t x, std::uint32_t y) {
            EXPECT_LT(glm::distance(glm::dvec3(at(position, x, y)), glm::dvec3(at(unprojected, x, y))), 2e-4);
        });
    }
}

TEST_F(Render, OrthographicDerivativesAreThePlanesOwn) {
    use(*make_shape("plane"));
    scene_.camera = {{0, 0, 5}, {0, 0, 0}, 30, 2.5};
    Picture picture = draw("uv0-derivatives");
    double expected = 2.5 / kSide / 2;  // the plane is 2 wide, its uvs 1
    for_each_covered(picture, [&](std::uint32_t x, std::uint32_t y) {
        glm::dvec4 d = at(picture, x, y);
        EXPECT_NEAR(d.x, expected, 1e-6);
        EXPECT_NEAR(d.y, 0, 1e-6);
        EXPECT_NEAR(d.z, 0, 1e-6);
        EXPECT_NEAR(d.w, expected, 1e-6);
    });
    EXPECT_NEAR(covered(picture), std::pow(kSide * 2 / 2.5, 2), 110);
}

TEST_F(Render, TheTextureStandsUpright) {
    use(*make_shape("plane"));
    scene_.camera = {{0, 0, 5}, {0, 0, 0}, 30, 2.5};
    scene_.light = {{0, 0, 1}, glm::dvec3(1), glm::dvec3(0)};
    auto textures = load_textures(files_, artefact_, "dir", diags_);
    auto view = find_view(artefact_, "lit", diags_);
    RenderOptions options{2 * kSide, 2 * kSide, 1, 0, {}};  // larger than the texture: level 0
    const std::vector<float> values = {1, 1, 1, 2};
    options.parameters.assign(std::as_bytes(std::span(values)).begin(),
                              std::as_bytes(std::span(values)).end());
    auto picture = runtime::render(**device_, artefact_, *textures, scene_, *view, options, diags_);
    ASSERT_TRUE(picture) << sg::render(diags_);
    auto near = [&](std::uint32_t x, std::uint32_t y, glm::dvec4 expected) {
        EXPECT_LT(glm::distance(at(*picture, x, y), expected), 1e-3) << x << ' ' << y;
    };
    near(40, 40, {2, 0, 0, 1});
    near(88, 40, {0, 2, 0, 1});
    near(40, 88, {0, 0, 2, 1});
    near(88, 88, {2, 2, 2, 1});
    near(14, 40, {2 * 0.010330, 0, 0, 1});  // the frame's code 26, decoded from sRGB
}

TEST_F(Render, OneSidedPlanesHideTheirBacks) {
    use(*make_shape("plane"));
    scene_.camera = {{0, 0, -5}, {0, 0, 0}};
    EXPECT_EQ(covered(draw("facing")), 0);
    load("mirror");
    Picture back = draw("facing");
    for_each_covered(back, [&](std::uint32_t x, std::uint32_t y) { EXPECT_EQ(at(back, x, y).x, 1); });
}

TEST_F(Render, MirroredInstancesShowTheirOutsides) {
    glm::mat4 mirror(1);
    mirror[0][0] = -1;
    use(*make_shape("torus"), mirror);
    Picture facing = draw("facing"), normal = draw("base-normal"), position = draw("position");
    for_each_covered(facing, [&](std::uint32_t x, std::uint32_t y) {
        EXPECT_EQ(at(facing, x, y).y, 1);
        EXPECT_LT(glm::dot(glm::dvec3(at(normal, x, y)), glm::dvec3(at(position, x, y))), 0.05);
    });
}

TEST_F(Render, TheNearerInstanceWinsInEitherOrder) {
    for (bool near_first : {false, true}) {
        use(*make_shape("plane"));
        glm::mat4 nearer(1);
        nearer[3][2] = 0.5f;
        auto& instances = scene_.content.instances;
        instances.insert(near_first ? instances.begin() : instances.end(), {"near", 0, nearer});
        scene_.camera = {{0, 0, 5}, {0, 0, 0}};
        EXPECT_NEAR(at(draw("position"), kSide / 2, kSide / 2).z, -4.5, 1e-5);
    }
}

TEST_F(Render, FarFromTheOriginNothingTrembles) {
    use(*make_shape("torus"));
    Picture here = draw("position");
    glm::mat4 far(1);
    far[3] = {4194304, -1048576, 2097152, 1};  // powers of two: the instance's own floats are exact
    scene_.content.instances[0].world_from_object = far;
    scene_.camera.position += glm::dvec3(far[3]);
    scene_.camera.target += glm::dvec3(far[3]);
    Picture there = draw("position");
    EXPECT_EQ(covered(here), covered(there));
    for_each_covered(here, [&](std::uint32_t x, std::uint32_t y) {
        EXPECT_LT(glm::distance(at(here, x, y), at(there, x, y)), 1e-5);
    });
}

TEST_F(Render, MissingTangentsAreMadeAndMatchTheExactOnes) {
    use(*make_shape("torus"));
    Picture exact = draw("tangent");
    scene_.content.meshes[0].tangents.clear();
    Picture made = draw("tangent");
    for_each_covered(exact, [&](std::uint32_t x, std::uint32_t y) {
        glm::dvec3 a(at(exact, x, y)), b(at(made, x, y));
        EXPECT_GT(glm::dot(glm::normalize(a), glm::normalize(b)), 0.995);
    });
}

TEST_F(Render, SupersamplingGivesPartialCoverage) {
    use(*make_shape("sphere"));
    double whole = covered(draw("base-normal"));
    supersample_ = 4;
    Picture smooth = draw("base-normal");
    EXPECT_EQ(smooth.values.width, kSide);
    EXPECT_NEAR(covered(smooth), whole, 12);
    bool partial =
        std::any_of(smooth.coverage.begin(), smooth.coverage.end(), [](float c) { return c > 0 && c < 1; });
    EXPECT_TRUE(partial);
}

// What prepare_mesh says through render(), for a mesh that lacks something.
TEST_F(Render, AMissingAttributeIsNamed) {
    auto message = [&](asset::Mesh mesh) {
        use(std::move(mesh));
        Diags diags;
        auto textures = load_textures(files_, artefact_, "dir", diags);
        RenderOptions options{kSide, kSide, 1, 0, std::vector<std::byte>(16)};
        View view = *find_view(artefact_, "lit", diags);
        EXPECT_FALSE(runtime::render(**device_, artefact_, *textures, scene_, view, options, diags));
        return sg::render(diags);
    };
    asset::Mesh mesh = *make_shape("cube");
    mesh.name = "crate";
    mesh.uvs[0].clear();
    EXPECT_EQ(message(mesh), "error: mesh 'crate' has no 'uv0', which material 'sample' needs [SG2004]\n");
    mesh.tangents.clear();
    mesh.name = "";
    EXPECT_EQ(message(mesh),
              "error: a mesh without a name has no 'uv0', which material 'sample' needs [SG2004]\n");
    mesh = *make_shape("cube");
    mesh.name = "crate";
    mesh.normals.clear();
    EXPECT_EQ(message(mesh), "error: mesh 'crate' has no 'normal', which material 'sample' needs [SG2004]\n");
}

}  // namespace
}  // namespace sg::runtime
