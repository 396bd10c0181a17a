// SPDX-License-Identifier: Apache-2.0
// A processed take as animation files, pictures and films.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/film/film.h"
#include "core/formats/figure.h"
#include "core/job/job.h"
#include "core/mesh/rig/wearable.h"
#include "core/motion/clip.h"

namespace noctule {

/// What happens to the motion of the root.
enum class RootMotion {
    kMoving,   ///< as captured
    kInPlace,  ///< stays over the spot of the first frame; up and down and turning remain
    kHeading,  ///< in place, and turning about the vertical is taken out too: always faces forward (+Z)
};

/// Settings store them by number.
enum class ExportFormat { kBvh, kCsv, kFbx, kGlb, kMot, kSto, kPng, kVideo };

struct ExportRequest {
    std::string take_path;
    std::string run;          ///< empty: the last pose run
    std::optional<int> suit;  ///< whose poses, by the subject's first suit; none: the first subject's
    double frames_per_second = 120;
    std::optional<double> from_s, to_s;  ///< of the take's clock; the first frame stands at from_s
    /// From from_s to to_s, whether there are poses or not: before the first one stands that, after the last
    /// one that (held_pose.h). For files of several people, which begin and end together.
    bool holds_ends = false;
    std::string subject;  ///< whose poses, in words
    RootMotion root = RootMotion::kMoving;
    std::string bvh_path, fbx_path, glb_path, csv_path, mot_path, sto_path, png_path,
        video_path;                       ///< empty: none
    double metres_per_unit = 0.01;        ///< of BVH and FBX files
    JointNames names = JointNames::kOwn;  ///< in BVH, FBX and GLB files
    std::string root_name = "Reference";  ///< FBX: the node above the hips
    std::string motion_name;              ///< FBX and GLB: of the animation; empty: the take's own name
    std::string character;                ///< FBX: whose, among several of the file; empty: the only one
    bool with_body = true;                ///< FBX and GLB: with skin, not the skeleton alone
    /// The body of FBX, GLB, picture and film; null: the default body in the performer's measures.
    std::shared_ptr<const WearableBody> worn;
    bool lock_feet =
        true;  ///< of `worn`: feet that stand keep their place (mesh/foot_lock.h), by contactsInForce()
    FilmSettings film;    ///< of picture and film; a picture shows from_s, without it the middle
    bool angles = false;  ///< named degrees of freedom in the CSV file too
    bool overwrite = false;

    bool operator==(const ExportRequest&) const = default;
};

struct ExportSummary {
    std::string run;
    size_t frames = 0;       ///< of files of motion
    size_t film_frames = 0;  ///< of a film
    double duration_s = 0;
    std::vector<std::string> files;
    double begin_s = 0;               ///< of the take's clock: time 0 of the files
    std::vector<std::string> held{};  ///< whole sentences: who holds a pose where none was captured
};

/// One format: its name on the command line, the ending of its files, and where its path stands.
struct ExportFormatEntry {
    ExportFormat format;
    const char *option, *extension;
    std::string ExportRequest::*path;
};
/// In the order in which files are written.
const std::vector<ExportFormatEntry>& exportFormats();
const ExportFormatEntry& entryOf(ExportFormat format);
/// Pictures: made from the motion, but no motion can be read from them.
bool isPicture(ExportFormat format);
/// FBX, GLB and pictures.
bool showsBody(ExportFormat format);
/// FBX and GLB: several takes or performers in one file.
bool holdsSeveral(ExportFormat format);
/// Of a request's output; it must be one.
ExportFormat formatOf(const ExportRequest& request, const std::string& path);

/// The files that a request asks for.
std::vector<std::string> outputsOf(const ExportRequest& request);

/// Every file is written aside, read back where that is possible, and renamed.
Result<ExportSummary> exportTake(const ExportRequest& request, const JobContext& job);

/// Several takes in one file: the first of outputsOf() the first request, which holdsSeveral(). Each is a
/// stack (in glTF an animation) under its motion's name, on the body of the first. Or the performers of one
/// take, each a character of its own (requestsTogether()). The requests differ in take, run, part, name and
/// performer alone. Of the summary, frames and duration are sums, of performers those of one; `run` is that
/// of the last. kUnusable, and says of which, when a take's bones are longer or shorter, or two motions have
/// one name. Motions are read one after the other, twice; what is held is the file and one of them
/// (writeFbx(), writeGlb()). A cancel leaves no file.
Result<ExportSummary> exportStacks(const std::vector<ExportRequest>& takes, const JobContext& job);

}  // namespace noctule
