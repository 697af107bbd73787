// SPDX-License-Identifier: MIT
use crate::names::text;
use crate::{Check, Error, ErrorKind, Order, Parameter, Statistic};
use mgdt_sys as sys;
use std::any::Any;
use std::ffi::{CStr, CString};
use std::fmt;
use std::ops::ControlFlow;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr;
use std::sync::{Arc, Mutex, MutexGuard};

/// The handle, for those who may cancel; None once the triangulation is gone.
struct Shared(Mutex<Option<ptr::NonNull<sys::mgdt_triangulation>>>);

// Only mgdt_cancel is called through it, which is safe from any thread, and the lock keeps the
// handle from being destroyed meanwhile.
unsafe impl Send for Shared {}
unsafe impl Sync for Shared {}

impl Shared {
    fn lock(&self) -> MutexGuard<'_, Option<ptr::NonNull<sys::mgdt_triangulation>>> {
        self.0
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

/// Stops the insertion that runs on a triangulation; made by [`Triangulation::canceller`].
#[derive(Clone)]
pub struct Canceller(Arc<Shared>);

impl Canceller {
    /// Asks the insertion that is running to stop soon, or else the next one. Does nothing if the
    /// triangulation is gone.
    pub fn cancel(&self) {
        if let Some(t) = *self.0.lock() {
            unsafe { sys::mgdt_cancel(t.as_ptr()) };
        }
    }
}

impl fmt::Debug for Canceller {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Canceller")
    }
}

/// A Delaunay triangulation that grows as points are inserted.
///
/// The k-th point ever given has number k, counted from 0. Points equal to an earlier one share its
/// vertex; points that do not span space wait until later ones do.
pub struct Triangulation {
    t: ptr::NonNull<sys::mgdt_triangulation>,
    shared: Arc<Shared>,
}

// A handle is bound to no thread. What takes &self passes a const pointer, which the library allows
// from many threads at once.
unsafe impl Send for Triangulation {}
unsafe impl Sync for Triangulation {}

impl Drop for Triangulation {
    fn drop(&mut self) {
        *self.shared.lock() = None;
        unsafe { sys::mgdt_destroy(self.t.as_ptr()) };
    }
}

impl fmt::Debug for Triangulation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Triangulation")
            .field("points", &self.point_count())
            .field("tetrahedra", &self.tetrahedron_count())
            .finish()
    }
}

impl Triangulation {
    /// An empty triangulation.
    pub fn new() -> Result<Triangulation, Error> {
        let abi = unsafe { sys::mgdt_abi_version() };
        if abi != 1 {
            return Err(Error::new(
                ErrorKind::Library,
                format!("libmgdt has ABI version {}; the crate mgdt needs 1", abi),
            ));
        }
        let mut out = ptr::null_mut();
        let status = unsafe { sys::mgdt_create(&mut out) };
        match ptr::NonNull::new(out) {
            Some(t) if status == sys::MGDT_OK => Ok(Triangulation {
                t,
                shared: Arc::new(Shared(Mutex::new(Some(t)))),
            }),
            _ => Err(Error::of_status(status, status_text(status))),
        }
    }

    pub(crate) fn raw(&self) -> *const sys::mgdt_triangulation {
        self.t.as_ptr()
    }

    fn raw_mut(&mut self) -> *mut sys::mgdt_triangulation {
        self.t.as_ptr()
    }

    /// The error of a status that this handle's call returned.
    pub(crate) fn ensure(&self, status: sys::mgdt_status) -> Result<(), Error> {
        if status == sys::MGDT_OK {
            return Ok(());
        }
        Err(error_of(status, |capacity, buffer| unsafe {
            sys::mgdt_get_error(self.raw(), capacity, buffer);
        }))
    }

    // ------------------------------------------------------------------------------- settings

    /// Takes all points out; settings stay.
    pub fn clear(&mut self) {
        // It fails for NULL alone.
        unsafe { sys::mgdt_clear(self.raw_mut()) };
    }

