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
    // All processes get the message of the first part that has failed, as a sum of words to which
    // all other processes contribute zeros.
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
    // A faulty transport may leave the text without an end.
    agreed.message[Error::message_size - 1] = '\0';
    if (agreed.status <= MGDT_OK) agreed.status = MGDT_ERR_TRANSPORT;
    throw agreed;
}

void Collective::require(bool succeeded) {
    if (succeeded) return;
    // The transport has failed, so the other processes cannot be told.
    has_failed_ = true;
    fail(MGDT_ERR_TRANSPORT, "part %u: the transport failed", first_local());
}

void Collective::report(const Error& error) {
    // If agree() has thrown already, all processes know the error.
    if (has_failed_) throw error;
    agree(&error);
    throw error;
}

}  // namespace mgdt
