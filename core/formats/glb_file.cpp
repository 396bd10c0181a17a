// SPDX-License-Identifier: Apache-2.0
#include "core/formats/glb_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>

#include "core/job/contract.h"

namespace noctule {
namespace {

using nlohmann::json;

constexpr size_t kFileHeader = 12, kChunkHeader = 8, kWord = 4;
constexpr uint32_t kVersion = 2;

uint32_t glbWord(std::string_view bytes, size_t at) {
    uint32_t word = 0;
    std::memcpy(&word, bytes.data() + at, sizeof word);
    return word;
}

void addGlbWord(std::string& bytes, size_t value) {
    const auto word = static_cast<uint32_t>(value);
    bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

json& listOf(json& document, const char* name) {
    json& list = document[name];
    if (!list.is_array())
        list = json::array();
    return list;
}

void shiftIndex(json& object, const char* member, size_t by) {
    if (const auto found = object.find(member); found != object.end())
        *found = found->get<size_t>() + by;
}

void shiftIndices(json& indices, size_t by) {
    for (json& index : indices)
        index = index.get<size_t>() + by;
}

/// Textures stand at several depths of a material: {"index": 0} under a name that ends with "Texture".
void shiftTextures(json& material, size_t by) {
    for (const auto& [name, member] : material.items())
        if (member.is_object()) {
            if (name.ends_with("Texture"))
                shiftIndex(member, "index", by);
            shiftTextures(member, by);
        }
}

void shiftMesh(json& mesh, size_t accessors, size_t materials) {
    for (json& primitive : mesh["primitives"]) {
        shiftIndex(primitive, "indices", accessors);
        shiftIndex(primitive, "material", materials);
        for (json& attribute : primitive["attributes"])
            attribute = attribute.get<size_t>() + accessors;
    }
}

}  // namespace

GlbFile GlbFile::of(std::string_view bytes) {
    constexpr size_t kText = kFileHeader + kChunkHeader;
    require(bytes.size() >= kText, "GlbFile::of() needs a whole file");
    const size_t length = glbWord(bytes, kFileHeader), chunk = kText + length;
    GlbFile file;
    file.document = json::parse(bytes.substr(kText, length));
    if (bytes.size() >= chunk + kChunkHeader)  // none where there is nothing to put into it
        file.buffer = bytes.substr(chunk + kChunkHeader, glbWord(bytes, chunk));
    file.buffer.resize((file.buffer.size() + kWord - 1) / kWord * kWord);
    return file;
}

Result<std::string> GlbFile::bytes(const std::string& where) const {
    std::string text = document.dump();
    text.append((kWord - text.size() % kWord) % kWord, ' ');
    const size_t size = kFileHeader + 2 * kChunkHeader + text.size() + buffer.size();
    if (size > std::numeric_limits<uint32_t>::max())
        return Error{ErrorKind::kUnusable, where + ": a GLB file holds 4 GiB at most",
                     "Export fewer takes or performers into one file, or a part of the time"};
    std::string bytes = "glTF";
    bytes.reserve(size);
    for (const size_t word : {size_t{kVersion}, size, text.size()})
        addGlbWord(bytes, word);
    bytes += "JSON" + text;
    addGlbWord(bytes, buffer.size());
    bytes.append("BIN\0", kWord);
    bytes += buffer;
    return bytes;
}

void GlbFile::addScene(GlbFile other) {
    addBuffer(other);
    std::map<std::string, size_t> shift;
    for (const char* name : {"images", "samplers", "textures", "materials", "meshes", "skins", "nodes"})
        shift[name] = listOf(document, name).size();
    json& from = other.document;
    for (json& texture : listOf(from, "textures")) {
        shiftIndex(texture, "source", shift["images"]);
        shiftIndex(texture, "sampler", shift["samplers"]);
    }
    for (json& material : listOf(from, "materials"))
        shiftTextures(material, shift["textures"]);
    for (json& mesh : listOf(from, "meshes"))
        shiftMesh(mesh, 0, shift["materials"]);
    for (json& skin : listOf(from, "skins")) {
        shiftIndices(skin["joints"], shift["nodes"]);
        shiftIndex(skin, "skeleton", shift["nodes"]);
    }
    for (json& node : listOf(from, "nodes")) {
        shiftIndex(node, "mesh", shift["meshes"]);
        shiftIndex(node, "skin", shift["skins"]);
        if (node.contains("children"))
            shiftIndices(node["children"], shift["nodes"]);
    }
    for (const auto& [name, count] : shift) {
        for (json& item : listOf(from, name.c_str()))
            document[name].push_back(std::move(item));
        if (document[name].empty())
            document.erase(name);
    }
    for (const json& used : from.value("extensionsUsed", json::array()))
        if (json& known = listOf(document, "extensionsUsed"); std::ranges::find(known, used) == known.end())
            known.push_back(used);
    for (json& scene : listOf(from, "scenes"))
        for (const json& node : scene["nodes"])
            document["scenes"][0]["nodes"].push_back(node.get<size_t>() + shift["nodes"]);
    for (json& animation : listOf(from, "animations")) {
        for (json& channel : animation["channels"])
            shiftIndex(channel["target"], "node", shift["nodes"]);
        addAnimation(std::move(animation));
    }
}

void GlbFile::addAnimations(GlbFile other) {
    std::map<std::string, size_t> node_of_name;
    const json& nodes = listOf(document, "nodes");
    for (size_t n = 0; n < nodes.size(); ++n)
        node_of_name[nodes[n].value("name", "")] = n;
    addBuffer(other);
    for (json& animation : listOf(other.document, "animations")) {
        for (json& channel : animation["channels"]) {
            json& node = channel["target"]["node"];
            node = node_of_name.at(other.document["nodes"][node.get<size_t>()].value("name", ""));
        }
        listOf(document, "animations").push_back(std::move(animation));
    }
}

/// Bytes, views and accessors of `other` behind ours; its meshes, skins and animations then name them as they
/// stand here.
void GlbFile::addBuffer(GlbFile& other) {
    json &from = other.document, &views = listOf(document, "bufferViews"),
         &accessors = listOf(document, "accessors");
    const size_t first_view = views.size(), first_accessor = accessors.size();
    for (json& view : listOf(from, "bufferViews")) {
        view["byteOffset"] = view.value("byteOffset", size_t{0}) + buffer.size();
        views.push_back(std::move(view));
    }
    for (json& accessor : listOf(from, "accessors")) {
        shiftIndex(accessor, "bufferView", first_view);
        accessors.push_back(std::move(accessor));
    }
    for (json& image : listOf(from, "images"))
        shiftIndex(image, "bufferView", first_view);
    for (json& mesh : listOf(from, "meshes"))
        shiftMesh(mesh, first_accessor, 0);
    for (json& skin : listOf(from, "skins"))
        shiftIndex(skin, "inverseBindMatrices", first_accessor);
    for (json& animation : listOf(from, "animations"))
        for (json& sampler : animation["samplers"]) {
            shiftIndex(sampler, "input", first_accessor);
            shiftIndex(sampler, "output", first_accessor);
        }
    buffer += other.buffer;
    document["buffers"][0]["byteLength"] = buffer.size();
}

void GlbFile::addAnimation(json animation) {
    for (json& own : listOf(document, "animations"))
        if (own.value("name", "") == animation.value("name", "")) {
            const size_t samplers = own["samplers"].size();
            for (json& sampler : animation["samplers"])
                own["samplers"].push_back(std::move(sampler));
            for (json& channel : animation["channels"]) {
                shiftIndex(channel, "sampler", samplers);
                own["channels"].push_back(std::move(channel));
            }
            return;
        }
    document["animations"].push_back(std::move(animation));
}

}  // namespace noctule
