// SPDX-License-Identifier: MIT
#include "tools/study/study_log.h"

#include <doctest/doctest.h>

#include "core/error.h"
#include "tools/check/support/folder.h"
#include "tools/signature.h"

using namespace tress;
using namespace tress::test;

TEST_CASE("what was measured is found again by its key, what was derived is not kept") {
    const Folder folder;
    const std::string file = folder.file("study.jsonl");
    {
        StudyLog log(file);
        CHECK(log.find("a") == nullptr);
        log.add({{"line", "run"}, {"key", "a"}, {"value", 0.1}});
        log.add({{"line", "run"}, {"key", "b"}, {"value", 1e-300}});
        log.write({{"line", "study"}}, {{{"line", "row"}, {"bias", 2}}});
    }
    CHECK(read_bytes(file) ==
          "{\"line\":\"study\"}\n{\"line\":\"run\",\"key\":\"a\",\"value\":0.1}\n"
          "{\"line\":\"run\",\"key\":\"b\",\"value\":1e-300}\n{\"line\":\"row\",\"bias\":2}\n");
    StudyLog again(file);
    REQUIRE(again.find("b") != nullptr);
    CHECK((*again.find("b"))["value"] == 1e-300);
    again.add({{"line", "run"}, {"key", "c"}});
    CHECK(read_bytes(file).find("bias") == std::string::npos);
    CHECK(folder.entries() == 1);
}

TEST_CASE("a file that is no study's is refused by its line") {
    const Folder folder;
    const std::string file = write_bytes(folder.file("study.jsonl"), "{\"line\":\"study\"}\n{\"line\":\"ru");
    CHECK_THROWS_WITH_AS(StudyLog{file}, doctest::Contains("study.jsonl: line 2"), InputError);
    CHECK_THROWS_AS(StudyLog{write_bytes(file, "[1]\n")}, InputError);
}

TEST_CASE("keys tell where one part ends and the next begins") {
    CHECK(key_of({"ab", "c"}) != key_of({"a", "bc"}));
    CHECK(key_of({"a"}) != key_of({"a", ""}));
    CHECK(key_of({"a"}).size() == 16);
}
