// SPDX-License-Identifier: Apache-2.0
// noctule-read-mesh: reads one mesh for the studio and the command line, which start it; not for people.
#include <cstdio>

#include "core/film/texture_decoder.h"
#include "core/mesh/import/mesh_reader.h"

int main(int argc, char** argv) {
    const int code = noctule::runMeshReader({argv + 1, argv + argc}, noctule::decodeTexture);
    if (code == static_cast<int>(noctule::ErrorKind::kUsage))
        std::fputs("noctule-read-mesh reads meshes for noctule, which starts it by itself\n", stderr);
    return code;
}
