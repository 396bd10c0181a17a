// SPDX-License-Identifier: Apache-2.0
// The sheet as a printer sees it: its rectangles painted in order, and the markers found again.
#include "core/vision/marker_sheet.h"

#include <map>
#include <regex>

#include "tests/core/vision/test_jig.h"

namespace noctule {
namespace {

using namespace test;

constexpr double kPixelsPerMm = 8;

double attribute(const std::string& element, const std::string& name) {
    std::smatch match;
    EXPECT_TRUE(std::regex_search(element, match, std::regex(" " + name + "=\"([^\"]*)\""))) << element;
    return std::stod(match[1]);
}

/// As a picture file.
std::string paint(const std::string& svg) {
    cv::Mat picture(int(297 * kPixelsPerMm), int(210 * kPixelsPerMm), CV_8U, cv::Scalar(128));
    const std::regex rectangle("<rect [^>]*/>");
    for (std::sregex_iterator i(svg.begin(), svg.end(), rectangle), end; i != end; ++i) {
        const std::string element = i->str();
        const double x = kPixelsPerMm * attribute(element, "x"), y = kPixelsPerMm * attribute(element, "y"),
                     right = x + kPixelsPerMm * attribute(element, "width"),
                     bottom = y + kPixelsPerMm * attribute(element, "height");
        if (element.find("fill=\"none\"") != std::string::npos)
            continue;
        const int level = element.find("#ffffff") != std::string::npos ? 255 : 0;
        cv::rectangle(picture, cv::Point(int(std::lround(x)), int(std::lround(y))),
                      cv::Point(int(std::lround(right)) - 1, int(std::lround(bottom)) - 1), level,
                      cv::FILLED);
    }
    std::vector<uchar> bytes;
    cv::imencode(".png", picture, bytes);
    return {bytes.begin(), bytes.end()};
}

TEST(MarkerSheet, EveryMarkerIsFoundAgainOnceInItsSize) {
    const Suit suit = defaultSuit();
    for (const double marker_mm : {25.0, 40.0, 90.0}) {
        const auto pages = markerSheet(suit, marker_mm);
        ASSERT_TRUE(pages);
        std::map<int, int> times;
        for (const std::string& page : *pages) {
            EXPECT_NE(page.find("width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""),
                      std::string::npos);
            const Photograph photograph = findMarkers(paint(page), "sheet").value();
            for (const SeenMarker& seen : photograph.markers) {
                ++times[seen.number];
                for (size_t k = 0; k < 4; ++k)
                    EXPECT_NEAR((seen.corners_px[k] - seen.corners_px[(k + 1) % 4]).norm(),
                                marker_mm * kPixelsPerMm, 1.5)
                        << seen.number;
                EXPECT_LT(seen.corners_px[0].x() + 1, seen.corners_px[1].x()) << "upright";
            }
        }
        const std::vector<PlannedMarker> plan = planMarkers(suit).value();
        for (const PlannedMarker& planned : plan)
            EXPECT_EQ(times[planned.number], 1) << planned.name << ", " << marker_mm << " mm";
        EXPECT_EQ(times.size(), 27U);
    }
}

TEST(MarkerSheet, SaysWhatItIsAndHowToPrintAndStickIt) {
    const auto pages = markerSheet(defaultSuit(), 40).value();
    EXPECT_EQ(pages.size(), 3U);
    for (const std::string& page : pages)
        for (const char* word : {"100 %", "100 mm", "--marker-mm", "microphone", "page ", "white margin"})
            EXPECT_NE(page.find(word), std::string::npos) << word;
    std::string all_pages;
    for (const std::string& page : pages)
        all_pages += page;
    const std::vector<PlannedMarker> plan = planMarkers(defaultSuit()).value();
    for (const PlannedMarker& planned : plan)
        EXPECT_NE(all_pages.find(std::to_string(planned.number) + ": " + planned.name), std::string::npos);
    // The line for the printer's scale, from its ends.
    const std::regex ruler("<line x1=\"12\" y1=\"50\" x2=\"112\" y2=\"50\"");
    EXPECT_TRUE(std::regex_search(pages[0], ruler));
}

TEST(MarkerSheet, NothingRunsOverThePageAndMarkersKeepTheirMargin) {
    for (const double marker_mm : {10.0, 33.3, 40.0, 60.0, 120.0}) {
        const auto pages = markerSheet(defaultSuit(), marker_mm).value();
        for (const std::string& page : pages) {
            std::vector<Eigen::AlignedBox2d> frames;
            const std::regex rectangle("<rect [^>]*fill=\"none\"[^>]*/>");
            for (std::sregex_iterator i(page.begin(), page.end(), rectangle), end; i != end; ++i) {
                const Eigen::Vector2d at(attribute(i->str(), "x"), attribute(i->str(), "y"));
                const double width = attribute(i->str(), "width");
                EXPECT_NEAR(width, marker_mm * 8 / 6, 1e-3) << "a cell on either side";
                frames.emplace_back(at, at + Eigen::Vector2d(width, width));
                EXPECT_GE(frames.back().min().minCoeff(), 10);
                EXPECT_LE(frames.back().max().x(), 200);
                EXPECT_LE(frames.back().max().y(), 287);
            }
            EXPECT_FALSE(frames.empty());
            for (size_t a = 0; a < frames.size(); ++a)
                for (size_t b = 0; b < a; ++b)
                    EXPECT_TRUE(frames[a].intersection(frames[b]).isEmpty());
        }
    }
}

TEST(MarkerSheet, NamesOfASuitCannotBreakTheFile) {
    Suit suit = defaultSuit();
    suit.name = "<a & \"b\">";
    suit.boards[0].id = "</svg>";
    const std::vector<std::string> pages = markerSheet(suit, 40).value();
    for (const std::string& page : pages)
        EXPECT_EQ(page.find("</svg>"), page.size() - 7);
}

}  // namespace
}  // namespace noctule
