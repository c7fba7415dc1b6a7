// SPDX-License-Identifier: MIT
// Bytes as text (RFC 4648, section 4), for pictures inside of pages.
#pragma once

#include <span>
#include <string>

namespace tress {

std::string base64(std::span<const unsigned char> bytes);

}  // namespace tress
