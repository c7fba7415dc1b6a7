// SPDX-License-Identifier: MIT
#include "io/checkpoint_file.h"

#include <cstring>
#include <sstream>

#include "core/error.h"
#include "core/rng.h"
#include "io/byte_reader.h"
#include "io/whole_file.h"

namespace tress {
namespace {

constexpr char kMagic[8] = {'T', 'R', 'S', 'C', 'H', 'K', '0', '1'};
constexpr uint64_t kLongestText = 1 << 20;  // bytes
constexpr uint32_t kMostStages = 1000;

/// A number that changes with every bit and its place.
class Checksum {
public:
    void add(const void* data, size_t bytes) {
        const auto* at = static_cast<const unsigned char*>(data);
        for (; bytes >= sizeof(uint64_t); at += sizeof(uint64_t), bytes -= sizeof(uint64_t))
            add_word(at, sizeof(uint64_t));
        if (bytes > 0) add_word(at, bytes);
    }
    uint64_t value() const { return value_; }

private:
    void add_word(const unsigned char* at, size_t bytes) {
        uint64_t word = 0;
        std::memcpy(&word, at, bytes);
        value_ = hash(value_, word);
    }
    uint64_t value_ = 0;
};

class Writer {
public:
    explicit Writer(const std::string& path) : file_(path) {}

    void bytes(const void* data, size_t count) {
        sum_.add(data, count);
        file_.write(data, count);
    }
    template <class T>
    void number(T value) {
        bytes(&value, sizeof value);
    }
    template <class Array>
    void array(const Array& values) {
        number(uint64_t(values.size()));
        bytes(values.data(), values.size() * sizeof(values[0]));
    }
    void commit() {
        number(sum_.value());
        file_.commit();
    }

private:
    WholeFile file_;
    Checksum sum_;
};

/// Numbers and arrays as Writer writes them.
class Reader {
public:
    explicit Reader(const std::string& path) : file_(path) {}

    template <class T>
    void values(std::span<T> out, const char* what) {
        file_.read(out, what);
        sum_.add(out.data(), out.size_bytes());
    }
    template <class T>
    T number(const char* what) {
        T value{};
        values(std::span<T>(&value, 1), what);
        return value;
    }
    std::string text(const char* what) {
        const auto length = number<uint64_t>(what);
        if (length > kLongestText) file_.fail(std::string(what) + ": longer than any");
        file_.need(length, 1, what);
        std::string text(length, '\0');
        values(std::span<char>(text.data(), text.size()), what);
        return text;
    }
    void end() {
        const uint64_t expected = sum_.value();
        if (number<uint64_t>("checksum") != expected || file_.remaining() != 0)
            file_.fail("damaged: the checksum differs");
    }
    [[noreturn]] void fail(const std::string& problem) const { file_.fail(problem); }

private:
    ByteReader file_;
    Checksum sum_;
};

std::span<double> numbers(std::vector<glm::dvec3>& array) {
    if (array.empty()) return {};
    return {&array.front().x, 3 * array.size()};
}
template <class T>
std::span<T> numbers(std::vector<T>& array) {
    return array;
}

/// Throws with the first line that differs.
void check_made_by(const std::string& path, const std::string& found, const std::string& expected) {
    if (found == expected) return;
    std::istringstream a(found), b(expected);
    std::string was, is;
    do {
        was.clear(), is.clear();
        std::getline(a, was), std::getline(b, is);
    } while (was == is && a && b);
    throw InputError(path, "a checkpoint of another render, with " + (was.empty() ? "less" : was) + ", expected " +
                               (is.empty() ? "less" : is));
}

}  // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint, const Film& film) {
    Writer out(path);
    out.bytes(kMagic, sizeof kMagic);
    out.array(checkpoint.made_by);
    out.number(checkpoint.samples);
    out.number(checkpoint.seconds);
    out.array(checkpoint.stage_nanoseconds);
    out.number(uint32_t(film.width));
    out.number(uint32_t(film.height));
    for_each_array(film, [&](const auto& array) { out.array(array); });
    out.commit();
}

Checkpoint read_checkpoint(const std::string& path, const std::string& made_by, Film& film) {
    Reader in(path);
    char magic[sizeof kMagic];
    in.values(std::span<char>(magic), "signature");
    if (std::memcmp(magic, kMagic, sizeof magic) != 0)
        in.fail("no checkpoint of tress, expected " + std::string(kMagic, sizeof kMagic));
    Checkpoint checkpoint;
    checkpoint.made_by = in.text("what it was made by");
    check_made_by(path, checkpoint.made_by, made_by);
    checkpoint.samples = in.number<uint32_t>("samples");
    checkpoint.seconds = in.number<double>("seconds");
    const auto stages = in.number<uint64_t>("stages");
    if (stages > kMostStages) in.fail("damaged: " + std::to_string(stages) + " stages");
    checkpoint.stage_nanoseconds.resize(stages);
    in.values(std::span(checkpoint.stage_nanoseconds), "times of stages");
    const auto width = in.number<uint32_t>("width"), height = in.number<uint32_t>("height");
    if (width != uint32_t(film.width) || height != uint32_t(film.height)) in.fail("a picture of another size");
    for_each_array(film, [&](auto& array) {
        if (in.number<uint64_t>("layer") != array.size()) in.fail("a picture with other layers");
        in.values(numbers(array), "layer");
    });
    in.end();
    return checkpoint;
}

}  // namespace tress
