// SPDX-License-Identifier: MIT
// Checkpoints: the sums of a film to the bit, and nothing that is damaged or of another render is taken.
#include "io/checkpoint_file.h"

#include "core/rng.h"
#include "tests/io_support.h"

using namespace tress;
using namespace tress::test;

namespace {

constexpr const char* kMadeBy = "scene=0123\nspp=8\n";

Film film_with(uint64_t seed, bool filled = true) {
    Plan plan{};
    plan.types[1] = true;
    Film film = make_film(5, 3, plan);
    uint64_t index = 0;
    if (filled)
        for_each_array(film, [&](auto& array) {
            for (auto& value : array) value = std::decay_t<decltype(value)>(1e6 * double(random(seed, index++)) / 3);
        });
    return film;
}

const Checkpoint kCheckpoint{kMadeBy, 7, 1.25, {3, 5}};

}  // namespace

TEST_CASE("a checkpoint comes back to the bit") {
    const Folder folder;
    const std::string path = folder.file("a.checkpoint");
    const Film film = film_with(1);
    write_checkpoint(path, kCheckpoint, film);
    Film back = film_with(2, false);
    const Checkpoint c = read_checkpoint(path, kMadeBy, back);
    CHECK(c.samples == 7);
    CHECK(c.seconds == 1.25);
    CHECK(c.stage_nanoseconds == std::vector<uint64_t>{3, 5});
    CHECK(back.beauty == film.beauty);
    CHECK(back.types[0].light.empty());
    CHECK(back.types[1].light == film.types[1].light);
    CHECK(back.types[1].squares == film.types[1].squares);
    CHECK(back.samples == film.samples);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a checkpoint of another render is refused with what differs") {
    const Folder folder;
    const std::string path = folder.file("a.checkpoint");
    write_checkpoint(path, kCheckpoint, film_with(1));
    Film film = film_with(2, false);
    const auto message = [&](const char* made_by) { return message_of([&] { read_checkpoint(path, made_by, film); }); };
    CHECK(contains(message("scene=0123\nspp=9\n"), "with spp=8, expected spp=9"));
    CHECK(contains(message("scene=0123\n"), "with spp=8, expected less"));
    CHECK(is_one_line(message("scene=99\nspp=8\n")));
}

TEST_CASE("a film of another shape is refused") {
    const Folder folder;
    const std::string path = folder.file("a.checkpoint");
    write_checkpoint(path, kCheckpoint, film_with(1));
    Plan plan{};
    plan.types[0] = plan.types[1] = true;
    Film more = make_film(5, 3, plan), larger = make_film(3, 5, plan);
    CHECK(contains(message_of([&] { read_checkpoint(path, kMadeBy, more); }), "other layers"));
    CHECK(contains(message_of([&] { read_checkpoint(path, kMadeBy, larger); }), "another size"));
}

TEST_CASE("a file that is cut, grown, or has any bit turned is refused in one line") {
    const Folder folder;
    const std::string path = folder.file("a.checkpoint");
    write_checkpoint(path, kCheckpoint, film_with(1));
    const std::string whole = read_bytes(path);
    const auto refused = [&](const std::string& bytes) {
        Film film = film_with(2, false);
        return is_one_line(message_of([&] { read_checkpoint(write_bytes(path, bytes), kMadeBy, film); }));
    };
    CHECK_FALSE(refused(whole));
    for (size_t length = 0; length < whole.size(); length += 37) CHECK(refused(whole.substr(0, length)));
    CHECK(refused(whole + "x"));
    for (size_t at = 0; at < whole.size(); at += 11) {
        std::string turned = whole;
        turned[at] = char(turned[at] ^ (1 << (at % 8)));
        CAPTURE(at);
        CHECK(refused(turned));
    }
}
