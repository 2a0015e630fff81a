#include <fmt/core.h>
#include <gtest/gtest.h>

#include "tests/cross/gl.hpp"
#include "tests/cross/hlsl.hpp"
#include "tests/cross/metal.hpp"
#include "tests/cross/webgl.hpp"

namespace sg::cross {
namespace {

TEST(Cross, First) {
    for (const std::string& name : sample_names()) {
        const Sample& s = sample(name);
        auto show = [&](const char* t, const Pixels& p) {
            Difference d = compare(reference(s), p);
            fmt::print("{} {}: max {:.3g} p999 {:.3g} both {} alone {}\n", name, t, d.largest, d.p999, d.both, d.one_alone);
        };
        for (const char* t : {"hlsl50", "hlsl60"}) show(t, render_words(s, hlsl_to_words(drawing(s, *target::find_target(t)))));
        for (const char* t : {"glsl450", "essl310"}) show(t, gl_draw(drawing(s, *target::find_target(t))));
    }
    std::vector<Drawing> all;
    for (const std::string& name : sample_names()) all.push_back(drawing(sample(name), *target::find_target("essl300")));
    auto o = webgl_draw(all, {});
    for (std::size_t i = 0; i < all.size(); ++i) {
        fmt::print("{}\n", o.refusals[i]);
        if (o.pictures[i].empty()) continue;
        Difference d = compare(reference(sample(all[i].sample)), o.pictures[i]);
        fmt::print("{} webgl: max {:.3g} p999 {:.3g} both {} alone {}\n", all[i].sample, d.largest, d.p999, d.both, d.one_alone);
    }
    for (const char* t : {"msl21", "msl23"}) {
        all.clear();
        for (const std::string& name : sample_names()) all.push_back(drawing(sample(name), *target::find_target(t)));
        auto p = metal_draw(all);
        for (std::size_t i = 0; i < all.size(); ++i) {
            Difference d = compare(reference(base_sample(sample(all[i].sample))), p[i]);
            fmt::print("{} {}: max {:.3g} p999 {:.3g} both {} alone {}\n", all[i].sample, t, d.largest, d.p999, d.both, d.one_alone);
        }
    }
    for (auto& m : validation_messages()) fmt::print("{}\n", m);
}

}  // namespace
}  // namespace sg::cross
