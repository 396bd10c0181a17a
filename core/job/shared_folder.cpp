// SPDX-License-Identifier: Apache-2.0
#include "core/job/shared_folder.h"

#include <filesystem>

namespace noctule {

std::string sharedPath(const std::string& name) {
    std::error_code ignored;
    const std::filesystem::path folder =
        std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path installed = (folder / NOCTULE_SHARE_FROM_BIN / name).lexically_normal();
    const bool is_installed =
        !std::filesystem::exists(folder / name, ignored) && std::filesystem::exists(installed, ignored);
    return (is_installed ? installed : folder / name).string();
}

}  // namespace noctule
