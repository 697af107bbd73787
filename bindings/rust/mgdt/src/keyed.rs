// SPDX-License-Identifier: MIT
//! Handles whose options, statistics and arrays have keys.

use crate::triangulation::{as_i64, error_of};
use crate::Error;
use mgdt_sys as sys;
use std::os::raw::c_char;

type Status = sys::mgdt_status;

/// The functions of a kind of handle.
pub(crate) struct Calls<H> {
    pub get_error: unsafe extern "C" fn(*const H, i64, *mut c_char) -> Status,
    pub set_option: Option<unsafe extern "C" fn(*mut H, i32, i64) -> Status>,
    pub set_double_option: Option<unsafe extern "C" fn(*mut H, i32, f64) -> Status>,
    pub get_stat: unsafe extern "C" fn(*const H, i32, *mut i64) -> Status,
    pub get_size: unsafe extern "C" fn(*const H, i32, *mut i64) -> Status,
    pub get_array: unsafe extern "C" fn(*const H, i32, i64, *mut i64) -> Status,
    pub get_doubles: Option<unsafe extern "C" fn(*const H, i32, i64, *mut f64) -> Status>,
}

pub(crate) trait Keyed {
    type Handle: 'static;
    const CALLS: Calls<Self::Handle>;

    fn raw(&self) -> *mut Self::Handle;

    fn ensure(&self, status: Status) -> Result<(), Error> {
        if status == sys::MGDT_OK {
            return Ok(());
        }
        Err(error_of(status, |capacity, buffer| unsafe {
            (Self::CALLS.get_error)(self.raw(), capacity, buffer);
        }))
    }

    fn set_option(&mut self, option: i32, value: i64) -> Result<(), Error> {
        self.ensure(match Self::CALLS.set_option {
            Some(set) => unsafe { set(self.raw(), option, value) },
            None => sys::MGDT_ERR_UNKNOWN_KEY,
        })
    }

    fn set_double_option(&mut self, option: i32, value: f64) -> Result<(), Error> {
        self.ensure(match Self::CALLS.set_double_option {
            Some(set) => unsafe { set(self.raw(), option, value) },
            None => sys::MGDT_ERR_UNKNOWN_KEY,
        })
    }

    /// No limit is 0 in C; a limit of 0 would be none at all.
    fn set_limit(&mut self, option: i32, bytes: Option<usize>) -> Result<(), Error> {
        self.set_option(option, bytes.map_or(0, |bytes| as_i64(bytes.max(1))))
    }

    fn stat(&self, key: i32) -> Result<i64, Error> {
        let mut value = 0;
        self.ensure(unsafe { (Self::CALLS.get_stat)(self.raw(), key, &mut value) })?;
        Ok(value)
    }

    fn size(&self, key: i32) -> Result<usize, Error> {
        let mut size = 0;
        self.ensure(unsafe { (Self::CALLS.get_size)(self.raw(), key, &mut size) })?;
        Ok(size as usize)
    }

    fn integers(&self, key: i32) -> Result<Vec<i64>, Error> {
        let mut values = vec![0; self.size(key)?];
        let room = as_i64(values.len());
        self.ensure(unsafe {
            (Self::CALLS.get_array)(self.raw(), key, room, values.as_mut_ptr())
        })?;
        Ok(values)
    }

    fn real_numbers(&self, key: i32) -> Result<Vec<f64>, Error> {
        let mut values = vec![0.0; self.size(key)?];
        let room = as_i64(values.len());
        self.ensure(match Self::CALLS.get_doubles {
            Some(get) => unsafe { get(self.raw(), key, room, values.as_mut_ptr()) },
            None => sys::MGDT_ERR_UNKNOWN_KEY,
        })?;
        Ok(values)
    }

    fn rows(&self, key: i32) -> Result<Vec<[f64; 3]>, Error> {
        let numbers = self.real_numbers(key)?;
        let row = |x: &[f64]| [x[0], x[1], x[2]];
        Ok(numbers.chunks_exact(3).map(row).collect())
    }
}
