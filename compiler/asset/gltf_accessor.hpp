// Numbers out of glTF accessors, with every bound checked. Internal to this folder.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tinygltf {
class Model;
}

namespace sg::asset {

// Reads accessors of one file. A failed read returns false and leaves the reason, in the words of a message,
// in `reason`.
class AccessorReader {
public:
    explicit AccessorReader(const tinygltf::Model& model) : model_(model) {}

    // All elements one after another, `width` (1 to 4) numbers each; the accessor may have `width` components
    // or, if `may_be_narrower`, one less (then the last number of each element is 1). Integers are scaled to
    // 0..1 or -1..1 where the accessor is normalised. Fails on numbers that are not finite.
    bool read_floats(int accessor, int width, bool may_be_narrower, std::vector<float>& out);
    // Unsigned scalars.
    bool read_indices(int accessor, std::vector<std::uint32_t>& out);

    std::string reason;

private:
    struct Layout;
    bool find_layout(int accessor, Layout& layout);
    bool find_range(int view, std::uint64_t offset, std::uint64_t count, std::uint64_t size,
                    std::uint64_t stride, const unsigned char*& begin);
    template <class Number, class Load>
    bool read_elements(int accessor, const Layout& layout, Load load, std::vector<Number>& out);
    bool read_sparse_indices(int accessor, std::uint64_t limit, std::vector<std::uint32_t>& out);
    bool fail(std::string text);

    const tinygltf::Model& model_;
};

}  // namespace sg::asset
