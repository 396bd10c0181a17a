// SPDX-License-Identifier: Apache-2.0
// The container of glTF 2.0: JSON, buffers and accessors, from .glb, .vrm and .gltf.
//
// Why our own reader: assimp 5.2.5 applies the node transform of skinned meshes, breaks down without inverse
// bind matrices, does not decode URIs, finds bones by names that may repeat, gives one skin to all nodes that
// share a mesh, and drops the VRM extensions. Debian's tinygltf would load the JSON, but leaves accessors,
// skins and these rules to its caller, and would be one more library that trusts files. This runs in the
// reader's process (mesh_reader.h), under its limits.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/job/result.h"

namespace noctule {

/// The numbers of an accessor, element after element.
struct GltfNumbers {
    std::vector<float> values;
    size_t components = 1;  ///< per element

    size_t count() const { return values.size() / components; }
    const float* at(size_t element) const { return values.data() + element * components; }
};

/// How one number of an accessor is stored.
struct GltfComponentType {
    int code = 5126;  ///< glTF's: a float
    size_t bytes = 4;
    double largest = 1;  ///< by which normalised integers are divided
};

class GltfDocument {
public:
    /// kUnreadable: missing, damaged, without a buffer that it names, or not glTF 2; kUnusable: it demands an
    /// extension that is not known here, by name.
    static Result<GltfDocument> open(const std::string& path);

    const nlohmann::json& json() const { return json_; }
    /// Member of the top-level list, such as ("nodes", 3); null when it is not there.
    const nlohmann::json& item(const char* list, size_t index) const;
    size_t count(const char* list) const;

    /// kUnreadable, and says which accessor, when it points outside of its buffer or has another shape.
    Result<GltfNumbers> numbers(size_t accessor, size_t components) const;
    Result<std::vector<uint32_t>> indices(size_t accessor) const;
    /// The bytes of a buffer view; absent when there is no such view.
    std::optional<std::string_view> view(size_t index) const;

    Error damaged(const std::string& what) const;

private:
    struct Layout;
    Status readContainer(const std::string& bytes);
    Status checkVersion() const;
    Status readBuffers(std::string_view binary_chunk);
    Result<std::string> bufferAt(const std::string& uri) const;
    Result<Layout> layoutOf(size_t accessor) const;
    template <class Put>
    Status eachNumber(const Layout& layout, const Put& put) const;
    template <class Put>
    Status eachSparse(size_t accessor, const Layout& layout, const Put& put) const;

    std::string path_;
    nlohmann::json json_;
    std::vector<std::string> buffers_;
};

/// Members that may be missing or of another type: then absent.
std::optional<size_t> gltfIndex(const nlohmann::json& object, const char* member);
const nlohmann::json& gltfMember(const nlohmann::json& object, const char* member);

/// "percent%20uri" -> "percent uri".
std::string percentDecoded(const std::string& uri);
/// The bytes of a "data:" URI; absent when it is none.
std::optional<std::string> dataOfUri(const std::string& uri);

}  // namespace noctule
