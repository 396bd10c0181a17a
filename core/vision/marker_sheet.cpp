// SPDX-License-Identifier: Apache-2.0
#include "core/vision/marker_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/body/text.h"
#include "core/vision/marker_cells.h"
#include "core/vision/marker_plan.h"

namespace noctule {
namespace {

// A4; printers leave a border of some millimetres white.
constexpr double kPageWidth_mm = 210, kPageHeight_mm = 297, kBorder_mm = 12;
constexpr double kHead_mm = 52;  ///< title, words and ruler
constexpr double kLabel_mm = 6, kGap_mm = 3;
constexpr double kText_mm = 3;  ///< lines of 115 letters fit
constexpr double kRuler_mm = 100, kTick_mm = 2;

/// Plain decimals, to a micrometre.
std::string mm(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4f", value);
    std::string number = text;
    number.erase(number.find_last_not_of('0') + 1);
    return number.back() == '.' ? number.substr(0, number.size() - 1) : number;
}

std::string rectangle(double x, double y, double width, double height, const char* fill) {
    return "<rect x=\"" + mm(x) + "\" y=\"" + mm(y) + "\" width=\"" + mm(width) + "\" height=\"" +
           mm(height) + "\" fill=\"" + fill + "\"/>\n";
}

std::string words(double x, double y, double size, const std::string& text, const char* anchor = "start") {
    return "<text x=\"" + mm(x) + "\" y=\"" + mm(y) + "\" font-size=\"" + mm(size) + "\" text-anchor=\"" +
           anchor + "\">" + text::escaped(text) + "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* colour = "#000000") {
    return "<line x1=\"" + mm(x1) + "\" y1=\"" + mm(y1) + "\" x2=\"" + mm(x2) + "\" y2=\"" + mm(y2) +
           "\" stroke=\"" + colour + "\" stroke-width=\"0.2\"/>\n";
}

/// White cells on a black square; cells side by side are one rectangle, so that no seam shows between them.
std::string markerPicture(int number, double x, double y, double side_mm) {
    const MarkerCells cells = markerCells(number);
    const double cell_mm = side_mm / kMarkerCells;
    std::string text = "<g id=\"marker-" + std::to_string(number) + "\" shape-rendering=\"crispEdges\">\n" +
                       rectangle(x, y, side_mm, side_mm, "#000000");
    for (int row = 0; row < kMarkerCells; ++row)
        for (int begin = 0; begin < kMarkerCells; ++begin) {
            int end = begin;
            while (end < kMarkerCells && cells[size_t(row)][size_t(end)])
                ++end;
            if (end > begin)
                text += rectangle(x + begin * cell_mm, y + row * cell_mm, (end - begin) * cell_mm, cell_mm,
                                  "#ffffff");
            begin = end;
        }
    return text + "</g>\n";
}

/// The cut line around marker and margin, with ticks outside that point at the middle.
std::string cutLine(double x, double y, double size_mm) {
    const double middle_x = x + size_mm / 2, middle_y = y + size_mm / 2, end_x = x + size_mm,
                 end_y = y + size_mm;
    std::string text = "<rect x=\"" + mm(x) + "\" y=\"" + mm(y) + "\" width=\"" + mm(size_mm) +
                       "\" height=\"" + mm(size_mm) +
                       "\" fill=\"none\" stroke=\"#aaaaaa\" stroke-width=\"0.2\"/>\n";
    const char* const grey = "#aaaaaa";
    const double tick_mm = std::min(kTick_mm, size_mm / 12);
    return text + line(middle_x, y, middle_x, y + tick_mm, grey) +
           line(middle_x, end_y - tick_mm, middle_x, end_y, grey) +
           line(x, middle_y, x + tick_mm, middle_y, grey) +
           line(end_x - tick_mm, middle_y, end_x, middle_y, grey);
}

std::string ruler(double x, double y) {
    std::string text = line(x, y, x + kRuler_mm, y);
    for (int tick = 0; tick <= 10; ++tick)
        text += line(x + 10 * tick, y - (tick % 10 == 0 ? 3 : 1.5), x + 10 * tick, y);
    return text + words(x + kRuler_mm + 3, y, 3.5, "100 mm: measure it on the paper");
}

std::string head(const Suit& suit, double marker_mm, size_t page, size_t pages) {
    const double x = kBorder_mm;
    const std::string side = mm(marker_mm);
    return words(x, 18, 5,
                 "Noctule: markers of suit " +
                     (suit.name.empty() ? std::string("without a name") : suit.name) + ", page " +
                     std::to_string(page + 1) + " of " + std::to_string(pages)) +
           words(x, 25, kText_mm,
                 "Print at 100 % (\"actual size\"), on matt paper. If the line below is not 100 mm long, "
                 "give the side measured on") +
           words(x, 29.5, kText_mm,
                 "the paper as --marker-mm instead of " + side +
                     ". Cut along the grey lines, keep the white margin, stick on flat card.") +
           words(x, 34, kText_mm,
                 "The middle of the marker lies over the middle of the source's face, of a board over its "
                 "microphone's opening;") +
           words(
               x, 38.5, kText_mm,
               "it may be turned any way. Take it off while sound is recorded, or punch a hole of at most " +
                   mm(std::floor(10 * marker_mm / 8) / 10) + " mm") +
           words(x, 43, kText_mm,
                 "in its middle for the sound. The origin stands anywhere still, where many photographs show "
                 "it.") +
           ruler(x, 50);
}

std::string document(const std::string& content) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
           mm(kPageWidth_mm) + "mm\" height=\"" + mm(kPageHeight_mm) + "mm\" viewBox=\"0 0 " +
           mm(kPageWidth_mm) + " " + mm(kPageHeight_mm) + "\" font-family=\"sans-serif\">\n" +
           rectangle(0, 0, kPageWidth_mm, kPageHeight_mm, "#ffffff") + content + "</svg>\n";
}

}  // namespace

