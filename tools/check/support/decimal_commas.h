// SPDX-License-Identifier: MIT
// Numbers with decimal commas: a locale of the system where one is installed, and one of our own for C++ streams.
#pragma once

#include <clocale>
#include <cstring>
#include <locale>
#include <string>

namespace tress::test {

/// As long as this lives, every locale-aware function of C and C++ writes and expects 0,5.
class DecimalCommas {
public:
    DecimalCommas() : old_cpp_(std::locale::global(std::locale(std::locale::classic(), new Commas))) {
        const char* now = std::setlocale(LC_ALL, nullptr);
        old_c_ = now ? now : "C";
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8", "es_ES.UTF-8",
                                 "it_IT.UTF-8", "pl_PL.UTF-8", "ru_RU.UTF-8", "pt_BR.UTF-8", "sv_SE.UTF-8"})
            if (std::setlocale(LC_ALL, name) && std::strcmp(std::localeconv()->decimal_point, ",") == 0) {
                installed_ = name;
                return;
            }
        std::setlocale(LC_ALL, old_c_.c_str());
    }
    ~DecimalCommas() {
        std::locale::global(old_cpp_);
        std::setlocale(LC_ALL, old_c_.c_str());
    }
    DecimalCommas(const DecimalCommas&) = delete;
    DecimalCommas& operator=(const DecimalCommas&) = delete;

    /// Of the system; empty: it has none that is known here, and C functions write points.
    const std::string& installed() const { return installed_; }

private:
    struct Commas : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };

    std::locale old_cpp_;
    std::string old_c_, installed_;
};

}  // namespace tress::test
