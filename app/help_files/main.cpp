// SPDX-License-Identifier: Apache-2.0
// noctule-write-help FOLDER: writes manual pages and completion for shells; a step of the build.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/help_files/completion.h"
#include "app/help_files/manual_page.h"

namespace {

bool wrote(const std::filesystem::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary);
    file << text;
    file.close();
    if (!file)
        std::fprintf(stderr, "noctule-write-help: %s cannot be written\n", path.c_str());
    return file.good();
}

}  // namespace

int main(int argc, char** argv) {
    using namespace noctule::help_files;
    if (argc != 2) {
        std::fputs("usage: noctule-write-help FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::error_code ignored;  // the first file that cannot be written tells
    std::filesystem::create_directories(folder, ignored);
    const bool done = wrote(folder / "noctule.1", noctuleManual()) &&
                      wrote(folder / "noctule-virtual-suit.1", virtualSuitManual()) &&
                      wrote(folder / "noctule-virtual-robot.1", virtualRobotManual()) &&
                      wrote(folder / "noctule.bash", bashCompletion()) &&
                      wrote(folder / "_noctule", zshCompletion());
    return done ? 0 : 6;
}
