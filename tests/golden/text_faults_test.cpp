// That the rules of text_faults.hpp find what they are for, so that samples without faults mean something.
#include "text_faults.hpp"

#include <gtest/gtest.h>

namespace sg::test {
namespace {

std::string in_main(const std::string& lines) {
    return "#version 450\n\nvec2 c_f(vec2 x) {\n    vec2 once = x;\n    return once;\n}\n\nvoid main() {\n" +
           lines + "}\n";
}

TEST(TextFaults, ALocalThatIsUsedOnce) {
    auto fault = [](const std::string& lines) { return local_used_once(in_main(lines), {"m_wall"}); };
    EXPECT_EQ(fault("    float m_a = f();\n    x = m_a * m_a;\n"), "");
    EXPECT_EQ(fault("    float m_a = f();\n    x = m_a;\n"), "'m_a' is used 1 times");
    EXPECT_EQ(fault("    float m_a = f();\n"), "'m_a' is used 0 times");
    EXPECT_EQ(fault("    vec3 m_b = g(\n        1.0,\n        f());\n    x = m_b + m_bc;\n"),
              "'m_b' is used 1 times");
    EXPECT_EQ(fault("    S s;\n    s.a = 1.0;\n"), "'s' is used 1 times");
    EXPECT_EQ(fault("    S s;\n    s.a = 1.0;\n    x = s;\n"), "");
    // What the author knows by its name.
    EXPECT_EQ(fault("    vec3 m_wall = f();\n    vec3 m_wall_2 = g();\n    x = m_wall * m_wall_2;\n"), "");
    EXPECT_EQ(fault("    vec3 m_wall_uv = f();\n    x = m_wall_uv;\n"), "'m_wall_uv' is used 1 times");
    // Derivatives in front of what would spoil them.
    EXPECT_EQ(fault("    SgUv m_uv = sg_stage_uv(u);\n    if (f() < 0.5) discard;\n    x = m_uv.st;\n"), "");
    EXPECT_EQ(fault("    SgUv m_uv = sg_stage_uv(u);\n    x = m_uv.st;\n"), "'m_uv' is used 1 times");
    EXPECT_EQ(fault("    float m_a = f();\n    if (m_a < 0.5) discard;\n"), "'m_a' is used 1 times");
}

TEST(TextFaults, ACallThatIsWrittenTwice) {
    EXPECT_EQ(computed_twice(in_main("    x = sg_f(a) + sg_f(b);\n")), "");
    EXPECT_EQ(computed_twice(in_main("    x = sg_f(a,\n             b) + g(sg_f(a, b));\n")),
              "'sg_f(a, b)' is computed twice");
    EXPECT_EQ(computed_twice(in_main("    x = sg_texture_size(t, s) + sg_texture_size(t, s);\n")), "");
}

TEST(TextFaults, ACommentThatStandsTwice) {
    EXPECT_EQ(comment_twice(in_main("    // a: noise\n    x = 1;\n\n    // b: noise\n")), "");
    EXPECT_EQ(comment_twice(in_main("    // a: noise\n    x = 1;\n\n    // a: noise\n")),
              "'    // a: noise' stands there twice");
}

TEST(TextFaults, ALayerWhoseLinesAreScattered) {
    auto fault = [](const std::string& lines) {
        return scattered_layer(in_main(lines), {"m_wall", "m_wall_2"}, {"m_wall_share"});
    };
    const std::string wall = "    // wall: noise\n    vec2 m_wall_uv = f();\n    vec3 m_wall = g();\n\n";
    EXPECT_EQ(fault(wall + "    // wall 2: noise\n    vec3 m_wall_2 = f();\n    vec3 m_wall_2_uv = f();\n"),
              "");
    EXPECT_EQ(fault("    float m_wall_share = f();\n    float m_wallet = f();\n\n" + wall), "");
    EXPECT_EQ(fault(wall + "    vec2 m_wall_uv_2 = f();\n"), "'m_wall_uv_2' stands outside of its layer");
    EXPECT_EQ(fault(wall + "    // wall 2: noise\n    vec2 m_wall_uv_2 = f();\n"),
              "'m_wall_uv_2' stands outside of its layer");
}

TEST(TextFaults, ANameThatSaysTheSameTwice) {
    for (const char* good : {"m_wall_uv", "m_noise_noise", "m_a_ab_uv", "sg_uv_uv_x"})
        EXPECT_EQ(stuttering_name(in_main("    x = " + std::string(good) + ";\n")), "") << good;
    EXPECT_EQ(stuttering_name(in_main("    x = f(m_wall_wall_uv);\n")), "'m_wall_wall_uv'");
    EXPECT_EQ(stuttering_name(in_main("    x = m_old_wall_old_wall_uv;\n")), "'m_old_wall_old_wall_uv'");
}

TEST(TextFaults, ALayerThatNoCommentNames) {
    const std::string text = in_main("    // a: noise\n    x = 1;\n\n    // b: group\n");
    EXPECT_EQ(unnamed_layer(text, {"a: noise", "b: group"}), "");
    EXPECT_EQ(unnamed_layer(text, {"a: noise", "b: noise"}), "'b: noise' is not named");
    EXPECT_EQ(unnamed_layer(text, {"x = 1;"}), "'x = 1;' is not named");
}

TEST(TextFaults, ALineThatIsTooLong) {
    EXPECT_EQ(long_line(std::string(120, 'x')), "");
    EXPECT_EQ(long_line("a\n" + std::string(121, 'x')), "121 letters: '" + std::string(121, 'x') + "'");
}

TEST(TextFaults, ArithmeticThatDoesNothing) {
    for (const char* good :
         {"a + 10.0", "1.0 - a", "-a * b", "a * 0.5", "vec2(0.0, 1.0) + a", "f(0.0, a)", "a / 1.0",
          "a * -0.5", "a - (-b - c)", "mix(vec3(1.0), a, 0.5)", "sg_uv_scale(a, vec2(2.0)), f(b, vec2(1.0))",
          "vec3(0.0, -0.05, 1.0)", "sg_frame_resolved(sg_stage_frame(p, n), m)"})
        EXPECT_EQ(idle_arithmetic(in_main("    x = " + std::string(good) + ";\n")), "") << good;
    for (const char* bad : {"vec2(0.0) + a",
                            "a + 0.0",
                            "1.0 * a",
                            "f(a * 1.0)",
                            "a - vec3(0.0)",
                            "0.0 * a",
                            "(0.0 + a)",
                            "f(b, 1.0 * a)",
                            "0.0 - a",
                            "-1.0 * a",
                            "a * -1.0 * b",
                            "a - -0.25",
                            "a + -b",
                            "vec3(0.0, -0.0, 1.0)",
                            "vec2(0.0, -0.0)",
                            "mix(vec3(1.0), a, 0.0)",
                            "mix(f(a), b, 1.0)",
                            "sg_uv_scale(sg_stage_uv(a), vec2(1.0))",
                            "sg_volume_scale(a, 1.0)",
                            "sg_frame_resolved(sg_stage_frame(p, n), n)",
                            "sg_frame_resolved(sg_stage_frame(p, sg_base_normal(n)), sg_base_normal(n))"})
        EXPECT_NE(idle_arithmetic(in_main("    x = " + std::string(bad) + ";\n")), "") << bad;
}

}  // namespace
}  // namespace sg::test
