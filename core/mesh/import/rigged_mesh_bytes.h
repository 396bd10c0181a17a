// SPDX-License-Identifier: Apache-2.0
// A RiggedMesh, or the Error instead of one, as plain bytes between two processes of the same build on the
// same machine: "NCRM", version, then counts and values in memory order (little-endian). Not a file format.
#pragma once

#include <string>
#include <string_view>

#include "core/mesh/rigged_mesh.h"

namespace noctule {

std::string toBytes(const Result<RiggedMesh>& mesh);

/// Trusts nothing: counts are compared with what is there before anything is allocated, and the mesh passes
/// checkRiggedMesh(). kUnreadable when the bytes are not what toBytes() writes; `where` names the file.
Result<RiggedMesh> meshFromBytes(std::string_view bytes, const std::string& where);

}  // namespace noctule