    /// Announces how many points will be given in all. Optional.
    pub fn reserve(&mut self, points: usize) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_reserve(self.raw_mut(), as_i64(points)) };
        self.ensure(status)
    }

    /// Frees what is kept for speed alone: room for points to come, working arrays, where locations
    /// start. All is made again when it is wanted. Since 1.2.
    pub fn shrink(&mut self) {
        // It fails for NULL alone.
        unsafe { sys::mgdt_shrink(self.raw_mut()) };
    }

    /// Chooses the order scheme of later insertions.
    pub fn set_order(&mut self, order: Order) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_set_order_scheme(self.raw_mut(), order as i32) };
        self.ensure(status)
    }

    /// Sets a parameter of the order schemes. A [`Separation`](crate::Separation) becomes a number by
    /// `into()`.
    pub fn set_parameter(&mut self, parameter: Parameter, value: f64) -> Result<(), Error> {
        let status =
            unsafe { sys::mgdt_set_order_parameter(self.raw_mut(), parameter as i32, value) };
        self.ensure(status)
    }

    /// Sets the seed of the schemes that shuffle.
    pub fn set_seed(&mut self, seed: u64) {
        unsafe { sys::mgdt_set_seed(self.raw_mut(), seed) };
    }

    /// Sets how many threads a call may use; 0 for all cores.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        let n = i32::try_from(threads).unwrap_or(i32::MAX);
        let status = unsafe { sys::mgdt_set_threads(self.raw_mut(), n) };
        self.ensure(status)
    }

    /// Limits the memory that the triangulation may hold, in bytes; None for no limit.
    pub fn set_memory_limit(&mut self, bytes: Option<usize>) -> Result<(), Error> {
        // No limit is 0 there; a limit of 0 would be none at all.
        let limit = bytes.map_or(0, |bytes| as_i64(bytes.max(1)));
        let status = unsafe { sys::mgdt_set_memory_limit(self.raw_mut(), limit) };
        self.ensure(status)
    }

    /// Whether a [`Canceller`](crate::Canceller) stops calls that only read, such as `check`, too.
    /// Since 1.3.
    pub fn set_read_progress(&mut self, on: bool) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_set_read_progress(self.raw_mut(), i32::from(on)) };
        self.ensure(status)
    }

    /// Compact storage: 30 % less memory, 20 to 40 % more time. At any time; what it gives
    /// back, `false` needs again, and if that is refused nothing has changed. Since 1.1.
    pub fn set_compact(&mut self, on: bool) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_set_compact(self.raw_mut(), i32::from(on)) };
        self.ensure(status)
    }

    /// Makes the output a function of the set of points alone.
    pub fn set_canonical_output(&mut self, on: bool) {
        unsafe { sys::mgdt_set_canonical_output(self.raw_mut(), i32::from(on)) };
    }

    /// Chooses the instruction set: "baseline", "avx2", "avx512", "neon"; None for the best.
    pub fn set_isa(&mut self, name: Option<&str>) -> Result<(), Error> {
        let name = name.map(CString::new).transpose().map_err(|_| {
            Error::new(
                ErrorKind::InvalidArgument,
                "an instruction set's name holds a zero byte",
            )
        })?;
        let pointer = name.as_ref().map_or(ptr::null(), |s| s.as_ptr());
        let status = unsafe { sys::mgdt_set_isa(self.raw_mut(), pointer) };
        self.ensure(status)
    }

    /// One setting; its getter fails for NULL alone.
    fn setting<T: Default>(
        &self,
        get: unsafe extern "C" fn(*const sys::mgdt_triangulation, *mut T) -> sys::mgdt_status,
    ) -> T {
        let mut value = T::default();
        unsafe { get(self.raw(), &mut value) };
        value
    }

    /// The order scheme; None for one of a later version than this crate's. Since 1.2.
    pub fn order(&self) -> Option<Order> {
        let scheme = self.setting(sys::mgdt_get_order_scheme);
        Order::ALL.into_iter().find(|&order| order as i32 == scheme)
    }

    /// A parameter of the order schemes; 0 where each scheme has a default of its own. Since 1.2.
    pub fn parameter(&self, parameter: Parameter) -> f64 {
        let mut value = 0.0;
        unsafe { sys::mgdt_get_order_parameter(self.raw(), parameter as i32, &mut value) };
        value
    }

    /// The seed of the schemes that shuffle. Since 1.2.
    pub fn seed(&self) -> u64 {
        self.setting(sys::mgdt_get_seed)
    }

    /// How many threads a call may use; 0 for all cores. Since 1.2.
    pub fn threads(&self) -> usize {
        self.setting(sys::mgdt_get_threads) as usize
    }

    /// The memory limit in bytes; None for no limit. Since 1.2.
    pub fn memory_limit(&self) -> Option<usize> {
        match self.setting(sys::mgdt_get_memory_limit) {
            0 => None,
            bytes => Some(bytes as usize),
        }
    }

    /// Whether calls that only read can be cancelled. Since 1.3.
    pub fn read_progress(&self) -> bool {
        self.setting(sys::mgdt_get_read_progress) != 0
    }

    /// Whether storage is compact. Since 1.2.
    pub fn compact(&self) -> bool {
        self.setting(sys::mgdt_get_compact) != 0
    }

    /// Whether the output is a function of the set of points alone. Since 1.2.
    pub fn canonical_output(&self) -> bool {
        self.setting(sys::mgdt_get_canonical_output) != 0
    }

    /// Name of the instruction set in use.
    pub fn isa(&self) -> &'static str {
        text(unsafe { sys::mgdt_isa_name(self.raw()) }).unwrap_or("")
    }

    /// What stops insertions, from any thread.
    pub fn canceller(&self) -> Canceller {
        Canceller(Arc::clone(&self.shared))
    }

    // --------------------------------------------------------------------------------- points

    /// Inserts points, in any number of calls. An error on the points themselves
    /// ([`ErrorKind::NotFinite`]) changes nothing; after [`ErrorKind::OutOfMemory`],
    /// [`ErrorKind::TooLarge`] or [`ErrorKind::Cancelled`] this is a valid triangulation of the
    /// points that got in.
    pub fn insert(&mut self, points: &[[f64; 3]]) -> Result<(), Error> {
        let n = as_i64(points.len());
        let status =
            unsafe { sys::mgdt_insert_points(self.raw_mut(), n, points.as_ptr().cast::<f64>()) };
        self.ensure(status)
    }

    /// The same with a closure that hears of progress, the fraction done from 0 to 1, about a
    /// hundred times, and may stop the insertion. A panic in it stops the insertion and goes on
    /// here.
    pub fn insert_with_progress<F>(&mut self, points: &[[f64; 3]], progress: F) -> Result<(), Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        let n = as_i64(points.len());
        let t = self.raw_mut();
        let status = watched(progress, |report, user| unsafe {
            sys::mgdt_set_progress(t, Some(report), user);
            let status = sys::mgdt_insert_points(t, n, points.as_ptr().cast::<f64>());
            sys::mgdt_set_progress(t, None, ptr::null_mut());
            status
        });
        self.ensure(status)
    }

    /// The same for coordinates in separate slices of one length.
    pub fn insert_columns(&mut self, x: &[f64], y: &[f64], z: &[f64]) -> Result<(), Error> {
        if x.len() != y.len() || x.len() != z.len() {
            return Err(Error::new(
                ErrorKind::InvalidArgument,
                format!(
                    "x, y and z have {}, {} and {} elements",
                    x.len(),
                    y.len(),
                    z.len()
                ),
            ));
        }
        self.insert_strided(x.len(), x, y, z, 1)
    }

    /// The same for the coordinates of `n` points inside records: x, y and z start at the first
    /// point's, and the next point's are `stride` doubles on.
    pub fn insert_strided(
        &mut self,
        n: usize,
        x: &[f64],
        y: &[f64],
        z: &[f64],
        stride: usize,
    ) -> Result<(), Error> {
        for (name, axis) in [("x", x), ("y", y), ("z", z)] {
            let last = n.saturating_sub(1).checked_mul(stride);
            if n > 0 && last.map_or(true, |last| last >= axis.len()) {
                return Err(Error::new(
                    ErrorKind::InvalidArgument,
                    format!(
                        "{} has {} elements, too few for {} points at a stride of {}",
                        name,
                        axis.len(),
                        n,
                        stride
                    ),
                ));
            }
        }
        let status = unsafe {
            sys::mgdt_insert_points_strided(
                self.raw_mut(),
                as_i64(n),
                x.as_ptr(),
                y.as_ptr(),
                z.as_ptr(),
                as_i64(stride),
            )
        };
        self.ensure(status)
    }

    /// Takes points out, given by their numbers, each once; the others keep theirs. A number of no
    /// point that is in changes nothing. After [`ErrorKind::OutOfMemory`] as many of the points are out as the
    /// message says. Since 1.2.
    pub fn remove(&mut self, points: &[usize]) -> Result<(), Error> {
        let list = as_numbers(points);
        let status =
            unsafe { sys::mgdt_remove_points(self.raw_mut(), as_i64(list.len()), list.as_ptr()) };
        self.ensure(status)
    }

    /// Moves points, given by their numbers, each once, to as many places. After
    /// [`ErrorKind::OutOfMemory`] the first points of the list have moved, as many as the message
    /// says. Since 1.2.
    pub fn move_points(&mut self, points: &[usize], places: &[[f64; 3]]) -> Result<(), Error> {
        if points.len() != places.len() {
            return Err(Error::new(
                ErrorKind::InvalidArgument,
                format!("there are {} points and {} places", points.len(), places.len()),
            ));
        }
        let list = as_numbers(points);
        let status = unsafe {
            sys::mgdt_move_points(
                self.raw_mut(),
                as_i64(list.len()),
                list.as_ptr(),
                places.as_ptr().cast::<f64>(),
            )
        };
        self.ensure(status)
    }

    /// Moves all points, in their order; those that are not in stay out. Since 1.2.
    pub fn move_all(&mut self, places: &[[f64; 3]]) -> Result<(), Error> {
        let n = as_i64(places.len());
        let xyz = places.as_ptr().cast::<f64>();
        let status = unsafe { sys::mgdt_move_points(self.raw_mut(), n, ptr::null(), xyz) };
        self.ensure(status)
    }

    /// Numbers the points that are in anew, in their order from 0 on, and forgets the others. For
    /// each point its new number, or None if it was not in. Since 1.2.
    pub fn renumber(&mut self) -> Result<Vec<Option<usize>>, Error> {
        let mut numbers = vec![0i64; self.point_count()];
        let n = as_i64(numbers.len());
        let status =
            unsafe { sys::mgdt_renumber_points(self.raw_mut(), n, numbers.as_mut_ptr()) };
        self.ensure(status)?;
        Ok(numbers.into_iter().map(|k| usize::try_from(k).ok()).collect())
    }

    // --------------------------------------------------------------------------------- counts

    /// Number of points ever given, those left out that [`renumber`](Self::renumber) forgot.
    pub fn point_count(&self) -> usize {
        unsafe { sys::mgdt_point_count(self.raw()) as usize }
    }

    /// Number of vertices: distinct points that are in.
    pub fn vertex_count(&self) -> usize {
        unsafe { sys::mgdt_vertex_count(self.raw()) as usize }
    }

    /// Dimension of the points' affine hull, 0 to 3; None if there are no points. There are
    /// tetrahedra only at 3.
    pub fn dimension(&self) -> Option<usize> {
        usize::try_from(unsafe { sys::mgdt_dimension(self.raw()) }).ok()
    }

    /// Number of tetrahedra.
    pub fn tetrahedron_count(&self) -> usize {
        unsafe { sys::mgdt_tetrahedron_count(self.raw()) as usize }
    }

    /// Number of triangles on the convex hull.
    pub fn hull_facet_count(&self) -> usize {
        unsafe { sys::mgdt_hull_facet_count(self.raw()) as usize }
    }

    /// Number of edges.
    pub fn edge_count(&self) -> usize {
        unsafe { sys::mgdt_edge_count(self.raw()) as usize }
    }

    // ------------------------------------------------------------------------- trust, figures

    /// Proves the triangulation by exact arithmetic, in linear time.
    pub fn check(&self, level: Check) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_check(self.raw(), level as i32) })
    }

    /// One figure.
    pub fn statistic(&self, statistic: Statistic) -> f64 {
        let mut value = 0.0;
        unsafe { sys::mgdt_get_stat(self.raw(), statistic as i32, &mut value) };
        value
    }
}

