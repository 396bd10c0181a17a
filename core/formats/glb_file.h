// SPDX-License-Identifier: Apache-2.0
// The container of binary glTF 2.0 as our exporter writes it: a JSON document and one buffer. Two files
// become one: what the second holds follows what the first holds, and its indices are shifted.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/job/result.h"

namespace noctule {

struct GlbFile {
    nlohmann::json document;
    std::string buffer;  ///< whole words

    /// Of a whole file with one buffer; files of other programs go through GltfDocument.
    static GlbFile of(std::string_view bytes);
    /// kUnusable beyond the 4 GiB that the container can count; `where` names the file.
    Result<std::string> bytes(const std::string& where) const;

    /// Everything of `other` beside what is here: nodes, skins, materials. Animations of one name become one.
    void addScene(GlbFile other);
    /// The animations of `other` alone; they move the nodes that have the same names here.
    void addAnimations(GlbFile other);

private:
    void addBuffer(GlbFile& other);
    void addAnimation(nlohmann::json animation);
};

}  // namespace noctule
