#include "asset/gltf_accessor.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

namespace sg::asset {
namespace {

constexpr std::uint64_t kMostElements = 1u << 26;  // of one accessor

template <class T>
T load(const unsigned char* from) {
    T value;
    std::memcpy(&value, from, sizeof value);
    return value;
}

template <class T>
float scaled(const unsigned char* from, bool normalized) {
    const auto value = static_cast<float>(load<T>(from));
    if (!normalized || std::is_same_v<T, float>) return value;
    return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float load_float(const unsigned char* from, int component_type, bool normalized) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return scaled<std::int8_t>(from, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return scaled<std::uint8_t>(from, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return scaled<std::int16_t>(from, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return scaled<std::uint16_t>(from, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return scaled<std::uint32_t>(from, normalized);
        default:
            return load<float>(from);
    }
}

std::uint32_t load_index(const unsigned char* from, int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return load<std::uint8_t>(from);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(from);
        default:
            return load<std::uint32_t>(from);
    }
}

// Bytes of a component, 0 for a type that glTF 2.0 does not know.
std::uint64_t component_size(int component_type) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

bool is_index_type(int component_type) {
    return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Numbers per element of the types that vertex attributes have, else 0.
int width_of(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        default:
            return 0;
    }
}

template <class T>
bool in_list(int index, const std::vector<T>& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

}  // namespace

struct AccessorReader::Layout {
    std::uint64_t count = 0;
    int width = 0;
    int component_type = 0;
    std::uint64_t size = 0;                // bytes of one element
    std::uint64_t stride = 0;              // bytes from one element to the next
    const unsigned char* begin = nullptr;  // null: all elements are zero
};

bool AccessorReader::fail(std::string text) {
    reason = std::move(text);
    return false;
}

// The bytes of `count` elements `stride` apart in a buffer view.
bool AccessorReader::find_range(int view_index, std::uint64_t offset, std::uint64_t count, std::uint64_t size,
                                std::uint64_t stride, const unsigned char*& begin) {
    if (!in_list(view_index, model_.bufferViews))
        return fail(fmt::format("there is no buffer view {}", view_index));
    const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
    if (!in_list(view.buffer, model_.buffers)) return fail(fmt::format("there is no buffer {}", view.buffer));
    const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        return fail(fmt::format("buffer view {} leaves its buffer", view_index));
    const std::uint64_t length = count == 0 ? 0 : (count - 1) * stride + size;
    if (offset > view.byteLength || length > view.byteLength - offset)
        return fail(fmt::format("the numbers leave buffer view {}", view_index));
    begin = data.data() + view.byteOffset + offset;
    return true;
}

bool AccessorReader::find_layout(int index, Layout& layout) {
    if (!in_list(index, model_.accessors)) return fail(fmt::format("there is no accessor {}", index));
    const tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    layout.count = accessor.count;
    layout.width = width_of(accessor.type);
    layout.component_type = accessor.componentType;
    layout.size = component_size(accessor.componentType) * static_cast<std::uint64_t>(layout.width);
    layout.stride = layout.size;
    if (layout.size == 0) return fail(fmt::format("accessor {} has a type that cannot be read", index));
    if (layout.count > kMostElements)
        return fail(fmt::format("accessor {} has {} elements, expected at most {}", index, layout.count,
                                kMostElements));
    if (accessor.bufferView < 0) return true;
    if (in_list(accessor.bufferView, model_.bufferViews)) {
        const std::uint64_t stride =
            model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
        if (stride > 252) return fail(fmt::format("a byte stride of {}, expected at most 252", stride));
        if (stride != 0) layout.stride = stride;
    }
    return find_range(accessor.bufferView, accessor.byteOffset, layout.count, layout.size, layout.stride,
                      layout.begin);
}

bool AccessorReader::read_sparse_indices(int index, std::uint64_t limit, std::vector<std::uint32_t>& out) {
    const auto& sparse = model_.accessors[static_cast<std::size_t>(index)].sparse;
    const int type = sparse.indices.componentType;
    if (!is_index_type(type))
        return fail(fmt::format("accessor {} has sparse indices of a wrong type", index));
    if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
        static_cast<std::uint64_t>(sparse.count) > limit)
        return fail(fmt::format("accessor {} has a sparse part that is out of range", index));
    const std::uint64_t size = component_size(type);
    const auto count = static_cast<std::uint64_t>(sparse.count);
    const unsigned char* begin = nullptr;
    if (!find_range(sparse.indices.bufferView, static_cast<std::uint64_t>(sparse.indices.byteOffset), count,
                    size, size, begin))
        return false;
    for (std::uint64_t i = 0; i < count; ++i) {
        out.push_back(load_index(begin + i * size, type));
        if (out.back() >= limit)
            return fail(fmt::format("accessor {} has a sparse index out of range", index));
    }
    return true;
}

// load(bytes) gives one component.
template <class Number, class Load>
bool AccessorReader::read_elements(int index, const Layout& layout, Load load_one, std::vector<Number>& out) {
    const auto width = static_cast<std::uint64_t>(layout.width);
    const std::uint64_t step = layout.size / width;
    out.assign(layout.count * width, Number{});
    auto copy = [&](const unsigned char* from, std::uint64_t element) {
        for (std::uint64_t c = 0; c < width; ++c) out[element * width + c] = load_one(from + c * step);
    };
    if (layout.begin)
        for (std::uint64_t i = 0; i < layout.count; ++i) copy(layout.begin + i * layout.stride, i);
    const auto& sparse = model_.accessors[static_cast<std::size_t>(index)].sparse;
    if (!sparse.isSparse) return true;
    std::vector<std::uint32_t> places;
    const unsigned char* values = nullptr;
    if (!read_sparse_indices(index, layout.count, places) ||
        !find_range(sparse.values.bufferView, static_cast<std::uint64_t>(sparse.values.byteOffset),
                    places.size(), layout.size, layout.size, values))
        return false;
    for (std::size_t i = 0; i < places.size(); ++i) copy(values + i * layout.size, places[i]);
    return true;
}

bool AccessorReader::read_floats(int index, int width, bool may_be_narrower, std::vector<float>& out) {
    Layout layout;
    if (!find_layout(index, layout)) return false;
    const bool narrower = may_be_narrower && layout.width == width - 1;
    if (layout.width != width && !narrower)
        return fail(
            fmt::format("accessor {} has {} numbers per element, expected {}", index, layout.width, width));
    const bool normalized = model_.accessors[static_cast<std::size_t>(index)].normalized;
    const int type = layout.component_type;
    std::vector<float> numbers;
    auto load_one = [&](const unsigned char* from) { return load_float(from, type, normalized); };
    if (!read_elements(index, layout, load_one, numbers)) return false;
    if (!std::all_of(numbers.begin(), numbers.end(), [](float f) { return std::isfinite(f); }))
        return fail(fmt::format("accessor {} holds a number that is not finite", index));
    if (!narrower) {
        out = std::move(numbers);
        return true;
    }
    out.clear();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out.push_back(numbers[i]);
        if ((i + 1) % static_cast<std::size_t>(layout.width) == 0) out.push_back(1.0f);
    }
    return true;
}

bool AccessorReader::read_indices(int index, std::vector<std::uint32_t>& out) {
    Layout layout;
    if (!find_layout(index, layout)) return false;
    if (layout.width != 1 || !is_index_type(layout.component_type))
        return fail(fmt::format("accessor {} cannot hold indices, expected unsigned scalars", index));
    const int type = layout.component_type;
    return read_elements(
        index, layout, [&](const unsigned char* from) { return load_index(from, type); }, out);
}

}  // namespace sg::asset
