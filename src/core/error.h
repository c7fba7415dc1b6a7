// SPDX-License-Identifier: MIT
// The one exception for what a user got wrong: a file, an option, a scene. It reads as one line.
#pragma once

#include <stdexcept>
#include <string>

namespace tress {

/// `where` names the file and the place in it ("a.hair: byte 128", "scene.json: hair[0].radius", "--spp");
/// `problem` says what was found and what was expected. what() is "where: problem".
class InputError : public std::runtime_error {
public:
    InputError(const std::string& where, const std::string& problem) : std::runtime_error(where + ": " + problem) {}
};

}  // namespace tress
