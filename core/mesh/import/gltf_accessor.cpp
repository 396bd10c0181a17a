// SPDX-License-Identifier: Apache-2.0
// The numbers of a glTF document.
#include <algorithm>
#include <cstring>

#include "core/math/json.h"
#include "core/mesh/import/gltf_document.h"

namespace noctule {
namespace {

constexpr size_t kMostNumbers = 64'000'000;  ///< of one accessor; a matrix per bone and frame is far below

using ComponentType = GltfComponentType;

constexpr ComponentType kComponentTypes[] = {{5120, 1, 127},   {5121, 1, 255},          {5122, 2, 32767},
                                             {5123, 2, 65535}, {5125, 4, 4294967295.0}, {5126, 4, 1}};

template <class Number>
double numberAs(const char* bytes) {
    Number number{};
    std::memcpy(&number, bytes, sizeof number);
    return static_cast<double>(number);
}

double numberAt(const char* bytes, int code) {
    switch (code) {
        case 5120:
            return numberAs<int8_t>(bytes);
        case 5121:
            return numberAs<uint8_t>(bytes);
        case 5122:
            return numberAs<int16_t>(bytes);
        case 5123:
            return numberAs<uint16_t>(bytes);
        case 5125:
            return numberAs<uint32_t>(bytes);
        default:
            return numberAs<float>(bytes);
    }
}

size_t componentsOf(const std::string& type) {
    constexpr std::pair<const char*, size_t> kTypes[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (const auto& [name, components] : kTypes)
        if (type == name)
            return components;
    return 0;
}

}  // namespace

/// Where the numbers of an accessor stand.
struct GltfDocument::Layout {
    std::string_view bytes;  ///< from its first number on; empty: all zeros
    size_t count = 0, components = 1, stride = 0;
    GltfComponentType type;
    bool normalized = false;
};

Result<GltfDocument::Layout> GltfDocument::layoutOf(size_t accessor) const {
    const std::string name = "accessor " + std::to_string(accessor);
    const nlohmann::json& told = item("accessors", accessor);
    Layout layout;
    const auto count = gltfIndex(told, "count"), code = gltfIndex(told, "componentType");
    layout.components = componentsOf(json::text(told, "type").value_or(""));
    const auto type =
        std::find_if(std::begin(kComponentTypes), std::end(kComponentTypes),
                     [&](const auto& known) { return code && known.code == static_cast<int>(*code); });
    if (!count || layout.components == 0 || type == std::end(kComponentTypes))
        return damaged(name + " is none");
    if (*count > kMostNumbers / layout.components)
        return damaged(name + " holds too many numbers");
    layout.count = *count;
    layout.type = *type;
    layout.normalized = gltfMember(told, "normalized") == true;
    const auto index = gltfIndex(told, "bufferView");
    if (!index)
        return layout;
    const auto bytes = view(*index);
    const size_t offset = gltfIndex(told, "byteOffset").value_or(0), size = layout.components * type->bytes;
    layout.stride = gltfIndex(item("bufferViews", *index), "byteStride").value_or(size);
    const bool fits =
        bytes && offset <= bytes->size() && layout.stride <= 65'536 &&
        (layout.count == 0 || (layout.count - 1) * layout.stride + size <= bytes->size() - offset);
    if (!fits)
        return damaged(name + " points outside of its buffer");
    layout.bytes = bytes->substr(offset);
    return layout;
}

/// put(place among all numbers, number)
template <class Put>
Status GltfDocument::eachNumber(const Layout& layout, const Put& put) const {
    if (layout.bytes.empty())
        return Done{};
    for (size_t e = 0; e < layout.count; ++e)
        for (size_t c = 0; c < layout.components; ++c) {
            const double number =
                numberAt(layout.bytes.data() + e * layout.stride + c * layout.type.bytes, layout.type.code);
            put(e * layout.components + c,
                layout.normalized ? std::max(-1.0, number / layout.type.largest) : number);
        }
    return Done{};
}

/// Numbers that replace some of the others.
template <class Put>
Status GltfDocument::eachSparse(size_t accessor, const Layout& layout, const Put& put) const {
    const nlohmann::json& sparse = gltfMember(item("accessors", accessor), "sparse");
    if (!sparse.is_object())
        return Done{};
    const auto wrong = [&] {
        return damaged("accessor " + std::to_string(accessor) + " replaces what is not there");
    };
    const nlohmann::json &where = gltfMember(sparse, "indices"), &what = gltfMember(sparse, "values");
    const auto count = gltfIndex(sparse, "count"), code = gltfIndex(where, "componentType");
    const auto index_view = gltfIndex(where, "bufferView"), value_view = gltfIndex(what, "bufferView");
    if (!index_view || !value_view)
        return wrong();
    const auto indices = view(*index_view), values = view(*value_view);
    const size_t size = layout.components * layout.type.bytes;
    const size_t index_bytes = code == 5121U ? 1 : code == 5123U ? 2 : code == 5125U ? 4 : 0;
    if (!count || !indices || !values || !index_bytes)
        return wrong();
    const size_t first_index = gltfIndex(where, "byteOffset").value_or(0);
    const size_t first_value = gltfIndex(what, "byteOffset").value_or(0);
    if (first_index > indices->size() || *count > (indices->size() - first_index) / index_bytes ||
        first_value > values->size() || *count > (values->size() - first_value) / size)
        return wrong();
    for (size_t i = 0; i < *count; ++i) {
        const auto element = static_cast<size_t>(
            numberAt(indices->data() + first_index + i * index_bytes, static_cast<int>(*code)));
        if (element >= layout.count)
            return wrong();
        Layout one = layout;
        one.bytes = values->substr(first_value + i * size);
        one.count = 1;
        const Status done = eachNumber(
            one, [&](size_t place, double number) { put(element * layout.components + place, number); });
        if (!done)
            return done;
    }
    return Done{};
}

Result<GltfNumbers> GltfDocument::numbers(size_t accessor, size_t components) const {
    const auto layout = layoutOf(accessor);
    if (!layout)
        return layout.error();
    if (layout->components != components)
        return damaged("accessor " + std::to_string(accessor) + " holds elements of " +
                       std::to_string(layout->components) + " numbers instead of " +
                       std::to_string(components));
    GltfNumbers numbers{std::vector<float>(layout->count * components, 0.0F), components};
    const auto put = [&](size_t place, double number) { numbers.values[place] = static_cast<float>(number); };
    for (const Status& done : {eachNumber(*layout, put), eachSparse(accessor, *layout, put)})
        if (!done)
            return done.error();
    return numbers;
}

Result<std::vector<uint32_t>> GltfDocument::indices(size_t accessor) const {
    const auto layout = layoutOf(accessor);
    if (!layout)
        return layout.error();
    std::vector<uint32_t> indices(layout->count * layout->components, 0);
    bool whole = true;
    const auto put = [&](size_t place, double number) {
        whole = whole && number >= 0 && number <= 4294967295.0;
        indices[place] = whole ? static_cast<uint32_t>(number) : 0;
    };
    for (const Status& done : {eachNumber(*layout, put), eachSparse(accessor, *layout, put)})
        if (!done)
            return done.error();
    if (!whole)
        return damaged("accessor " + std::to_string(accessor) + " holds what is no index");
    return indices;
}

}  // namespace noctule