pub(crate) fn as_i64(n: usize) -> i64 {
    // What is larger is more than there can be, and is refused as such.
    i64::try_from(n).unwrap_or(i64::MAX)
}

fn as_numbers(points: &[usize]) -> Vec<i64> {
    points.iter().map(|&k| as_i64(k)).collect()
}

pub(crate) fn status_text(status: sys::mgdt_status) -> String {
    text(unsafe { sys::mgdt_status_string(status) })
        .unwrap_or("")
        .to_string()
}

/// The error of a status, with the message that `get` writes into a buffer of a capacity.
pub(crate) fn error_of(
    status: sys::mgdt_status,
    get: impl FnOnce(i64, *mut c_char),
) -> Error {
    let mut buffer = [0 as c_char; 256];
    get(buffer.len() as i64, buffer.as_mut_ptr());
    let message = unsafe { CStr::from_ptr(buffer.as_ptr()) }
        .to_string_lossy()
        .into_owned();
    let message = if message.is_empty() {
        status_text(status)
    } else {
        message
    };
    Error::of_status(status, message)
}

type Report = unsafe extern "C" fn(f64, *mut c_void) -> i32;

/// Makes a call of the library while `progress` hears: `call` gets what the library calls, and the
/// pointer that it passes. A panic of `progress` goes on here.
pub(crate) fn watched<F>(
    progress: F,
    call: impl FnOnce(Report, *mut c_void) -> sys::mgdt_status,
) -> sys::mgdt_status
where
    F: FnMut(f64) -> ControlFlow<()>,
{
    let mut watch = Watch {
        progress,
        panic: None,
    };
    let user: *mut Watch<F> = &mut watch;
    let status = call(report::<F>, user.cast());
    if let Some(panic) = watch.panic.take() {
        resume_unwind(panic);
    }
    status
}

struct Watch<F> {
    progress: F,
    panic: Option<Box<dyn Any + Send>>,
}

/// What the library calls. A panic must not pass through it, and what panicked is not called again.
unsafe extern "C" fn report<F>(fraction: f64, user: *mut c_void) -> i32
where
    F: FnMut(f64) -> ControlFlow<()>,
{
    let watch = &mut *user.cast::<Watch<F>>();
    if watch.panic.is_some() {
        return 1;
    }
    match catch_unwind(AssertUnwindSafe(|| (watch.progress)(fraction))) {
        Ok(ControlFlow::Continue(())) => 0,
        Ok(ControlFlow::Break(())) => 1,
        Err(panic) => {
            watch.panic = Some(panic);
            1
        }
    }
}
