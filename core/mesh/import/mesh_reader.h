// SPDX-License-Identifier: Apache-2.0
// Reading meshes from outside without trusting them: a process of its own (the program noctule-read-mesh)
// reads the file under limits of memory and time and hands over plain bytes, so that a hostile file can cost
// an error message and nothing else.
#pragma once

#include <string>

#include "core/job/job.h"
#include "core/mesh/import/mesh_import.h"

namespace noctule {

struct ReadingLimits {
    unsigned seconds = 60;    ///< of time on the wall and of computing
    size_t memory_mb = 3072;  ///< address space of the reader
    size_t result_mb = 1024;  ///< of what it hands over
};

/// The program beside the one that runs.
std::string meshReaderProgram();

/// importMesh() in the reader `program`, which gets no descriptor and no variable of ours and ends with a
/// cancel. Besides its errors kUnreadable when the reader crashed or reached a limit, kInternal when it
/// cannot be started, kCancelled.
Result<RiggedMesh> importMeshApart(const std::string& path, const MeshImportSettings& settings = {},
                                   const JobContext& job = {},
                                   const std::string& program = meshReaderProgram(),
                                   const ReadingLimits& limits = {});

/// The reader itself: PATH UNIT_M SECONDS MEMORY_MB surface|motion|part (UNIT_M 0: what the file says;
/// motion: no surface is needed), bytes to standard output. Returns the exit code.
int runMeshReader(const std::vector<std::string>& arguments, TextureDecoder decode);

}  // namespace noctule
