// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/import/gltf_document.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>

#include "core/job/atomic_file.h"
#include "core/math/json.h"
#include "core/mesh/import/scene_import.h"
#include "core/mesh/rigged_mesh.h"

namespace noctule {
namespace {

constexpr uint32_t kGlbMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

/// Demanded extensions that change nothing that is read here, or that are read.
const std::set<std::string>& knownExtensions() {
    static const std::set<std::string> known = {"KHR_mesh_quantization",
                                                "KHR_texture_transform",
                                                "KHR_materials_unlit",
                                                "KHR_materials_pbrSpecularGlossiness",
                                                "KHR_materials_specular",
                                                "KHR_materials_ior",
                                                "KHR_materials_emissive_strength",
                                                "KHR_materials_transmission",
                                                "KHR_materials_sheen",
                                                "KHR_materials_clearcoat",
                                                "KHR_materials_volume",
                                                "KHR_materials_variants",
                                                "KHR_lights_punctual",
                                                "KHR_texture_basisu",
                                                "EXT_texture_webp",
                                                "VRM",
                                                "VRMC_vrm",
                                                "VRMC_materials_mtoon",
                                                "VRMC_springBone",
                                                "VRMC_node_constraint"};
    return known;
}

uint32_t wordAt(std::string_view bytes, size_t at) {
    uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

int digitOfBase64(char c) {
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

std::string fromBase64(std::string_view text) {
    std::string bytes;
    uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int digit = digitOfBase64(c);
        if (digit < 0)
            continue;
        bits = bits << 6 | static_cast<uint32_t>(digit);
        if (++count == 4) {
            for (const int shift : {16, 8, 0})
                bytes += static_cast<char>(bits >> shift & 0xFF);
            bits = 0;
            count = 0;
        }
    }
    for (int kept = count - 1, shift = 8 * kept - 8; kept > 0; --kept, shift -= 8)
        bytes += static_cast<char>(bits >> (6 * count - 8 * (count - 1)) >> shift & 0xFF);
    return bytes;
}

int digitOfHex(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

}  // namespace

const nlohmann::json& gltfMember(const nlohmann::json& object, const char* member) {
    static const nlohmann::json nothing;
    const auto found = object.is_object() ? object.find(member) : object.end();
    return object.is_object() && found != object.end() ? *found : nothing;
}

std::optional<size_t> gltfIndex(const nlohmann::json& object, const char* member) {
    const nlohmann::json& value = gltfMember(object, member);
    if (!value.is_number_integer() || value.get<int64_t>() < 0)
        return std::nullopt;
    return static_cast<size_t>(value.get<int64_t>());
}

std::string percentDecoded(const std::string& uri) {
    std::string plain;
    for (size_t i = 0; i < uri.size(); ++i) {
        const int high = i + 2 < uri.size() && uri[i] == '%' ? digitOfHex(uri[i + 1]) : -1;
        const int low = high >= 0 ? digitOfHex(uri[i + 2]) : -1;
        plain += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
        i += low >= 0 ? 2 : 0;
    }
    return plain;
}

std::optional<std::string> dataOfUri(const std::string& uri) {
    const size_t comma = uri.find(',');
    if (!uri.starts_with("data:") || comma == std::string::npos)
        return std::nullopt;
    if (uri.substr(0, comma).ends_with(";base64"))
        return fromBase64(std::string_view(uri).substr(comma + 1));
    return percentDecoded(uri.substr(comma + 1));
}

Error GltfDocument::damaged(const std::string& what) const {
    return damagedMeshFile(path_, what);
}

Result<GltfDocument> GltfDocument::open(const std::string& path) {
    const auto bytes = readWholeFile(path);
    if (!bytes)
        return bytes.error();
    GltfDocument document;
    document.path_ = path;
    if (const Status read = document.readContainer(*bytes); !read)
        return read.error();
    return document;
}

Status GltfDocument::readContainer(const std::string& bytes) {
    std::string_view text = bytes, binary;
    if (bytes.size() >= 12 && wordAt(bytes, 0) == kGlbMagic) {
        if (wordAt(bytes, 4) != 2)
            return damaged("it is glTF of version " + std::to_string(wordAt(bytes, 4)) + ", not 2");
        if (wordAt(bytes, 8) > bytes.size())
            return damaged("it ends early: " + std::to_string(bytes.size()) + " of " +
                           std::to_string(wordAt(bytes, 8)) + " bytes are there");
        text = {};
        for (size_t at = 12; at + 8 <= bytes.size();) {
            const size_t length = wordAt(bytes, at);
            const uint32_t kind = wordAt(bytes, at + 4);
            if (length > bytes.size() - at - 8)
                return damaged("a chunk of it ends early");
            std::string_view& chunk = kind == kJsonChunk ? text : binary;
            if ((kind == kJsonChunk || kind == kBinaryChunk) && chunk.empty())
                chunk = std::string_view(bytes).substr(at + 8, length);
            at += 8 + length;
        }
    }
    json_ = nlohmann::json::parse(text, nullptr, false);
    if (!json_.is_object())
        return damaged("this is no mesh that can be read: it holds no glTF");
    if (const Status version = checkVersion(); !version)
        return version;
    return readBuffers(binary);
}

Status GltfDocument::checkVersion() const {
    const auto version = json::text(gltfMember(json_, "asset"), "version");
    if (!version || !version->starts_with("2"))
        return damaged("it is glTF of version " + version.value_or("unknown") + ", not 2");
    const nlohmann::json& required = gltfMember(json_, "extensionsRequired");
    for (const nlohmann::json& extension : required)
        if (!extension.is_string() || !knownExtensions().contains(extension.get<std::string>()))
            return Error{ErrorKind::kUnusable,
                         path_ + ": it needs the extension " + extension.dump() + ", which cannot be read",
                         "Export the body again without compression"};
    return Done{};
}

Status GltfDocument::readBuffers(std::string_view binary_chunk) {
    for (size_t b = 0; b < count("buffers"); ++b) {
        const nlohmann::json& buffer = item("buffers", b);
        const auto uri = json::text(buffer, "uri");
        if (!uri) {
            buffers_.emplace_back(b == 0 ? binary_chunk : std::string_view());
            continue;
        }
        auto bytes = bufferAt(*uri);
        if (!bytes)
            return bytes.error();
        buffers_.push_back(std::move(*bytes));
    }
    return Done{};
}

/// Within the file, or beside or below it; wherever else a URI may point is not looked at.
Result<std::string> GltfDocument::bufferAt(const std::string& uri) const {
    if (auto data = dataOfUri(uri))
        return std::move(*data);
    const std::string name = percentDecoded(uri);
    const std::filesystem::path relative(name);
    const bool leaves = relative.is_absolute() || std::any_of(relative.begin(), relative.end(),
                                                              [](const auto& step) { return step == ".."; });
    const std::filesystem::path file = std::filesystem::path(path_).parent_path() / relative;
    std::error_code ignored;
    if (leaves || !std::filesystem::is_regular_file(file, ignored))
        return Error{ErrorKind::kUnreadable,
                     path_ + ": the file " + name + ", which holds its data, is not beside it",
                     "Copy that file into the same folder, or export the body as .glb, which is one file"};
    return readWholeFile(file.string());
}

const nlohmann::json& GltfDocument::item(const char* list, size_t index) const {
    static const nlohmann::json nothing;
    const nlohmann::json& items = gltfMember(json_, list);
    return items.is_array() && index < items.size() ? items[index] : nothing;
}

size_t GltfDocument::count(const char* list) const {
    const nlohmann::json& items = gltfMember(json_, list);
    return items.is_array() ? items.size() : 0;
}

std::optional<std::string_view> GltfDocument::view(size_t index) const {
    const nlohmann::json& view = item("bufferViews", index);
    const auto buffer = gltfIndex(view, "buffer"), length = gltfIndex(view, "byteLength");
    const size_t offset = gltfIndex(view, "byteOffset").value_or(0);
    if (!buffer || !length || *buffer >= buffers_.size())
        return std::nullopt;
    const std::string& bytes = buffers_[*buffer];
    if (offset > bytes.size() || *length > bytes.size() - offset)
        return std::nullopt;
    return std::string_view(bytes).substr(offset, *length);
}

}  // namespace noctule
