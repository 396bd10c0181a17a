// SPDX-License-Identifier: Apache-2.0
#include "core/processing/check_export.h"

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>

#include "core/estimation/ground_contacts.h"
#include "core/live/estimators.h"
#include "core/math/rotation.h"
#include "core/media/picture_file.h"
#include "core/media/video_file.h"
#include "core/processing/contacts_in_force.h"
#include "core/processing/export_comparison.h"
#include "core/processing/export_motion.h"
#include "core/processing/held_pose.h"
#include "core/processing/pose_runs.h"

namespace noctule {
namespace {

int64_t toNs(double s) {
    return static_cast<int64_t>(std::llround(s * 1e9));
}

/// What the file should hold: the run at the instants that were asked for.
Result<ExpectedMotion> expectedMotion(const Take& take, const ExportRequest& request, const DerivedRun& run) {
    const auto motion = take.poses(run.run);
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
    const int64_t to = request.to_s ? toNs(*request.to_s) : last;
    const int64_t end = request.holds_ends ? to : std::min(to, last);
    PoseSampler sampler(*motion, std::numeric_limits<int64_t>::max());
    int64_t end_ns = begin;
    for (int64_t i = 0, time_ns = begin; time_ns <= end;
         time_ns = begin + toNs(static_cast<double>(++i) * expected.frame_time_s))
        if (auto pose = request.holds_ends ? sampler.held(time_ns) : sampler.at(time_ns)) {
            if (expected.frames.empty())
                expected.begin_s = static_cast<double>(time_ns) * 1e-9;
            expected.frames.push_back(std::move(*pose));
            end_ns = time_ns;
        }
    if (const auto seen = sampler.seen(); seen && request.holds_ends)
        expected.held =
            heldInWords(request.subject, *seen, toNs(expected.begin_s), end_ns, toNs(expected.frame_time_s));
    if (!request.with_body || !request.worn)
        return expected;
    const auto contacts = contactsInForce(take, run, *motion);
    if (!contacts)
        return contacts.error();
    expected.plants = footPlants(contacts->feet, expected.begin_s);
    expected.feet_at_rest = feetAtRest(*motion, contacts->feet);
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

/// FBX or GLB.
Status compareScene(const SceneFile& scene, const ExpectedMotion& expected, const ExportRequest& request,
                    ExportCheck& check) {
    check.position_limit_m = kExportScenePosition_m;
    if (request.with_body && request.worn)
        return compareRiggedFile(scene, expected, request, check);
    ExpectedMotion named = expected;
    named.skeleton = renamed(expected.skeleton, request.names);
    if (!request.character.empty())
        named.skeleton = skeletonOfCharacter(named.skeleton, request.character);
    return compareSceneFile(scene, named, check);
}

Status compareFile(const std::string& path, const ExpectedMotion& expected, const ExportRequest& request,
                   ExportCheck& check) {
    const ExportFormat format = formatOf(request, path);
    if (format == ExportFormat::kCsv)
        return compareCsv(path, request.angles, expected, check);
    if (format == ExportFormat::kMot || format == ExportFormat::kSto)
        return compareTable(path, format == ExportFormat::kMot, expected, check);
    if (format == ExportFormat::kBvh) {
        ExpectedMotion named = expected;
        named.skeleton = renamed(expected.skeleton, request.names);
        return compareBvh(path, request.metres_per_unit, named, check);
    }
    const auto scene =
        SceneFile::open(path, path, format == ExportFormat::kFbx ? SceneFormat::kFbx : SceneFormat::kGlb);
    return scene ? compareScene(*scene, expected, request, check) : Status(scene.error());
}

/// Of a picture or film only what its file tells: number of frames, size and rate. `film_frames`: expected.
Status comparePicture(const std::string& path, const ExportRequest& request, size_t film_frames,
                      ExportCheck& check) {
    check.is_picture = true;
    check.expected_frames = 1;
    if (formatOf(request, path) == ExportFormat::kPng) {
        const auto picture = readPicture(path);
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
Result<size_t> filmFrames(const Take& take, ExportRequest request, const DerivedRun& run) {
    if (request.video_path.empty())
        return size_t{0};
    request.frames_per_second = request.film.frames_per_second;
    const auto expected = expectedMotion(take, request, run);
    return expected ? expected->frames.size() : Result<size_t>(expected.error());
}

/// What files of a request are held against.
struct CheckedTake {
    std::string run;
    HeldBy held_by = HeldBy::kLevelFloor;
    ExpectedMotion expected;
    std::vector<SilentBoard> silent;
    size_t film_frames = 0;
};

Result<CheckedTake> checkedTake(const ExportRequest& request) {
    auto take = Take::open(request.take_path);
    if (!take)
        return take.error();
    if (request.suit)
        take->view(*request.suit);
    CheckedTake checked;
    const auto run = choosePoseRun(*take, request.run);
    if (!run)
        return run.error();
    checked.run = run->name;
    checked.held_by = heldBy(*run);
    auto expected = expectedMotion(*take, request, *run);
    if (!expected)
        return expected.error();
    auto silent = silentBoards(*take, *expected);
    const auto film_frames = filmFrames(*take, request, *run);
    if (!silent || !film_frames)
        return !silent ? silent.error() : film_frames.error();
    checked.expected = std::move(*expected);
    checked.silent = std::move(*silent);
    checked.film_frames = *film_frames;
    return checked;
}

/// `compare` reads the file and fills in what it holds.
ExportCheck checkFile(const std::string& path, const CheckedTake& take, const ExportRequest& request,
                      const std::function<Status(ExportCheck&)>& compare) {
    ExportCheck check;
    check.path = path;
    check.run = take.run;
    check.held_by = take.held_by;
    check.silent = take.silent;
    check.held = take.expected.held;
    check.expected_frames = take.expected.frames.size();
    check.expected_joints = take.expected.skeleton.size();
    check.position_limit_m = kExportPosition_m;
    std::error_code ignored;
    check.bytes = static_cast<int64_t>(std::filesystem::file_size(path, ignored));
    if (const Status compared = compare(check); compared)
        judge(check, check.is_picture ? request.film.frames_per_second : request.frames_per_second);
    else
        check.faults.push_back(compared.error().text() + ".");
    return check;
}

}  // namespace

HeldBy heldBy(const DerivedRun& pose_run) {
    const RunSettings settings = runSettings(pose_run, {}, TakeLevel::kSignal);
    const EstimatorEntry* estimator = findEstimator(settings.estimator);
    if (!estimator || settings.root_given)
        return HeldBy::kOtherSystem;
    if (settings.estimator == kOrientationEstimator)
        return HeldBy::kLevelFloor;  // it knows no other ground
    if (settings.uses_room)
        return HeldBy::kRoom;
    if (!estimator->finds_contacts)
        return HeldBy::kNothing;
    switch (groundFromName(settings.ground).value_or(Ground::kNone)) {
        case Ground::kLevel:
            return HeldBy::kLevelFloor;
        case Ground::kUneven:
            return HeldBy::kUnevenGround;
        case Ground::kTreadmill:
            return HeldBy::kTreadmill;
        case Ground::kNone:
            break;
    }
    return HeldBy::kNothing;
}

FloorRemedy ExportCheck::floorRemedy() const {
    if (!has_figure || lowest_m >= -kOnFloor_m)
        return FloorRemedy::kNone;
    if (held_by == HeldBy::kNothing)
        return FloorRemedy::kHoldFeet;
    if (held_by == HeldBy::kUnevenGround)
        return FloorRemedy::kLevelGround;
    if (usual_lowest_m >= -kOnFloor_m)
        return FloorRemedy::kNone;
    return held_by == HeldBy::kRoom          ? FloorRemedy::kRoom
           : held_by == HeldBy::kOtherSystem ? FloorRemedy::kOtherSystem
                                             : FloorRemedy::kMoveUp;
}

Result<std::vector<ExportCheck>> checkExport(const ExportRequest& request, const JobContext& job) {
    const auto take = checkedTake(request);
    if (!take)
        return take.error();
    std::vector<ExportCheck> checks;
    const std::vector<std::string> paths = outputsOf(request);
    for (const std::string& path : paths) {
        if (job.cancelled())
            return JobContext::cancelledError();
        job.progress(static_cast<double>(checks.size()) / static_cast<double>(paths.size()),
                     "Reading " + path + " again");
        checks.push_back(checkFile(path, *take, request, [&](ExportCheck& check) {
            return isPicture(formatOf(request, path))
                       ? comparePicture(path, request, take->film_frames, check)
                       : compareFile(path, take->expected, request, check);
        }));
    }
    return checks;
}

Result<std::vector<ExportCheck>> checkStacks(const std::vector<ExportRequest>& takes, const JobContext& job) {
    require(!takes.empty(), "checkStacks() needs a take");
    const std::string path = outputsOf(takes.front()).front();
    job.progress(0, "Reading " + path + " again");
    const bool is_fbx = formatOf(takes.front(), path) == ExportFormat::kFbx;
    const auto scene = SceneFile::open(path, path, is_fbx ? SceneFormat::kFbx : SceneFormat::kGlb);
    std::vector<ExportCheck> checks;
    for (const ExportRequest& request : takes) {
        if (job.cancelled())
            return JobContext::cancelledError();
        const auto take = checkedTake(request);
        if (!take)
            return take.error();
        checks.push_back(checkFile(path, *take, request, [&](ExportCheck& check) {
            return scene ? compareScene(*scene, take->expected, request, check) : Status(scene.error());
        }));
        job.progress(static_cast<double>(checks.size()) / static_cast<double>(takes.size()), "Comparing");
    }
    return checks;
}

}  // namespace noctule
