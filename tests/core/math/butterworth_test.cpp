// SPDX-License-Identifier: Apache-2.0
// Against scipy.signal.butter (scipy 1.10), whose transfer functions are pasted here.
#include "core/math/butterworth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace noctule {
namespace {

using Polynomial = std::vector<double>;

Polynomial times(const Polynomial& a, const Polynomial& b) {
    Polynomial product(a.size() + b.size() - 1);
    for (size_t i = 0; i < a.size(); ++i)
        for (size_t k = 0; k < b.size(); ++k)
            product[i + k] += a[i] * b[k];
    return product;
}

/// The sections multiplied out must be b / a; a first-order section leaves a zero at the end.
void expectTransferFunction(const std::vector<Biquad>& sections, const Polynomial& b, const Polynomial& a) {
    Polynomial numerator{1}, denominator{1};
    for (const Biquad& s : sections) {
        numerator = times(numerator, {s.b0, s.b1, s.b2});
        denominator = times(denominator, {1, s.a1, s.a2});
    }
    ASSERT_GE(numerator.size(), b.size());
    for (size_t i = 0; i < numerator.size(); ++i) {
        EXPECT_NEAR(numerator[i], i < b.size() ? b[i] : 0, 1e-13) << "b" << i;
        EXPECT_NEAR(denominator[i], i < a.size() ? a[i] : 0, 1e-12) << "a" << i;
    }
}

double gain(const std::vector<Biquad>& sections, double frequency_hz, double sample_rate_hz) {
    const auto d = std::polar(1.0, -2 * std::numbers::pi * frequency_hz / sample_rate_hz);
    double product = 1;
    for (const Biquad& s : sections)
        product *= std::abs((s.b0 + d * (s.b1 + d * s.b2)) / (1.0 + d * (s.a1 + d * s.a2)));
    return product;
}

TEST(Butterworth, LowPassEqualsScipy) {
    expectTransferFunction(butterworthLowPass(2, 30000, 150000),
                           {0.20657208382614792, 0.41314416765229584, 0.20657208382614792},
                           {1, -0.3695273773512414, 0.19581571265583306});
}

TEST(Butterworth, LowPassOfOddOrderEqualsScipy) {
    expectTransferFunction(butterworthLowPass(5, 7, 120),
                           {0.00012035902957647552, 0.0006017951478823776, 0.0012035902957647552,
                            0.0012035902957647552, 0.0006017951478823776, 0.00012035902957647552},
                           {1, -3.8157792946874465, 5.934476546767215, -4.68510620213864, 1.8731526649613386,
                            -0.30289222595601856});
}

TEST(Butterworth, BandPassEqualsScipy) {
    expectTransferFunction(
        butterworthBandPass(2, 37500, 42500, 150000),
        {0.009525762376195445, 0, -0.01905152475239089, 0, 0.009525762376195445},
        {1, 0.3894692244944962, 1.743655195048866, 0.3355833751170605, 0.7436551950488659});
}

TEST(Butterworth, BandPassOfOddOrderEqualsScipy) {
    expectTransferFunction(
        butterworthBandPass(3, 37500, 42500, 140000),
        {0.0011423435662356325, 0, -0.003427030698706897, 0, 0.003427030698706897, 0, -0.0011423435662356325},
        {1, 1.2432776760036688, 3.0687556421184325, 2.1995751789789537, 2.64348669559765, 0.9208831061862264,
         0.6377857831656544});
}

TEST(Butterworth, WideBandPassWithRealPolesEqualsScipy) {
    expectTransferFunction(butterworthBandPass(1, 100, 40000, 150000),
                           {0.5251539295944917, 0, -0.5251539295944917},
                           {1, -0.945284302784478, -0.05030785918898345});
}

TEST(Butterworth, EdgesAreHalfPowerAndEverySectionHasUnitGainInTheBand) {
    const auto low = butterworthLowPass(7, 800, 44100);
    EXPECT_NEAR(gain(low, 0, 44100), 1, 1e-12);
    EXPECT_NEAR(gain(low, 800, 44100), std::sqrt(0.5), 1e-9);
    const auto band = butterworthBandPass(4, 300, 5000, 44100);
    EXPECT_NEAR(gain(band, 300, 44100), std::sqrt(0.5), 1e-9);
    EXPECT_NEAR(gain(band, 5000, 44100), std::sqrt(0.5), 1e-9);
    for (const Biquad& section : low)
        EXPECT_NEAR(gain({section}, 0, 44100), 1, 1e-12);
}

TEST(Butterworth, RefusesEdgesThatNoFilterHas) {
    EXPECT_THROW((void)butterworthLowPass(2, 75000, 150000), std::logic_error);
    EXPECT_THROW((void)butterworthLowPass(0, 100, 1000), std::logic_error);
    EXPECT_THROW((void)butterworthBandPass(2, 200, 100, 1000), std::logic_error);
}

}  // namespace
}  // namespace noctule
