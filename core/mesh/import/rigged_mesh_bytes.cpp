// SPDX-License-Identifier: Apache-2.0
#include "core/mesh/import/rigged_mesh_bytes.h"

#include <cstring>

namespace noctule {
namespace {

constexpr std::string_view kMeshMagic = "NCRM", kErrorMagic = "NCRE";
constexpr uint32_t kBytesVersion = 4;

template <class Archive, class... Values>
void each(Archive& archive, Values&... values) {
    (archive(values), ...);
}

/// One list of fields for both directions: `archive(value)` writes or reads it.
template <class Archive>
void fields(Archive& archive, RigNode& node) {
    each(archive, node.name, node.parent, node.T_parent_node.matrix(), node.T_world_rest.matrix());
}

template <class Archive>
void fields(Archive& archive, SkinnedVertex& vertex) {
    each(archive, vertex.p_m, vertex.normal, vertex.bones, vertex.weights, vertex.uv);
}

template <class Archive>
void fields(Archive& archive, std::shared_ptr<const SurfaceTexture>& texture) {
    SurfaceTexture told = texture ? *texture : SurfaceTexture();
    each(archive, told.file, told.width_px, told.height_px, told.rgba);
    texture = std::make_shared<const SurfaceTexture>(std::move(told));
}

/// SkinnedMesh::surface with each texture once, however many parts share it.
struct SurfaceBytes {
    static constexpr int32_t kNone = -1;
    struct Part {
        uint32_t first_triangle = 0, triangles = 0;
        uint8_t has_look = 0;
        Eigen::Vector3f base_color = Eigen::Vector3f::Zero();
        int32_t texture = kNone;
    };
    std::vector<std::shared_ptr<const SurfaceTexture>> textures;
    std::vector<Part> parts;

    SurfaceBytes() = default;
    explicit SurfaceBytes(const std::vector<SurfacePart>& surface) : textures(texturesOf(surface)) {
        for (const SurfacePart& part : surface) {
            const auto texture = textureIndex(part, textures);
            parts.push_back({part.first_triangle, part.triangles, part.look.has_value(),
                             part.look.value_or(SurfaceLook()).base_color,
                             texture ? static_cast<int32_t>(*texture) : kNone});
        }
    }

    /// Nothing when a part names a texture that is not there.
    std::optional<std::vector<SurfacePart>> surface() const {
        std::vector<SurfacePart> surface;
        for (const Part& part : parts) {
            if (part.texture < kNone || part.texture >= static_cast<int64_t>(textures.size()))
                return std::nullopt;
            SurfacePart& read = surface.emplace_back(SurfacePart{part.first_triangle, part.triangles});
            if (part.has_look)
                read.look = SurfaceLook{part.base_color, part.texture == kNone
                                                             ? nullptr
                                                             : textures[static_cast<size_t>(part.texture)]};
        }
        return surface;
    }
};

template <class Archive>
void fields(Archive& archive, SurfaceBytes::Part& part) {
    each(archive, part.first_triangle, part.triangles, part.has_look, part.base_color, part.texture);
}

template <class Archive>
void fields(Archive& archive, SurfaceBytes& surface) {
    each(archive, surface.textures, surface.parts);
}

template <class Archive>
void fields(Archive& archive, SkinBone& bone) {
    each(archive, bone.joint, bone.bind_inverse);
}

template <class Archive>
void fields(Archive& archive, MeshPart& part) {
    each(archive, part.name, part.first_triangle, part.triangles);
}

template <class Archive>
void fields(Archive& archive, Quaterniond& q) {
    archive(q.coeffs());
}

template <class Archive>
void fields(Archive& archive, RigTrack& track) {
    each(archive, track.node, track.t_s, track.p_m, track.q_parent_node, track.scale);
}

template <class Archive>
void fields(Archive& archive, RigClip& clip) {
    each(archive, clip.name, clip.duration_s, clip.tracks);
}

template <class Archive>
void fields(Archive& archive, RiggedMesh& mesh, SurfaceBytes& surface) {
    each(archive, mesh.nodes, mesh.skin.vertices, mesh.skin.triangles, mesh.skin.bones, surface,
         mesh.node_of_bone, mesh.parts, mesh.clips, mesh.humanoid);
}

template <class T, class Archive>
concept HasFields = requires(Archive& archive, T& value) {
    fields(archive, value);
};

class Writer {
public:
    template <class T>
    requires std::is_arithmetic_v<T>
    void operator()(const T& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
    template <class Derived>
    void operator()(const Eigen::MatrixBase<Derived>& values) {
        for (Eigen::Index i = 0; i < values.size(); ++i)
            (*this)(values.derived().data()[i]);
    }
    template <class T, size_t N>
    void operator()(const std::array<T, N>& values) {
        for (const T& value : values)
            (*this)(value);
    }
    void operator()(const std::string& text) {
        (*this)(static_cast<uint64_t>(text.size()));
        bytes += text;
    }
    template <class T>
    void operator()(std::vector<T>& values) {
        (*this)(static_cast<uint64_t>(values.size()));
        for (T& value : values)
            (*this)(value);
    }
    void operator()(const std::map<std::string, std::string>& texts) {
        (*this)(static_cast<uint64_t>(texts.size()));
        for (const auto& [key, text] : texts) {
            (*this)(key);
            (*this)(text);
        }
    }
    template <HasFields<Writer> T>
    void operator()(T& value) {
        fields(*this, value);
    }

    std::string bytes;
};

/// After the first trouble it reads nothing any more and makes nothing larger.
class Reader {
public:
    explicit Reader(std::string_view bytes) : left_(bytes) {}

