// SPDX-License-Identifier: MIT
use mgdt_sys as sys;
use std::fmt;

/// Why a call failed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// A value out of its range.
    InvalidArgument,
    /// A coordinate is NaN or infinite; the message names the point.
    NotFinite,
    /// No order scheme of that name.
    UnknownScheme,
    /// The slice given holds less than what must be written.
    BufferTooSmall,
    /// A number does not fit the slice's 32-bit integers.
    IndexRange,
    /// The system or the memory limit refused.
    OutOfMemory,
    /// More points or tetrahedra than can be numbered.
    TooLarge,
    /// A [`Canceller`](crate::Canceller) or the progress closure asked to stop.
    Cancelled,
    /// Another call is inside the triangulation, which Rust's own rules leave to foreign code that
    /// has the handle. Since 1.2.
    Busy,
    /// [`check`](crate::Triangulation::check) found a defect; the message says what and where.
    CheckFailed,
    /// Facets, segments or points cross or touch where they must not; the message names the first
    /// pair. Since 1.3.
    InvalidBoundary,
    /// Facets enclose nothing; the message says where they are open. Since 1.3.
    OpenBoundary,
    /// A mesh would need smaller differences than doubles have. Since 1.3.
    Resolution,
    /// There is no result: the call that makes it comes first. Since 1.3.
    NotBuilt,
    /// The library that was loaded has another binary interface than this crate was made for.
    Library,
    /// Anything else: a defect in mgdt.
    Internal,
}

/// What went wrong in a call. When calls fail on one triangulation from several threads at once,
/// the message is that of one of them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    kind: ErrorKind,
    message: String,
}

impl Error {
    pub(crate) fn new(kind: ErrorKind, message: impl Into<String>) -> Error {
        Error {
            kind,
            message: message.into(),
        }
    }

    pub(crate) fn of_status(status: sys::mgdt_status, message: String) -> Error {
        let kind = match status {
            sys::MGDT_ERR_INVALID_ARGUMENT => ErrorKind::InvalidArgument,
            sys::MGDT_ERR_NOT_FINITE => ErrorKind::NotFinite,
            sys::MGDT_ERR_UNKNOWN_SCHEME => ErrorKind::UnknownScheme,
            sys::MGDT_ERR_BUFFER_TOO_SMALL => ErrorKind::BufferTooSmall,
            sys::MGDT_ERR_INDEX_RANGE => ErrorKind::IndexRange,
            sys::MGDT_ERR_OUT_OF_MEMORY => ErrorKind::OutOfMemory,
            sys::MGDT_ERR_TOO_LARGE => ErrorKind::TooLarge,
            sys::MGDT_ERR_CANCELLED => ErrorKind::Cancelled,
            sys::MGDT_ERR_BUSY => ErrorKind::Busy,
            sys::MGDT_ERR_CHECK_FAILED => ErrorKind::CheckFailed,
            sys::MGDT_ERR_INVALID_BOUNDARY => ErrorKind::InvalidBoundary,
            sys::MGDT_ERR_OPEN_BOUNDARY => ErrorKind::OpenBoundary,
            sys::MGDT_ERR_RESOLUTION => ErrorKind::Resolution,
            sys::MGDT_ERR_NOT_BUILT => ErrorKind::NotBuilt,
            _ => ErrorKind::Internal,
        };
        Error { kind, message }
    }

    /// Why the call failed.
    pub fn kind(&self) -> ErrorKind {
        self.kind
    }

    /// What was wrong and where.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}
