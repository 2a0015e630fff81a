#include "runtime/material_process.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace sg::runtime {
namespace {

// A shell script in the place of surfgradc.
class MaterialProcess : public testing::Test {
protected:
    void SetUp() override {
        Diags diags;
        folder_ = TemporaryFolder::create(diags);
        ASSERT_TRUE(folder_) << render(diags);
    }
    std::optional<int> run(const std::string& script, const std::filesystem::path& material = "a b.json") {
        std::filesystem::path program = folder_->path() / "surfgradc";
        std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        return compile_material(program, material, folder_->path(), diags_);
    }
    std::string read(const std::string& name) {
        std::ifstream file(folder_->path() / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::optional<TemporaryFolder> folder_;
    Diags diags_;
};

TEST_F(MaterialProcess, HandsOverItsArgumentsAndTheExitCode) {
    EXPECT_EQ(run("for a in \"$@\"; do echo \"$a\"; done > \"$4/said\""), 0);
    EXPECT_EQ(read("said"), "compile\na b.json\n-o\n" + folder_->path().string() + "\n");
    EXPECT_EQ(run("exit 1"), 1);
    EXPECT_EQ(run("exit 3"), 3);
    EXPECT_FALSE(diags_.has_errors());
}

TEST_F(MaterialProcess, AFileIsNeverAnOption) {
    EXPECT_EQ(run("echo \"$2\" > \"$4/said\"", "--help"), 0);
    EXPECT_EQ(read("said"), "./--help\n");
}

TEST_F(MaterialProcess, ReportsACompilerThatDoesNotStartOrDies) {
    EXPECT_EQ(run("kill -9 $$"), std::nullopt);
    EXPECT_EQ(compile_material("/no/such/surfgradc", "a.json", folder_->path(), diags_), std::nullopt);
    EXPECT_EQ(render(diags_),
              "error: surfgradc was ended by signal 9 [SG2206]\n"
              "error: '/no/such/surfgradc' cannot be started: No such file or directory [SG2206]\n");
    EXPECT_EQ(diags_.exit_code(), 4);
}

TEST_F(MaterialProcess, TheFolderGoesWithItsOwner) {
    std::filesystem::path path = folder_->path();
    std::ofstream(path / "file") << "x";
    { TemporaryFolder moved = std::move(*folder_); }
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace sg::runtime
