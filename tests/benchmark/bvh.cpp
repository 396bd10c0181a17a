// SPDX-License-Identifier: Apache-2.0
// Our BVH reader against assimp's on the same files in the same run: time from Google Benchmark, then the
// ratio of the medians and the peak memory of one import. Memory is the growth of the resident set of a child
// process that does nothing else, so that allocations within libassimp.so count as well.
#include "core/formats/bvh.h"

#include <benchmark/benchmark.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

const char* const kFiles[] = {"/usr/share/assimp/models/BVH/Boxing_Toes.bvh",
                              "/usr/share/assimp/models/BVH/01_03.bvh"};

bool readOurs(const std::string& path) {
    const noctule::Result<noctule::BvhDocument> document = noctule::readBvh(path);
    benchmark::DoNotOptimize(document);
    return document.ok();
}

bool readOursToClip(const std::string& path) {
    const noctule::Result<noctule::BvhDocument> document = noctule::readBvh(path);
    const bool ok = document.ok() && noctule::toClip(*document).ok();
    benchmark::DoNotOptimize(ok);
    return ok;
}

bool readAssimp(const std::string& path) {
    Assimp::Importer importer;
    return importer.ReadFile(path, 0) != nullptr;
}

using Reader = bool (*)(const std::string&);

void benchmarkReader(benchmark::State& state, Reader reader, const std::string& path) {
    for (auto _ : state)
        if (!reader(path))
            state.SkipWithError("cannot be read");
    state.SetBytesProcessed(state.iterations() * static_cast<int64_t>(std::filesystem::file_size(path)));
}

double medianSeconds(Reader reader, const std::string& path) {
    std::vector<double> seconds;
    for (int n = 0; n < 9; ++n) {
        const auto begin = std::chrono::steady_clock::now();
        reader(path);
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + 4, seconds.end());
    return seconds[4];
}

/// A line such as "VmHWM:   1234 kB" of this process; 0 when absent.
long statusKilobytes(const char* label) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(label, 0) == 0)
            return std::atol(line.c_str() + std::strlen(label));
    return 0;
}

/// Peak growth of the resident set over one import in a fresh child, in kB.
long peakKilobytes(Reader reader, const std::string& path) {
    int ends[2];
    if (pipe(ends) != 0)
        return -1;
    const pid_t child = fork();
    if (child == 0) {
        std::ofstream("/proc/self/clear_refs") << "5";  // resets VmHWM
        const long before = statusKilobytes("VmRSS:");
        reader(path);
        const long growth = statusKilobytes("VmHWM:") - before;
        const bool told = write(ends[1], &growth, sizeof growth) == sizeof growth;
        _exit(told ? 0 : 1);
    }
    close(ends[1]);
    long growth = -1;
    if (read(ends[0], &growth, sizeof growth) != sizeof growth)
        growth = -1;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return growth;
}

}  // namespace

int main(int argc, char** argv) {
    struct Memory {
        long ours_kb, assimp_kb;
    };
    std::vector<Memory> memory;  // first of all, while the heap holds nothing that an import could reuse
    std::vector<std::string> files;
    for (const char* path : kFiles)
        if (std::filesystem::exists(path)) {
            files.push_back(path);
            memory.push_back({peakKilobytes(readOurs, path), peakKilobytes(readAssimp, path)});
        } else {
            std::printf("%s is missing; install assimp-testmodels\n", path);
        }
    for (const std::string& path : files) {
        const std::string name = std::filesystem::path(path).stem().string();
        benchmark::RegisterBenchmark(("noctule/" + name).c_str(), benchmarkReader, readOurs, path)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("noctule_to_clip/" + name).c_str(), benchmarkReader, readOursToClip,
                                     path)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("assimp/" + name).c_str(), benchmarkReader, readAssimp, path)
            ->Unit(benchmark::kMillisecond);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    std::printf("\n%-12s %12s %14s %12s %8s %8s %12s %12s %8s\n", "file", "noctule ms", "with clip ms",
                "assimp ms", "ratio", "(clip)", "noctule kB", "assimp kB", "ratio");
    for (size_t f = 0; f < files.size(); ++f) {
        const double ours = medianSeconds(readOurs, files[f]), clip = medianSeconds(readOursToClip, files[f]),
                     assimp = medianSeconds(readAssimp, files[f]);
        std::printf("%-12s %12.2f %14.2f %12.2f %8.2f %8.2f %12ld %12ld %8.2f\n",
                    std::filesystem::path(files[f]).stem().c_str(), 1e3 * ours, 1e3 * clip, 1e3 * assimp,
                    assimp / ours, assimp / clip, memory[f].ours_kb, memory[f].assimp_kb,
                    static_cast<double>(memory[f].assimp_kb) / static_cast<double>(memory[f].ours_kb));
    }
}
