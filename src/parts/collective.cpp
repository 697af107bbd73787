// SPDX-License-Identifier: MIT
#include "parts/collective.hpp"

#include <cstring>
#include <limits>

namespace mgdt {
namespace {

constexpr double nobody = std::numeric_limits<double>::infinity();

}  // namespace

void Collective::agree(const Error* mine) {
    double first = mine ? first_local() : nobody;
    require(transport_.least(&first, 1));
    if (first == nobody) return;
    has_failed_ = true;
    // All but the first that has failed add nothing to what it says.
    constexpr std::size_t words = Error::message_size / sizeof(std::uint64_t);
    std::uint64_t said[1 + words] = {};
    if (mine && first == first_local()) {
        said[0] = static_cast<std::uint64_t>(mine->status);
        char message[Error::message_size] = {};
        if (part_ == no_part || parts() == 1)
            std::snprintf(message, sizeof message, "%s", mine->message);
        else
            std::snprintf(message, sizeof message, "part %u: %.*s", part_, Error::message_size - 20,
                          mine->message);
        std::memcpy(said + 1, message, sizeof message);
    }
    require(transport_.sum(said, 1 + words));
    Error agreed;
    agreed.status = static_cast<mgdt_status>(said[0]);
    std::memcpy(agreed.message, said + 1, sizeof agreed.message);
    // As a transport that does not add up may leave it.
    agreed.message[Error::message_size - 1] = '\0';
    if (agreed.status <= MGDT_OK) agreed.status = MGDT_ERR_TRANSPORT;
    throw agreed;
}

void Collective::require(bool succeeded) {
    if (succeeded) return;
    // Nothing more can be said to the others.
    has_failed_ = true;
    fail(MGDT_ERR_TRANSPORT, "part %u: the transport failed", first_local());
}

void Collective::report(const Error& error) {
    // What the others have told is known everywhere.
    if (has_failed_) throw error;
    agree(&error);
    throw error;
}

}  // namespace mgdt