    template <class T>
    requires std::is_arithmetic_v<T>
    void operator()(T& value) {
        if (sizeof value > left_.size())
            return fail();
        std::memcpy(&value, left_.data(), sizeof value);
        left_.remove_prefix(sizeof value);
    }
    template <class Derived>
    void operator()(Eigen::MatrixBase<Derived>& values) {
        for (Eigen::Index i = 0; i < values.size(); ++i)
            (*this)(values.derived().data()[i]);
    }
    template <class T, size_t N>
    void operator()(std::array<T, N>& values) {
        for (T& value : values)
            (*this)(value);
    }
    void operator()(std::string& text) {
        const size_t size = count();
        text = left_.substr(0, size);
        left_.remove_prefix(size);
    }
    template <class T>
    void operator()(std::vector<T>& values) {
        const size_t size = count();
        for (size_t i = 0; i < size && ok_; ++i)
            (*this)(values.emplace_back());
    }
    void operator()(std::map<std::string, std::string>& texts) {
        const size_t size = count();
        for (size_t i = 0; i < size && ok_; ++i) {
            std::string key, text;
            (*this)(key);
            (*this)(text);
            texts[std::move(key)] = std::move(text);
        }
    }
    template <HasFields<Reader> T>
    void operator()(T& value) {
        fields(*this, value);
    }

    bool finished() const { return ok_ && left_.empty(); }

private:
    /// Every element takes at least one byte, so no count can exceed what is left.
    size_t count() {
        uint64_t size = 0;
        (*this)(size);
        if (size > left_.size())
            fail();
        return ok_ ? static_cast<size_t>(size) : 0;
    }
    void fail() {
        ok_ = false;
        left_ = {};
    }

    std::string_view left_;
    bool ok_ = true;
};

Error brokenBytes(const std::string& where) {
    return {ErrorKind::kUnreadable, where + ": reading it broke off",
            "Export the mesh again, best as binary glTF (.glb)"};
}

Result<RiggedMesh> errorFromBytes(Reader& reader, const std::string& where) {
    int32_t kind = 0;
    Error error;
    reader(kind);
    reader(error.message);
    reader(error.remedy);
    if (!reader.finished() || (kind != static_cast<int32_t>(ErrorKind::kUnreadable) &&
                               kind != static_cast<int32_t>(ErrorKind::kUnusable)))
        return brokenBytes(where);
    error.kind = static_cast<ErrorKind>(kind);
    return error;
}

}  // namespace

std::string toBytes(const Result<RiggedMesh>& mesh) {
    Writer writer;
    writer.bytes = mesh ? kMeshMagic : kErrorMagic;
    writer(kBytesVersion);
    if (mesh) {
        RiggedMesh copy = *mesh;  // the fields are listed once, for writing and reading
        SurfaceBytes surface(mesh->skin.surface);
        fields(writer, copy, surface);
    } else {
        writer(static_cast<int32_t>(mesh.error().kind));
        writer(mesh.error().message);
        writer(mesh.error().remedy);
    }
    return std::move(writer.bytes);
}

Result<RiggedMesh> meshFromBytes(std::string_view bytes, const std::string& where) {
    const std::string_view magic = bytes.substr(0, kMeshMagic.size());
    if (magic != kMeshMagic && magic != kErrorMagic)
        return brokenBytes(where);
    Reader reader(bytes.substr(magic.size()));
    uint32_t version = 0;
    reader(version);
    if (version != kBytesVersion)
        return brokenBytes(where);
    if (magic == kErrorMagic)
        return errorFromBytes(reader, where);
    RiggedMesh mesh;
    SurfaceBytes surface_bytes;
    fields(reader, mesh, surface_bytes);
    auto surface = surface_bytes.surface();
    if (!reader.finished() || !surface)
        return brokenBytes(where);
    mesh.skin.surface = std::move(*surface);
    if (const Status checked = checkRiggedMesh(mesh, where); !checked)
        return checked.error();
    return mesh;
}

}  // namespace noctule
