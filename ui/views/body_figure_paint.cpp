// SPDX-License-Identifier: Apache-2.0
// How the figure becomes pixels.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/views/body_figure.h"

namespace noctule::ui {
namespace {

constexpr int kOversampling = 2;

/// The segments of a picture that is kOversampling times as fine as the one asked for, 0 outside.
class SegmentPixels {
public:
    explicit SegmentPixels(const QImage& codes)
        : bits_(codes.constBits()),
          line_(codes.bytesPerLine()),
          wide_(codes.width()),
          high_(codes.height()) {}

    /// Of everything that a pixel's colour depends on; -1: there is more than one.
    int only(int x, int y) const {
        constexpr int kReach = 2 * kOversampling;
        x *= kOversampling;
        y *= kOversampling;
        if (x + kReach > wide_ || y + kReach > high_)
            return -1;
        const uchar* first = at(x, y);
        const uint32_t same = *first * 0x01010101U;
        for (int i = 0; i < kReach; ++i) {
            uint32_t row = 0;
            static_assert(sizeof row == kReach);
            std::memcpy(&row, first + i * line_, sizeof row);
            if (row != same)
                return -1;
        }
        return *first;
    }
    /// The mean, where two segments meet with a thin gap in between.
    QRgb mixed(int x, int y, const std::vector<QRgb>& colors) const {
        constexpr int kParts = kOversampling * kOversampling;
        int alpha = 0, red = 0, green = 0, blue = 0;
        for (int i = 0; i < kParts; ++i) {
            const QRgb color =
                colorAt(kOversampling * x + i % kOversampling, kOversampling * y + i / kOversampling, colors);
            alpha += qAlpha(color);
            red += qRed(color);
            green += qGreen(color);
            blue += qBlue(color);
        }
        return qRgba(red / kParts, green / kParts, blue / kParts, alpha / kParts);
    }

private:
    const uchar* at(int x, int y) const { return bits_ + static_cast<ptrdiff_t>(y) * line_ + x; }
    QRgb colorAt(int x, int y, const std::vector<QRgb>& colors) const {
        constexpr int kSeam = kOversampling;  // one pixel; the outer edge stays whole
        const int segment = *at(x, y);
        const int right = x + kSeam < wide_ ? *at(x + kSeam, y) : 0;
        const int below = y + kSeam < high_ ? *at(x, y + kSeam) : 0;
        const bool gap = (right != segment && right != 0) || (below != segment && below != 0);
        return gap ? 0 : colors[static_cast<size_t>(segment)];
    }

    const uchar* bits_;
    int line_, wide_, high_;
};

}  // namespace

/// Every pixel whose centre lies inside gets 1 plus the segment with the largest share there. Tens of
/// thousands of small triangles: QPainter takes several times as long for them.
void BodyFigure::fill(QImage& image, const Corners& corners, const std::vector<Share>& shares) {
    const auto [left, right] = std::minmax({corners[0].x(), corners[1].x(), corners[2].x()});
    const auto [top, bottom] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    const int first = std::max(0, static_cast<int>(left)),
              last = std::min(image.width() - 1, static_cast<int>(right));
    const int lowest = std::min(image.height() - 1, static_cast<int>(bottom));
    const QPointF a = corners[1] - corners[0], b = corners[2] - corners[0];
    uchar* bits = image.bits();
    const int line = image.bytesPerLine();
    const double turn = a.x() * b.y() > a.y() * b.x() ? 1 : -1;
    // How far inside the edge opposite of each corner: the weight of that corner, but for a common factor.
    std::array<double, 3> inside{}, step{};
    const auto strength = [&inside](const Share& share) {
        return inside[0] * share.weights[0] + inside[1] * share.weights[1] + inside[2] * share.weights[2];
    };
    for (int y = std::max(0, static_cast<int>(top)); y <= lowest; ++y) {
        double begin = first, end = last;
        for (size_t i = 0; i < 3; ++i) {
            const QPointF& from = corners[(i + 1) % 3];
            const QPointF along = turn * (corners[(i + 2) % 3] - from);
            const QPointF to = QPointF(first + 0.5, y + 0.5) - from;
            inside[i] = along.x() * to.y() - along.y() * to.x();
            step[i] = -along.y();
            if (step[i] > 0)
                begin = std::max(begin, first + std::ceil(-inside[i] / step[i]));
            else if (step[i] < 0)
                end = std::min(end, first + std::floor(-inside[i] / step[i]));
            else if (inside[i] < 0)
                end = -1;
        }
        uchar* row = bits + static_cast<ptrdiff_t>(y) * line;
        if (shares.size() == 1) {
            if (begin <= end)
                std::fill(row + static_cast<int>(begin), row + static_cast<int>(end) + 1,
                          static_cast<uchar>(shares[0].segment + 1));
            continue;
        }
        for (size_t i = 0; i < 3; ++i)
            inside[i] += step[i] * (begin - first);
        for (double x = begin; x <= end; ++x) {
            row[static_cast<int>(x)] =
                static_cast<uchar>(std::ranges::max_element(shares, {}, strength)->segment + 1);
            for (size_t i = 0; i < 3; ++i)
                inside[i] += step[i];
        }
    }
}

/// Each pixel: index of its segment plus 1. Asked for with every change of colour.
QImage BodyFigure::segmentImage(int height_px) const {
    if (segment_image_.height() == height_px)
        return segment_image_;
    const double scale = this->scale(height_px);
    QImage image(static_cast<int>(std::ceil(2 * half_width_m_ * scale)), height_px,
                 QImage::Format_Grayscale8);
    image.fill(0);
    const QPointF centre(image.width() / 2.0, height_px);
    for (const Face& face : faces_) {
        std::array<QPointF, 3> corners;
        for (size_t i = 0; i < 3; ++i)
            corners[i] = centre + scale * QPointF(face.corners_m[i].x(), -face.corners_m[i].y());
        fill(image, corners, face.shares);
    }
    return segment_image_ = image;
}

QImage BodyFigure::paint(int height_px, const QColor& body,
                         const std::map<std::string, QColor>& marked) const {
    const QImage codes = segmentImage(height_px * kOversampling);
    std::vector<QRgb> colors{0};
    for (const std::string& segment : segments_) {
        const auto mark = marked.find(segment);
        colors.push_back((mark == marked.end() ? body : mark->second).rgb());
    }
    QImage picture(codes.width() / kOversampling, height_px, QImage::Format_ARGB32_Premultiplied);
    const SegmentPixels pixels(codes);
    for (int y = 0; y < picture.height(); ++y) {
        auto* out = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < picture.width(); ++x) {
            const int code = pixels.only(x, y);
            out[x] = code >= 0 ? colors[static_cast<size_t>(code)] : pixels.mixed(x, y, colors);
        }
    }
    return picture;
}

}  // namespace noctule::ui
