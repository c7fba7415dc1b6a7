// SPDX-License-Identifier: MIT
#include "io/whole_file.h"

#include <sys/stat.h>

#include "io/byte_reader.h"
#include "tests/io_support.h"
#include "tools/check/support/full_disk.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("a file that is not committed leaves the target as it was and nothing beside it") {
    const Folder folder;
    const std::string path = write_bytes(folder.file("a"), "old");
    {
        WholeFile file(path);
        file.write("new", 3);
    }
    CHECK(read_bytes(path) == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a committed file takes the target's place, its permissions kept") {
    const Folder folder;
    const std::string path = write_bytes(folder.file("a"), "old");
    REQUIRE(chmod(path.c_str(), 0640) == 0);
    write_text_file(path, "new text");
    CHECK(read_bytes(path) == "new text");
    CHECK(folder.entries() == 1);
    struct stat status {};
    REQUIRE(stat(path.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("what a link names is written, and the link stays") {
    const Folder folder;
    write_bytes(folder.file("target"), "old");
    std::filesystem::create_symlink("target", folder.file("link"));
    write_text_file(folder.file("link"), "new");
    CHECK(std::filesystem::is_symlink(folder.file("link")));
    CHECK(read_bytes(folder.file("target")) == "new");
}

TEST_CASE("places that cannot be written are refused in one line before anything is written") {
    const Folder folder;
    write_bytes(folder.file("plain"), "x");
    for (const std::string& path :
         {folder.path(), folder.file("missing/a"), folder.file("plain/a"), std::string("/dev/null"), std::string()}) {
        CAPTURE(path);
        CHECK(is_one_line(message_of([&] { check_writable(path); })));
    }
    CHECK(folder.entries() == 1);
    check_writable(folder.file("new"));
    CHECK(folder.entries() == 1);
}

TEST_CASE("a disk that is full leaves nothing behind") {
    const Folder folder;
    std::string message;
    {
        const FullDisk full(1000);
        message = message_of([&] { write_text_file(folder.file("a"), std::string(100000, 'x')); });
    }
    CHECK(is_one_line(message));
    CHECK(folder.entries() == 0);
}

TEST_CASE("what is no file is refused in one line that says why") {
    const Folder folder;
    CHECK(contains(message_of([&] { ByteReader(folder.file("none")); }), "no such file"));
    CHECK(contains(message_of([&] { ByteReader(folder.path()); }), "a directory"));
    CHECK(contains(message_of([&] { ByteReader("/dev/zero"); }), "not a plain file"));
}

TEST_CASE("counts are checked without forming a product that would not fit") {
    const Folder folder;
    ByteReader in(write_bytes(folder.file("a"), std::string(16, 'x')));
    CHECK_NOTHROW(in.need(2, 8, "things"));
    CHECK(contains(message_of([&] { in.need(3, 8, "things"); }), "byte 0: 3 x 8 bytes of things"));
    CHECK_THROWS_AS(in.need(~uint64_t(0), 16, "things"), InputError);
    CHECK_THROWS_AS(in.need(uint64_t(1) << 61, 8, "things"), InputError);
    in.skip(2, 8, "things");
    CHECK(in.remaining() == 0);
    CHECK(contains(message_of([&] { in.read<uint8_t>("more"); }), "byte 16"));
}
