//! Places of the source, and the fault that is active at one of them.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::panic::Location;
use std::sync::atomic::{AtomicBool, Ordering};

/// What is computed at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Operation {
    Literal,
    Add,
    Sub,
    Mul,
    Div,
    Neg,
    Squared,
    Powi,
    Powf,
    PowerOfPart,
    Sqrt,
    Rsqrt,
    Abs,
    Copysign,
    Floor,
    Min,
    Max,
    Clamp,
    Exp,
    ExpM1,
    Ln,
    Ln1p,
    Sin,
    Cos,
    /// The angle that goes in counts as the result.
    SinCos,
    SinCosTurns,
    Tan,
    Asin,
    Acos,
    AngleSquared,
    Atan2,
    Erf,
    Erfc,
    ErfInv,
    Select,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    And,
    Or,
    Not,
    X,
    Y,
    Z,
    Dot,
    Cross,
    LengthSquared,
    Normalize,
}

/// An operation at a place of the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub file: &'static str,
    pub line: u32,
    /// Where the expression begins, with its parentheses; of a method, where its name begins.
    pub column: u32,
    pub operation: Operation,
    /// In `a · b · c` both products begin at the same column. The first is link 0; the one whose
    /// left side is the result of link n is link n + 1.
    pub link: u8,
}

/// Links beyond are not told apart: a sum in a loop is a chain too.
const LAST_LINK: u8 = 3;

/// A wrong result from the operands (0 for one that is not there) and the right result. Masks are
/// 0 and 1.
pub type Wrong = fn(f64, f64, f64) -> f64;

/// A wrong result at a place.
#[derive(Debug)]
pub struct Fault {
    pub place: Place,
    wrong: Wrong,
    chained: bool,
    fired: AtomicBool,
}

impl Fault {
    /// Lives as long as the program: models that were built with a fault may be anywhere, and it
    /// is a few words.
    pub fn leak(place: Place, wrong: Wrong) -> &'static Self {
        let chained = place.links() > 1;
        Box::leak(Box::new(Self { place, wrong, chained, fired: AtomicBool::new(false) }))
    }

    /// Whether the place was reached while the fault was armed.
    pub fn has_fired(&self) -> bool {
        self.fired.load(Ordering::Relaxed)
    }
}

/// No place begins in this line.
const NOWHERE: u64 = 0;
const EVERYWHERE: u64 = u64::MAX;

thread_local! {
    /// Line and column of the armed fault; all that an operation looks at as a rule.
    static WATCHED: Cell<u64> = const { Cell::new(NOWHERE) };
    static ARMED: Cell<Option<&'static Fault>> = const { Cell::new(None) };
    /// The result at the watched place before this one, and its link.
    static BEFORE: Cell<(u64, u8)> = const { Cell::new((0, LAST_LINK)) };
    static RECORD: RefCell<Recorder> = const { RefCell::new(Recorder::new()) };
}

fn key(line: u32, column: u32) -> u64 {
    u64::from(line) << 32 | u64::from(column)
}

/// The result of an operation: the right one, or what the armed fault makes of it here.
#[inline(always)]
#[track_caller]
pub(super) fn at(operation: Operation, left: f64, right: f64, result: f64) -> f64 {
    let caller = Location::caller();
    // Unlike `get` it is compiled in place.
    let watched = WATCHED.try_with(Cell::get).unwrap_or(NOWHERE);
    if watched == key(caller.line(), caller.column()) || watched == EVERYWHERE {
        watch_closely(caller, operation, left, right, result)
    } else {
        result
    }
}

fn link_after((before, link): (u64, u8), left: f64) -> u8 {
    if left.to_bits() == before { (link + 1).min(LAST_LINK) } else { 0 }
}

#[cold]
#[inline(never)]
fn watch_closely(
    caller: &'static Location<'static>,
    operation: Operation,
    left: f64,
    right: f64,
    result: f64,
) -> f64 {
    if WATCHED.get() == EVERYWHERE {
        RECORD.with_borrow_mut(|recorder| recorder.note(caller, operation, left, result));
        return result;
    }
    let Some(fault) = ARMED.get() else { return result };
    if operation != fault.place.operation || caller.file() != fault.place.file {
        return result;
    }
    let link = link_after(BEFORE.get(), left);
    let result = if link == fault.place.link || !fault.chained {
        fault.fired.store(true, Ordering::Relaxed);
        (fault.wrong)(left, right, result)
    } else {
        result
    };
    BEFORE.set((result.to_bits(), link));
    result
}

/// What this thread watches, to be put back when dropped.
struct Watch {
    watched: u64,
    armed: Option<&'static Fault>,
}

