// SPDX-License-Identifier: MIT
#include "tools/check/rows/corrupt_hair.h"

#include <cctype>
#include <new>

#include "io/hair_file.h"
#include "tools/check/support/damaged_bytes.h"
#include "tools/check/support/little_memory.h"
#include "tools/check/support/raw_hair.h"
#include "tools/check/support/refusal.h"
#include "tools/check/support/sanitizers.h"

namespace tress {
namespace {

using namespace test;

// Flags of arrays in the format.
constexpr uint32_t kSegments = 1, kPoints = 2, kAll = 31;
constexpr uint32_t kMost = 0xffffffff, kMostSegments = 65535;

constexpr size_t kMuchMemory = size_t(32) << 20;  // the files are below 1 MB
constexpr double kMegabyte = 1 << 20;

/// Three strands and all arrays.
std::string good_hair() {
    std::string arrays;
    for (const int segments : {1, 2, 1}) append(arrays, uint16_t(segments));
    constexpr int kFloatsAPoint = 3 + 1 + 1 + 3;
    for (int i = 0; i < 7 * kFloatsAPoint; ++i) append(arrays, 0.1f * float(i));
    return raw_hair(3, 7, kAll, 0, arrays);
}

/// Counts whose products are small, or right, where they are formed in 32 bits.
std::vector<std::string> counts_past_32_bits() {
    std::string full_strands;
    for (uint32_t s = 0; s <= kMostSegments; ++s) append(full_strands, uint16_t(kMostSegments));
    return {raw_hair(1u << 16, 0, kPoints, kMostSegments, ""),                  // 2^16 x 2^16 points: 0
            raw_hair(1u << 16, 0, kPoints | kSegments, 0, full_strands),        // the same, strand by strand
            raw_hair(2, 0, kPoints, kMost, ""),                                 // 2 x 2^32 points: 0
            raw_hair(1u << 31, 0, kPoints | kSegments, 0, ""),                  // 2^32 bytes of segments: 0
            raw_hair(1, 0x15555556, kPoints, 0x15555555, std::string(8, 'x')),  // 2^32 + 8 bytes of points: 8
            raw_hair(1, kMost, kPoints, kMost - 1, point_bytes(2)),
            raw_hair(kMost, kMost, kAll, kMost, point_bytes(2))};
}

/// A good file, cut anywhere; one with a byte too many.
std::vector<std::string> of_wrong_length() {
    const std::string good = good_hair();
    std::vector<std::string> files;
    for (size_t length = 0; length < good.size(); ++length) files.push_back(good.substr(0, length));
    files.push_back(good + "x");
    return files;
}

/// Long strands whose points are not there.
std::vector<std::string> strands_of_65535() {
    std::string of_one;
    append(of_one, uint16_t(kMostSegments));
    return {raw_hair(1, 2, kPoints | kSegments, 0, of_one + point_bytes(2)),
            raw_hair(1, kMostSegments + 1, kPoints | kSegments, 0, of_one + point_bytes(2)),
            raw_hair(1, kMostSegments + 1, kPoints, kMostSegments, point_bytes(kMostSegments))};
}

std::vector<std::string> without_strands() {
    return {raw_hair(0, 0, kPoints, 1, ""), raw_hair(0, 2, kPoints, 1, point_bytes(2)),
            raw_hair(2, 2, kPoints, 0, point_bytes(2))};  // two strands of one point
}

std::vector<std::string> with_unknown_flags() {
    std::vector<std::string> files{raw_hair(1, 2, 0, 1, point_bytes(2)), raw_hair(1, 2, kSegments, 1, point_bytes(2))};
    for (uint32_t bit = 5; bit < 32; ++bit) files.push_back(raw_hair(1, 2, kPoints | 1u << bit, 1, point_bytes(2)));
    return files;
}

/// "…: byte 12…".
bool names_byte(const std::string& message) {
    const std::string word = "byte ";
    for (size_t at = message.find(word); at != std::string::npos; at = message.find(word, at + 1))
        if (std::isdigit(static_cast<unsigned char>(message[at + word.size()]))) return true;
    return false;
}

/// What came of many files, read with little memory to be had.
class Readings {
public:
    size_t files = 0, read = 0, nameless = 0, hungry = 0, otherwise = 0;

    void add(const std::string& bytes) {
        ++files;
        const std::string path = folder_.file("a.hair");
        std::filesystem::remove(path);  // written anew: over the old one, some disks take their time
        write_bytes(path, bytes);
        const LittleMemory little(kMuchMemory);
        try {
            read_hair_file(path);
            ++read;
        } catch (const InputError& error) {
            nameless += !names_byte(error.what());
            otherwise += !is_one_line(error.what());
        } catch (const std::bad_alloc&) {
            ++hungry;
        } catch (const std::exception&) {
            ++otherwise;
        }
    }
    void add(const std::vector<std::string>& all) {
        for (const std::string& bytes : all) add(bytes);
    }
    /// Of files of which none is good.
    void add_figures(const std::string& name, std::vector<Figure>& figures) const {
        const std::string of = name + ", " + std::to_string(files) + " files: ";
        figures.push_back(exactly(of + "not refused", double(read + otherwise), 0));
        figures.push_back(exactly(of + "refused without naming a byte", double(nameless), 0));
    }

private:
    Folder folder_;
};

bool reads_strand_of_65535() {
    const Folder folder;
    const size_t points = kMostSegments + 1;
    const std::string path =
        write_bytes(folder.file("a.hair"), raw_hair(1, uint32_t(points), kPoints, kMostSegments, point_bytes(points)));
    return read_hair_file(path).strands.points() == points;
}

}  // namespace

Outcome measure_corrupt_hair(const CheckSettings&) {
    constexpr int kDamaged = 5000;
    std::vector<Figure> figures;
    size_t hungry = 0;
    const double before = peak_memory();
    for (const auto& [name, files] : {std::pair("counts past 2^32", counts_past_32_bits()),
                                      {"files of a wrong length", of_wrong_length()},
                                      {"65,535 segments", strands_of_65535()},
                                      {"no strands", without_strands()},
                                      {"unknown flags", with_unknown_flags()}}) {
        Readings readings;
        readings.add(files);
        readings.add_figures(name, figures);
        hungry += readings.hungry;
    }
    Readings damage;
    for (uint64_t i = 0; i < kDamaged; ++i) damage.add(damaged(good_hair(), hash(7, i)));
    hungry += damage.hungry;
    const std::string of = std::to_string(kDamaged) + " damaged files: ";
    figures.push_back(exactly(of + "neither read nor refused in one line", double(damage.otherwise), 0));
    figures.push_back(exactly(of + "refused without naming a byte", double(damage.nameless), 0));
    figures.push_back(told(of + "still good", double(damage.read)));
    figures.push_back(exactly("files that made the reader ask for 32 MB", double(hungry), 0));
    if (!kSanitized)
        figures.push_back(at_most("growth of the peak of memory", (peak_memory() - before) / kMegabyte,
                                  double(kMuchMemory) / kMegabyte, "MB"));
    figures.push_back(holds("a strand of 65,535 segments is read", reads_strand_of_65535()));
    return {figures, {}};
}

}  // namespace tress
