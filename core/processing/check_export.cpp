// SPDX-License-Identifier: Apache-2.0
#include "core/processing/check_export.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include "core/film/video_file.h"
#include "core/math/rotation.h"
#include "core/processing/export_comparison.h"
#include "core/processing/export_motion.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

int64_t toNs(double s) {
    return static_cast<int64_t>(std::llround(s * 1e9));
}

/// What the file should hold: the run at the instants that were asked for.
Result<ExpectedMotion> expectedMotion(const Take& take, const ExportRequest& request, std::string& run_name) {
    const auto run = choosePoseRun(take, request.run);
    if (!run)
        return run.error();
    run_name = run->name;
    const auto motion = take.poses(run->run);
    if (!motion)
        return motion.error();
    ExpectedMotion expected;
    expected.name = request.motion_name.empty() ? take.header().name : request.motion_name;
    expected.skeleton = motion->skeleton;
    expected.root = request.root;
    expected.frame_time_s = 1 / request.frames_per_second;
    if (motion->frames.empty())
        return expected;
    const int64_t first = motion->frames.front().time_ns, last = motion->frames.back().time_ns;
    const int64_t begin = request.from_s ? toNs(*request.from_s) : first;
    const int64_t end = std::min(request.to_s ? toNs(*request.to_s) : last, last);
    PoseSampler sampler(*motion, std::numeric_limits<int64_t>::max());
    for (int64_t i = 0, time_ns = begin; time_ns <= end;
         time_ns = begin + toNs(static_cast<double>(++i) * expected.frame_time_s))
        if (auto pose = sampler.at(time_ns)) {
            if (expected.frames.empty())
                expected.begin_s = static_cast<double>(time_ns) * 1e-9;
            expected.frames.push_back(std::move(*pose));
        }
    if (locksFeet(request))
        expected.plants = footPlants(*motion, expected.begin_s);
    return expected;
}

Result<std::vector<SilentBoard>> silentBoards(const Take& take, const ExpectedMotion& expected) {
    const auto rate = take.sampleRate_hz();
    const auto gaps = take.gaps();
    const auto suit = take.suit();
    if (!rate || !gaps || !suit)
        return !rate ? rate.error() : !gaps ? gaps.error() : suit.error();
    const double end_s =
        expected.begin_s + expected.frame_time_s * (static_cast<double>(expected.frames.size()) - 1);
    std::vector<SilentBoard> silent;
    for (const GapRow& gap : *gaps) {
        const double per_second = static_cast<double>(*rate);
        SilentBoard board;
        board.board = gap.board.value_or(-1);
        if (board.board >= 0 && board.board < static_cast<int>(suit->boards.size()))
            board.segment = suit->boards[static_cast<size_t>(board.board)].segment;
        board.from_s = std::max(static_cast<double>(gap.first_sample) / per_second, expected.begin_s);
        board.to_s = std::min(static_cast<double>(gap.first_sample + gap.sample_count) / per_second, end_s);
        if (board.to_s <= board.from_s)
            continue;
        board.frames = static_cast<size_t>(std::ceil((board.to_s - board.from_s) / expected.frame_time_s));
        silent.push_back(board);
    }
    return silent;
}

void judge(ExportCheck& check, double expected_frames_per_second) {
    const auto fault = [&](bool is_fault, const std::string& sentence) {
        if (is_fault)
            check.faults.push_back(sentence);
    };
    fault(check.frames != check.expected_frames,
          "The file holds " + std::to_string(check.frames) + " frames, the take has " +
              std::to_string(check.expected_frames) + " in this range.");
    fault((!check.is_picture || check.frames > 1) &&
              std::abs(check.frames_per_second / expected_frames_per_second - 1) >
                  (check.is_picture ? 1e-3 : 1e-6),
          "The file runs at another frame rate than asked for.");
    if (check.is_picture)
        return;
    fault(check.joints != check.expected_joints, "The file names " + std::to_string(check.joints) +
                                                     " of the take's " +
                                                     std::to_string(check.expected_joints) + " joints.");
    fault(std::abs(check.height_m - check.expected_height_m) > 1e-3,
          "The figure in the file has another height than the performer.");
    fault(std::abs(std::remainder(check.facing_rad - check.expected_facing_rad, 2 * M_PI)) > radians(0.1),
          "The figure in the file faces another way than the performer.");
    fault(check.largest_angle_rad > kExportAngle_rad,
          "Joints in the file are turned otherwise than in the take.");
    fault(check.largest_position_m > check.position_limit_m,
          "Joints in the file are elsewhere than in the take.");
}