impl Drop for Watch {
    fn drop(&mut self) {
        WATCHED.set(self.watched);
        ARMED.set(self.armed);
    }
}

/// Arms a fault, or none, on this thread until the answer is dropped.
#[must_use]
fn watch(fault: Option<&'static Fault>) -> Watch {
    let watched = fault.map_or(NOWHERE, |fault| key(fault.place.line, fault.place.column));
    let before = Watch { watched: WATCHED.replace(watched), armed: ARMED.replace(fault) };
    BEFORE.set((0, LAST_LINK));
    before
}

/// Runs something with a fault, or none.
pub fn armed<A>(fault: Option<&'static Fault>, run: impl FnOnce() -> A) -> A {
    let _watch = watch(fault);
    run()
}

/// Runs something without a fault and tells the places of the crate that it reaches.
pub fn record(run: impl FnOnce()) -> BTreeSet<Place> {
    let _watch = watch(None);
    RECORD.set(Recorder::new());
    WATCHED.set(EVERYWHERE);
    run();
    let places = RECORD.with_borrow_mut(Recorder::places);
    // A left side that equals the result before is a coincidence where there are no more links.
    let most = |place: &Place| u8::try_from(place.links().max(1) - 1).unwrap_or(LAST_LINK);
    places.into_iter().map(|place| Place { link: place.link.min(most(&place)), ..place }).collect()
}

/// Runs something without a fault and tells how often it does which operation.
pub fn count(run: impl FnOnce()) -> BTreeMap<Operation, u32> {
    let _watch = watch(None);
    RECORD.set(Recorder::new());
    WATCHED.set(EVERYWHERE);
    run();
    RECORD.with_borrow_mut(|recorder| recorder.counts.drain(..).flatten().collect())
}

/// What was done at each line, column and operation.
struct Recorder {
    /// How often each operation was done, in the order of the operations.
    counts: Vec<Option<(Operation, u32)>>,
    last: Vec<Option<Last>>,
    /// Of the places that had to leave their slot.
    before: BTreeMap<(Spot, Operation), [u32; LINKS]>,
}

/// File, line and column.
type Spot = (&'static str, u32, u32);
const LINKS: usize = LAST_LINK as usize + 1;

#[derive(Clone, Copy)]
struct Last {
    place: (Spot, Operation),
    result: u64,
    link: u8,
    /// How often each link was done.
    done: [u32; LINKS],
}

impl Recorder {
    const fn new() -> Self {
        Self { counts: Vec::new(), last: Vec::new(), before: BTreeMap::new() }
    }

    /// Two places that share a slot push each other out, which costs time and changes nothing.
    fn note(
        &mut self,
        caller: &'static Location<'static>,
        operation: Operation,
        left: f64,
        result: f64,
    ) {
        const SLOTS: usize = 1 << 14;
        if self.counts.len() <= operation as usize {
            self.counts.resize(operation as usize + 1, None);
        }
        self.counts[operation as usize].get_or_insert((operation, 0)).1 += 1;
        self.last.resize(SLOTS, None);
        let spot @ (file, line, column) = (caller.file(), caller.line(), caller.column());
        let number = key(line, column) * 64 + operation as u64;
        let id = number.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ file.len() as u64;
        let slot = &mut self.last[(id.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 50) as usize];
        let fresh = Last { place: (spot, operation), result: 0, link: LAST_LINK, done: [0; LINKS] };
        if let Some(other) = slot.take_if(|last| last.place != fresh.place) {
            add(&mut self.before, &other);
        }
        let last = slot.get_or_insert(fresh);
        last.link = link_after((last.result, last.link), left);
        last.result = result.to_bits();
        last.done[usize::from(last.link)] += 1;
    }

    /// The places of the crate. The links of a chain are all done equally often; a left side that
    /// equals the result before more seldom than not is a coincidence.
    fn places(&mut self) -> BTreeSet<Place> {
        let mut done = std::mem::take(&mut self.before);
        self.last.drain(..).flatten().for_each(|last| add(&mut done, &last));
        let of_crate = done.into_iter().filter(|(((file, ..), _), _)| file.starts_with("src/"));
        of_crate
            .flat_map(|(((file, line, column), operation), done)| {
                let links = (1..LINKS).take_while(move |&link| 2 * done[link] > done[link - 1]);
                let links = [0].into_iter().chain(links).map(|link| link as u8);
                links.map(move |link| Place { file, line, column, operation, link })
            })
            .collect()
    }
}

fn add(done: &mut BTreeMap<(Spot, Operation), [u32; LINKS]>, last: &Last) {
    let sums = done.entry(last.place).or_insert([0; LINKS]);
    for (sum, count) in sums.iter_mut().zip(last.done) {
        *sum += count;
    }
}
