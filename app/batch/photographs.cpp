// SPDX-License-Identifier: Apache-2.0
#include "app/batch/photographs.h"

#include "app/batch/files.h"
#include "core/job/atomic_file.h"
#include "core/suit/default_suit.h"
#include "core/vision/marker_sheet.h"

namespace noctule::batch {
namespace {

constexpr double kMetresPerMm = 1e-3;

/// SHEET.svg, SHEET_2.svg, SHEET_3.svg
std::string pagePath(const std::string& sheet, size_t page) {
    if (page == 0)
        return sheet;
    const std::string ending = sheet.ends_with(".svg") ? ".svg" : "";
    return sheet.substr(0, sheet.size() - ending.size()) + "_" + std::to_string(page + 1) + ending;
}

}  // namespace

std::vector<Option> photographOptions() {
    return {
        inputFiles("photos", "IMG...", "photographs of the jig with printed markers, named PLACEMENT_*.jpg"),
        number("marker-mm", "N", kSmallestMarker_mm, kLargestMarker_mm,
               "side of the markers' black squares, measured on the paper")
            .orElse("40"),
        text("print-markers", "SHEET.svg",
             "write the markers to be printed and nothing else: neither takes nor --out"),
        inputFile("suit", "S.json",
                  "the suit that --print-markers is for; the one of 18 boards and 8 sources when not given")};
}

std::vector<std::string> photographRemarks() {
    return {
        "Photographs: print the sheet at 100 % and stick each marker so that its middle lies over the middle "
        "of the source's face, of a board over its microphone's opening. Take it off while sound is "
        "recorded, or punch a small hole in its middle, of at most an eighth of its side. Photograph every "
        "placement from two sides at least, better four to six, with one camera, without zoom, sharp and not "
        "too bright; each photograph shows markers that others show too, and some show sources and boards "
        "together. Nothing moves meanwhile. Expect 0.5 to 1 mm; print larger markers when they are less than "
        "40 pixels wide.",
        "Example: noctule --batch calibrate sources --print-markers sheet.svg",
        "Example: noctule --batch calibrate sources jig_001.noctule --photos 1_a.jpg 1_b.jpg 2_a.jpg 2_b.jpg "
        "--marker-mm 39.8 --out suit.json"};
}

Status checkPhotographOptions(const Arguments& arguments) {
    const bool prints = arguments.given("print-markers"), photographs = arguments.given("photos");
    for (const char* other : {"digitizer", "distances", "photos", "base", "report", "out", "force"})
        if (prints && arguments.given(other))
            return Error{ErrorKind::kUsage,
                         std::string("--print-markers writes the sheet only, without --") + other,
                         "Calibrate in a second step"};
    if (arguments.given("suit") && !prints)
        return Error{ErrorKind::kUsage, "--suit is for --print-markers; a take knows its suit",
                     "Leave it out"};
    if (arguments.given("marker-mm") && !prints && !photographs)
        return Error{ErrorKind::kUsage, "--marker-mm is for --photos and --print-markers",
                     "Add one of them, or leave it out"};
    return Done{};
}

Result<PhotographedDistances> measurePhotographs(const Arguments& arguments, const JobContext& job) {
    JigPhotographs request{arguments.operands(), arguments.texts("photos"), {}};
    request.settings.side_m = kMetresPerMm * *arguments.number("marker-mm");
    return measureJigPhotographs(request, job);
}

nlohmann::json photographsJson(const PhotographedDistances& found) {
    nlohmann::json json = {{"corner_sigma_px", found.corner_sigma_px},
                           {"files", nlohmann::json::array()},
                           {"lenses", nlohmann::json::array()}};
    for (const PhotographUse& use : found.photographs)
        json["files"].push_back({{"file", use.name},
                                 {"placement", use.placement},
                                 {"markers", use.markers},
                                 {"error_px", use.error_px}});
    for (const FoundLens& lens : found.lenses)
        json["lenses"].push_back({{"width_px", lens.width_px},
                                  {"height_px", lens.height_px},
                                  {"focal_px", lens.focal_px},
                                  {"k1", lens.k1},
                                  {"k2", lens.k2},
                                  {"edge_px", lens.edge_px}});
    return json;
}

Result<Outcome> printMarkers(const VerbContext& context) {
    const Arguments& arguments = context.arguments;
    Suit suit = defaultSuit();
    if (const Status read = readGiven(arguments, "suit", readSuit, suit); !read)
        return read.error();
    const double marker_mm = *arguments.number("marker-mm");
    const auto pages = markerSheet(suit, marker_mm);
    if (!pages)
        return pages.error();
    std::vector<std::string> paths;
    for (size_t page = 0; page < pages->size(); ++page)
        paths.push_back(pagePath(arguments.text("print-markers"), page));
    const bool overwrite = arguments.given("overwrite");
    if (const Status free = checkOutputs(paths, overwrite); !free)
        return free.error();
    std::string list;
    for (size_t page = 0; page < pages->size(); ++page) {
        if (const Status written = writeFileAtomically(paths[page], (*pages)[page], overwrite); !written)
            return written.error();
        list += (page > 0 ? ", " : "") + paths[page];
    }
    return Outcome{
        {{"sheets", paths}, {"marker_mm", marker_mm}},
        "Written: " + list +
            "\nPrint at 100 % on A4 and measure the line of 100 mm; the sheet says how to stick.\n",
        std::nullopt};
}

}  // namespace noctule::batch