Status compareFile(const std::string& path, const ExpectedMotion& expected, const ExportRequest& request,
                   ExportCheck& check) {
    const ExportFormat format = formatOf(request, path);
    const bool is_fbx = format == ExportFormat::kFbx;
    if (format == ExportFormat::kCsv)
        return compareCsv(path, request.angles, expected, check);
    if (format == ExportFormat::kMot || format == ExportFormat::kSto)
        return compareTable(path, format == ExportFormat::kMot, expected, check);
    ExpectedMotion named = expected;
    named.skeleton = renamed(expected.skeleton, request.names);
    if (format == ExportFormat::kBvh)
        return compareBvh(path, request.metres_per_unit, named, check);
    check.position_limit_m = kExportScenePosition_m;
    const SceneFormat scene = is_fbx ? SceneFormat::kFbx : SceneFormat::kGlb;
    return request.with_body && request.worn ? compareRiggedFile(path, scene, expected, request, check)
                                             : compareSceneFile(path, scene, named, check);
}

/// Of a picture or film only what its file tells: number of frames, size and rate. `film_frames`: expected.
Status comparePicture(const std::string& path, const ExportRequest& request, size_t film_frames,
                      ExportCheck& check) {
    check.is_picture = true;
    check.expected_frames = 1;
    if (formatOf(request, path) == ExportFormat::kPng) {
        const auto picture = readPng(path);
        if (!picture)
            return picture.error();
        check.frames = 1;
        check.size = {picture->width_px, picture->height_px};
    } else {
        const auto facts = readVideo(path);
        if (!facts)
            return facts.error();
        check.frames = facts->frames;
        check.expected_frames = film_frames;
        check.frames_per_second = facts->frames_per_second;
        check.size = facts->size;
    }
    const PictureSize& wanted = request.film.size;
    if (check.size.width_px != wanted.width_px || check.size.height_px != wanted.height_px)
        check.faults.push_back("The pictures have another size than asked for.");
    return Done{};
}

/// As the film samples the run.
Result<size_t> filmFrames(const Take& take, ExportRequest request) {
    if (request.video_path.empty())
        return size_t{0};
    request.frames_per_second = request.film.frames_per_second;
    std::string run_name;
    const auto expected = expectedMotion(take, request, run_name);
    return expected ? expected->frames.size() : Result<size_t>(expected.error());
}

ExportCheck checkFile(const std::string& path, const ExpectedMotion& expected, size_t film_frames,
                      const ExportRequest& request) {
    ExportCheck check;
    check.path = path;
    check.expected_frames = expected.frames.size();
    check.expected_joints = expected.skeleton.size();
    check.position_limit_m = kExportPosition_m;
    std::error_code ignored;
    check.bytes = static_cast<int64_t>(std::filesystem::file_size(path, ignored));
    const Status compared = isPicture(formatOf(request, path))
                                ? comparePicture(path, request, film_frames, check)
                                : compareFile(path, expected, request, check);
    if (compared)
        judge(check, check.is_picture ? request.film.frames_per_second : request.frames_per_second);
    else
        check.faults.push_back(compared.error().text() + ".");
    return check;
}

}  // namespace

Result<std::vector<ExportCheck>> checkExport(const ExportRequest& request, const JobContext& job) {
    const auto take = Take::open(request.take_path);
    if (!take)
        return take.error();
    std::string run_name;
    const auto expected = expectedMotion(*take, request, run_name);
    if (!expected)
        return expected.error();
    const auto silent = silentBoards(*take, *expected);
    const auto film_frames = filmFrames(*take, request);
    if (!silent || !film_frames)
        return !silent ? silent.error() : film_frames.error();
    std::vector<ExportCheck> checks;
    const std::vector<std::string> paths = outputsOf(request);
    for (const std::string& path : paths) {
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(static_cast<double>(checks.size()) / static_cast<double>(paths.size()),
                     "Reading " + path + " again");
        checks.push_back(checkFile(path, *expected, *film_frames, request));
        checks.back().run = run_name;
        checks.back().silent = *silent;
    }
    return checks;
}

}  // namespace noctule
