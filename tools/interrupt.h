// SPDX-License-Identifier: MIT
// SIGINT and SIGTERM as a wish to stop at the next good moment.
#pragma once

namespace tress {

/// Thrown by work that was told to stop, once what there is of it is written. The exit code is 128 + signal.
struct Interrupted {
    int signal;
};

/// While it lives, the first SIGINT and the first SIGTERM are noted and end nothing; a second ends the process, as
/// usual. One at a time.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    /// The one that came, or 0.
    int signal() const;
};

}  // namespace tress
