// SPDX-License-Identifier: MIT
// What time buys: the error of a method that is partly biased, as a floor and a part that falls with time,
// MSE(t) = bias^2 + c / t.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace tress {

/// One picture of a run: its mean square error (relMSE) after so many seconds.
struct ErrorPoint {
    double seconds = 0, error = 0;
};

/// The pictures of one seed, made one on top of the other.
using ErrorRun = std::vector<ErrorPoint>;

struct ErrorFit {
    double floor = 0;                         // bias^2: what is left however long the run is
    double noise = 0;                         // c: error times seconds, of the part that falls
    double residual = 0;                      // root of the mean square of (error - fit) / fit
    double floor_error = 0, noise_error = 0;  // standard errors by leaving out one run at a time; 0 with one run

    double at(double seconds) const { return floor + noise / seconds; }
    /// Seconds until the error is `error`; infinity where it never gets so small.
    double seconds_to(double error) const {
        return error > floor ? noise / (error - floor) : std::numeric_limits<double>::infinity();
    }
};

/// Least squares of relative residuals, neither part negative. Points that are not finite, without time or without
/// error are left out; without any all is 0. Where the times do not tell the parts apart (one time), all is noise.
ErrorFit fit_error(std::span<const ErrorRun> runs);

}  // namespace tress
