#pragma once

#include <recheck/document.hpp>
#include <recheck/place.hpp>

namespace recheck {

/// The document of certificates in a text, format version 1: docs/certificates.md.
///
/// Everything that is read is looked at: members, indices, types, and that bound symbols stay
/// inside their functions.
/// @throws Unreadable
Document document_of(const std::string& text, const Limits& limits);

}  // namespace recheck
