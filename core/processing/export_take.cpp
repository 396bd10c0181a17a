// SPDX-License-Identifier: Apache-2.0
#include "core/processing/export_take.h"

#include <algorithm>
#include <iterator>

#include "core/formats/fbx_writer.h"
#include "core/formats/glb_writer.h"
#include "core/job/atomic_file.h"
#include "core/job/staged_progress.h"
#include "core/processing/export_files.h"

namespace noctule {
const std::vector<ExportFormatEntry>& exportFormats() {
    static const std::vector<ExportFormatEntry> formats{
        {ExportFormat::kBvh, "bvh", "bvh", &ExportRequest::bvh_path},
        {ExportFormat::kFbx, "fbx", "fbx", &ExportRequest::fbx_path},
        {ExportFormat::kGlb, "glb", "glb", &ExportRequest::glb_path},
        {ExportFormat::kCsv, "csv", "csv", &ExportRequest::csv_path},
        {ExportFormat::kMot, "mot", "mot", &ExportRequest::mot_path},
        {ExportFormat::kSto, "sto", "sto", &ExportRequest::sto_path},
        {ExportFormat::kPng, "png", "png", &ExportRequest::png_path},
        {ExportFormat::kVideo, "video", "mp4", &ExportRequest::video_path}};
    return formats;
}

const ExportFormatEntry& entryOf(ExportFormat format) {
    const auto& formats = exportFormats();
    return *std::find_if(formats.begin(), formats.end(),
                         [&](const ExportFormatEntry& entry) { return entry.format == format; });
}

bool isPicture(ExportFormat format) {
    return format == ExportFormat::kPng || format == ExportFormat::kVideo;
}

bool showsBody(ExportFormat format) {
    return format == ExportFormat::kFbx || format == ExportFormat::kGlb || isPicture(format);
}

bool holdsSeveral(ExportFormat format) {
    return format == ExportFormat::kFbx || format == ExportFormat::kGlb;
}

ExportFormat formatOf(const ExportRequest& request, const std::string& path) {
    const auto& formats = exportFormats();
    const auto found = std::find_if(formats.begin(), formats.end(), [&](const ExportFormatEntry& entry) {
        return request.*entry.path == path;
    });
    require(found != formats.end(), "formatOf() needs one of the request's outputs");
    return found->format;
}

std::vector<std::string> outputsOf(const ExportRequest& request) {
    std::vector<std::string> paths;
    for (const ExportFormatEntry& entry : exportFormats())
        if (!(request.*entry.path).empty())
            paths.push_back(request.*entry.path);
    return paths;
}

Result<ExportSummary> exportTake(const ExportRequest& request, const JobContext& job) {
    for (const std::string& path : outputsOf(request)) {
        if (Status free = checkOutputPath(path, request.overwrite); !free)
            return free.error();
        removeAbandoned(path);
    }
    job.progress(0, "Reading poses");
    const auto exported = exportedMotion(request);
    if (!exported)
        return exported.error();
    const MotionClip& clip = exported->clip;
    ExportSummary summary{
        exported->run,     clip.frames.size(), exported->filmed.frames.size(), clip.duration_s(), {},
        exported->begin_s, exported->held};
    const auto writers = exportWriters(request, *exported);
    const double step = 0.7 / static_cast<double>(writers.size());
    for (const ExportWriter& writer : writers) {
        if (job.cancelled())
            return JobContext::cancelledError();
        const double done = 0.3 + step * static_cast<double>(summary.files.size());
        StagedProgress part(job, done, done + step);
        part.job().progress(0, "Writing");
        if (Status written = writer.write(part.job()); !written)
            return written.error();
        summary.files.push_back(writer.path);
    }
    job.progress(1, "Done");
    return summary;
}

namespace {

/// The motions of several takes, each read when its turn comes and forgotten after it. Counts them once.
class StackedTakes {
public:
    StackedTakes(const std::vector<ExportRequest>& takes, const JobContext& job) : takes_(takes), job_(job) {}

    Status visit(const FigureVisit& visitor) {
        for (size_t i = 0; i < takes_.size(); ++i) {
            if (job_.cancelled())
                return JobContext::cancelledError();
            const bool is_first_round = done_ < takes_.size();
            job_.progress(static_cast<double>(done_) / static_cast<double>(2 * takes_.size()),
                          is_first_round ? "Writing" : "Checking");
            auto figure = figureAt(i, is_first_round);
            if (!figure)
                return figure.error();
            if (Status visited = visitor(*figure); !visited)
                return visited;
            ++done_;
        }
        return Done{};
    }
    const ExportSummary& summary() const { return summary_; }

private:
    Result<Figure> figureAt(size_t take, bool is_first_round) {
        const auto exported = exportedMotion(takes_[take]);
        if (!exported)
            return exported.error();
        if (is_first_round) {
            const bool is_same_time = take > 0 && !takes_[take].character.empty();
            summary_.run = exported->run;
            std::ranges::copy(exported->held, std::back_inserter(summary_.held));
            summary_.frames += is_same_time ? 0 : exported->clip.frames.size();
            summary_.duration_s += is_same_time ? 0 : exported->clip.duration_s();
        }
        auto figure = figureOf(takes_[take], *exported);
        if (figure && take > 0 && takes_[take].character.empty())
            figure->body.reset();  // that of the first is written
        return figure;
    }

    const std::vector<ExportRequest>& takes_;
    const JobContext& job_;
    size_t done_ = 0;  ///< of both rounds: what is written is read again to be compared
    ExportSummary summary_;
};

}  // namespace

Result<ExportSummary> exportStacks(const std::vector<ExportRequest>& takes, const JobContext& job) {
    require(!takes.empty(), "exportStacks() needs a take");
    const ExportRequest& first = takes.front();
    const std::string path = outputsOf(first).front();
    const ExportFormat format = formatOf(first, path);
    require(holdsSeveral(format), "exportStacks() needs a file that holds several");
    if (Status free = checkOutputPath(path, first.overwrite); !free)
        return free.error();
    removeAbandoned(path);
    StackedTakes stacked(takes, job);
    const FigureSource figures = [&](const FigureVisit& visitor) { return stacked.visit(visitor); };
    const Status written =
        format == ExportFormat::kFbx
            ? writeFbx(path, figures, {first.metres_per_unit, first.root_name}, first.overwrite, job)
            : writeGlb(path, figures, first.overwrite, job);
    if (!written)
        return written.error();
    ExportSummary summary = stacked.summary();
    summary.files.push_back(path);
    job.progress(1, "Done");
    return summary;
}

}  // namespace noctule