Result<std::vector<std::string>> markerSheet(const Suit& suit, double marker_mm) {
    require(marker_mm >= kSmallestMarker_mm && marker_mm <= kLargestMarker_mm, "markerSheet: size");
    const auto plan = planMarkers(suit);
    if (!plan)
        return plan.error();
    const double margin_mm = marker_mm / kMarkerCells, cut_mm = marker_mm + 2 * margin_mm;
    const double pitch_x = cut_mm + kGap_mm, pitch_y = cut_mm + kLabel_mm + kGap_mm;
    const auto columns = size_t((kPageWidth_mm - 2 * kBorder_mm + kGap_mm) / pitch_x);
    const auto rows = size_t((kPageHeight_mm - kHead_mm - kBorder_mm) / pitch_y);
    const size_t of_page = columns * rows, pages = (plan->size() + of_page - 1) / of_page;
    std::vector<std::string> documents;
    for (size_t page = 0; page < pages; ++page) {
        std::string content = head(suit, marker_mm, page, pages);
        for (size_t i = page * of_page; i < std::min(plan->size(), (page + 1) * of_page); ++i) {
            const PlannedMarker& marker = (*plan)[i];
            const double x = kBorder_mm + pitch_x * double(i % of_page % columns),
                         y = kHead_mm + pitch_y * double(i % of_page / columns);
            content += cutLine(x, y + kGap_mm, cut_mm) +
                       markerPicture(marker.number, x + margin_mm, y + kGap_mm + margin_mm, marker_mm) +
                       words(x + cut_mm / 2, y + kGap_mm + cut_mm + 4, std::min(3.2, marker_mm / 8),
                             std::to_string(marker.number) + ": " + marker.name, "middle");
        }
        documents.push_back(document(content));
    }
    return documents;
}

}  // namespace noctule
