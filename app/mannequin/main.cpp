// SPDX-License-Identifier: Apache-2.0
// noctule-make-mannequin OUT.glb [--height M]: writes the default body, the same bytes on every run.
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "core/body/actor.h"
#include "core/formats/glb_writer.h"
#include "core/mesh/mannequin/mannequin.h"

namespace {

struct Wish {
    std::string path;
    double height_m = 1.75;
};

std::optional<Wish> parsed(const std::vector<std::string>& words) {
    Wish wish;
    for (size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--height" && i + 1 < words.size()) {
            char* end = nullptr;
            wish.height_m = std::strtod(words[++i].c_str(), &end);
            if (*end != '\0' || !(wish.height_m >= 0.5 && wish.height_m <= 2.5))
                return std::nullopt;
        } else if (wish.path.empty() && !words[i].starts_with("-")) {
            wish.path = words[i];
        } else {
            return std::nullopt;
        }
    }
    return wish.path.empty() ? std::nullopt : std::optional(wish);
}

}  // namespace

int main(int argc, char** argv) {
    const auto wish = parsed({argv + 1, argv + argc});
    if (!wish) {
        std::fputs("usage: noctule-make-mannequin OUT.glb [--height M], M from 0.5 to 2.5 metres\n", stderr);
        return static_cast<int>(noctule::ErrorKind::kUsage);
    }
    const noctule::Actor actor = noctule::defaultActor({.height_m = wish->height_m});
    const noctule::SkinnedMesh body = noctule::makeMannequin(actor);
    const auto written = noctule::writeSkinnedMesh(wish->path, body, actor.skeleton, true);
    if (!written) {
        std::fprintf(stderr, "noctule-make-mannequin: %s\n", written.error().text().c_str());
        return static_cast<int>(written.error().kind);
    }
    std::printf("%s: %zu vertices, %zu triangles\n", wish->path.c_str(), body.vertices.size(),
                body.triangles.size());
}
