//! The analysis of one parallel loop: which accesses clash, and what view each gets.

use std::collections::{BTreeMap, BTreeSet};

use syn::Ident;

use super::branches::calls_behind_branches;
use super::model::{Access, Action, Boundary, Group, Kernel, Linear, Op, Place, Slot};

/// What an access means for others.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Use {
    Read,
    Write,
    /// A compound assignment, with the group that it accumulates in.
    Update(Op, Option<Group>),
    /// A change that returns the old value.
    Exchange,
}

impl Access {
    /// What the access means for others.
    pub(crate) fn usage(&self) -> Use {
        match &self.action {
            Action::Read => Use::Read,
            Action::Write { .. } => Use::Write,
            Action::Update { op, .. } => Use::Update(*op, op.group()),
            Action::Exchange { .. } => Use::Exchange,
        }
    }

    /// Whether it changes the field.
    pub(crate) fn changes(&self) -> bool {
        self.usage() != Use::Read
    }

    /// Whether the member is handed to a function, which has the index.
    pub(crate) fn is_lent(&self) -> bool {
        matches!(self.boundary, Boundary::Lent)
    }

    /// Whether every iteration has this index for itself.
    pub(crate) fn is_own(&self) -> bool {
        matches!(self.place, Place::Own | Place::Places(_))
    }

    /// Whether it could be an accumulation: a compound assignment of a member or a component, of a group.
    fn accumulates(&self) -> Option<Group> {
        match &self.action {
            Action::Update { op, .. } => op.group(),
            _ => None,
        }
    }

    /// Whether two accesses may concern the same memory if their indices are the same.
    fn overlaps(&self, other: &Access) -> bool {
        let shorter = self.path.len().min(other.path.len());
        self.field == other.field && self.path[..shorter] == other.path[..shorter]
    }

    /// Whether two iterations could meet in one element by these accesses, or by one of them twice, and one changes it.
    fn meets(&self, other: &Access) -> bool {
        let apart = self.is_own() && other.is_own() && (std::ptr::eq(self, other) || !self.places_differ(other));
        self.overlaps(other) && (self.changes() || other.changes()) && !apart
    }

    /// Whether some loop variable stands in no common place of two own indices.
    fn places_differ(&self, other: &Access) -> bool {
        match (&self.place, &other.place) {
            (Place::Places(a), Place::Places(b)) => {
                let count = a.iter().chain(b).filter_map(Slot::variable).max().map_or(0, |last| last + 1);
                let together = |variable| {
                    a.iter().zip(b).any(|(a, b)| a.variable() == Some(variable) && b.variable() == Some(variable))
                };
                a.len() != b.len() || !(0..count).all(together)
            }
            (Place::Own, Place::Own) => false,
            _ => true,
        }
    }
}

impl Slot {
    fn variable(&self) -> Option<usize> {
        match self {
            Slot::Variable(number) => Some(*number),
            Slot::Free => None,
        }
    }
}

/// Two accesses that must not stand in one parallel loop; both may be the same one.
pub(crate) struct Clash {
    /// Where the error stands: the access that is not at the own index, if either.
    pub(crate) access: usize,
    pub(crate) other: usize,
    pub(crate) why: Why,
}

/// Why two accesses clash.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Why {
    /// A plain write at an index that iterations may share.
    Scatter,
    /// The same with an operator that is no accumulation.
    OperatorScatter,
    /// A read at another index beside a write at the own.
    Stencil,
    /// A read beside an accumulation.
    ReadBesideAccumulation,
    /// A write beside an accumulation at any index.
    WriteBesideAccumulation,
    /// Accumulations of two groups.
    Groups,
    /// Own indices with the variables in different places.
    Places,
    /// An old value that is taken, beside a use of another kind.
    OldValue,
    /// The same with an operator that is not one step, where iterations may meet.
    RelaxedOperator,
}

/// The clashes of a loop: for each field and reason, the first of each pair of kinds.
pub(crate) fn clashes(kernel: &Kernel, number: usize) -> Vec<Clash> {
    let mut found =
        if kernel.loops[number].relaxed { relaxed_clashes(kernel, number) } else { all_clashes(kernel, number) };
    // One error for each member and reason: the others are the same fault.
    let mut seen: Vec<(usize, &[Ident], Why)> = Vec::new();
    found.retain(|clash| {
        let access = kernel.access(clash.access);
        let key = (access.field, access.path.as_slice(), clash.why);
        let distinct = matches!(clash.why, Why::Scatter | Why::OperatorScatter | Why::RelaxedOperator);
        let new = distinct || !seen.contains(&key);
        seen.push(key);
        new
    });
    found
}

/// What clashes where iterations may meet: accesses that are not one step for each component.
fn relaxed_clashes(kernel: &Kernel, number: usize) -> Vec<Clash> {
    let shared = shared(kernel, number);
    let other = |node: usize| {
        let met = |other: &&usize| kernel.access(node).meets(kernel.access(**other));
        shared.iter().find(met).copied().unwrap_or(node)
    };
    let why = |node: &usize| match kernel.access(*node) {
        access if access.is_lent() => Some(Why::Stencil),
        access => match access.usage() {
            Use::Update(_, None) => Some(Why::RelaxedOperator),
            _ => None,
        },
    };
    shared.iter().filter_map(|node| why(node).map(|why| Clash { access: *node, other: other(*node), why })).collect()
}

/// The accesses of a relaxed loop by which iterations may meet in elements.
fn shared(kernel: &Kernel, number: usize) -> BTreeSet<usize> {
    let mut shared: BTreeSet<usize> =
        all_clashes(kernel, number).iter().flat_map(|clash| [clash.access, clash.other]).collect();
    // Whatever meets one of them must be as careful.
    loop {
        let known = shared.len();
        for &node in &kernel.loops[number].accesses {
            if shared.iter().any(|other| kernel.access(node).meets(kernel.access(*other))) {
                shared.insert(node);
            }
        }
        if shared.len() == known {
            return shared;
        }
    }
}

/// Every pair of accesses that must not stand in one parallel loop.
fn all_clashes(kernel: &Kernel, number: usize) -> Vec<Clash> {
    let accesses = &kernel.loops[number].accesses;
    let mut found: Vec<Clash> = Vec::new();
    for (place, &b) in accesses.iter().enumerate() {
        if let Some(why) = alone(kernel.access(b)) {
            found.push(Clash { access: b, other: b, why });
            continue;
        }
        for &a in &accesses[..place] {
            if alone(kernel.access(a)).is_some() {
                continue;
            }
            if let Some((access, other, why)) = pair(kernel, number, a, b) {
                found.push(Clash { access, other, why });
            }
        }
    }
    found
}

/// Why an access cannot stand in a parallel loop at all.
fn alone(access: &Access) -> Option<Why> {
    if access.is_own() {
        return None;
    }
    match &access.action {
        Action::Read => None,
        Action::Write { .. } => Some(Why::Scatter),
        Action::Update { op, .. } if op.group().is_none() => Some(Why::OperatorScatter),
        Action::Update { .. } | Action::Exchange { .. } => None,
    }
}

/// Why two accesses cannot stand in one parallel loop, with the one to complain about first.
fn pair(kernel: &Kernel, number: usize, first: usize, second: usize) -> Option<(usize, usize, Why)> {
    let (a, b) = (kernel.access(first), kernel.access(second));
    if !a.overlaps(b) || !(a.changes() || b.changes()) {
        return None;
    }
    if a.is_own() && b.is_own() {
        return a.places_differ(b).then_some((second, first, Why::Places));
    }
    if let (Some(x), Some(y)) = (a.accumulates(), b.accumulates()) {
        return (x != y).then_some((second, first, Why::Groups));
    }
    match (a.usage(), b.usage()) {
        (Use::Exchange, Use::Exchange) => return None,
        (Use::Exchange, _) => return Some((second, first, Why::OldValue)),
        (_, Use::Exchange) => return Some((first, second, Why::OldValue)),
        _ => {}
    }
    // One of the two is at a foreign index, and both are not accumulations.
    let (foreign, other) = if a.is_own() || (!b.is_own() && a.changes()) { (second, first) } else { (first, second) };
    let (f, o) = (kernel.access(foreign), kernel.access(other));
    if o.changes() && across(kernel, number, f) == Across::Yes && matches!(o.place, Place::Own) {
        return None;
    }
    let why = match (f.changes(), o.changes()) {
        (false, true) if o.is_own() => Why::Stencil,
        (false, true) | (true, false) => Why::ReadBesideAccumulation,
        _ => Why::WriteBesideAccumulation,
    };
    Some((foreign, other, why))
}

/// Whether a read leads from one colour of a checkerboard to the other, or for the elements next to an edge to the
/// iteration's own: if not, why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Across {
    Yes,
    /// The loop is over all colours, or over others than those of a checkerboard.
    NoCheckerboard,
    /// The index is not the loop's own plus constants, or the number of axes is not known.
    NotConstant,
    /// The constants have an even sum.
    Even,
    /// A clamped read by more than one step.
    Steps,
    /// A clamped or wrapped read of another field than the loop is over.
    Elsewhere,
}

/// Whether a read leads to the other colour of the loop's checkerboard.
pub(crate) fn across(kernel: &Kernel, number: usize, access: &Access) -> Across {
    let parallel = &kernel.loops[number];
    if !parallel.head.is_checkerboard() {
        return Across::NoCheckerboard;
    }
    let offset = match &access.place {
        Place::Offset(offset) if parallel.rank == Some(offset.len()) && !access.changes() => offset,
        _ => return Across::NotConstant,
    };
    let steps: u64 = offset.iter().map(|o| u64::from(o.unsigned_abs())).sum();
    let at_home = parallel.head.field() == Some(access.field);
    match access.boundary {
        _ if steps.is_multiple_of(2) => Across::Even,
        Boundary::Clamped if steps != 1 => Across::Steps,
        Boundary::Clamped | Boundary::Wrapped if !at_home => Across::Elsewhere,
        _ => Across::Yes,
    }
}

/// How the expansion reaches a member.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum View {
    /// Own index, no check.
    Own,
    /// Own index in other places, checked.
    OwnFree,
    /// Read at the own index plus a constant; empty for none over axes whose number is not known.
    Row(Vec<i32>),
    /// Read at any index.
    Any,
    /// Read at the own index plus a constant, of the other colour than the loop's, which alone is written.
    Beside(Vec<i32>),
    /// Accumulate at any index.
    Accumulate,
    /// Any index, where iterations may meet: one step a component.
    Together,
    /// The same, to accumulate.
    AccumulateTogether,
}

impl View {
    /// Whether iterations may meet in one element.
    pub(crate) fn is_together(&self) -> bool {
        matches!(self, View::Together | View::AccumulateTogether)
    }
}

/// A view of a member.
#[derive(Clone)]
pub(crate) struct Planned {
    pub(crate) field: usize,
    pub(crate) path: Vec<Ident>,
    pub(crate) view: View,
}

/// Boxes of offsets, a field each: the lowest and highest along each axis.
pub(crate) type Reach = BTreeMap<usize, (Vec<i32>, Vec<i32>)>;

/// What the expansion of a loop needs to know beside the model.
#[derive(Clone)]
pub(crate) struct Plan {
    /// The views, in the order of first use.
    pub(crate) views: Vec<Planned>,
    /// The view of each access, by node.
    pub(crate) view_of: BTreeMap<usize, usize>,
    /// The fields in use, and whether the loop changes them.
    pub(crate) fields: BTreeMap<usize, bool>,
    /// Whether own writes are held back until the end of a run.
    pub(crate) light: bool,
    /// Whether whole runs are written out apart from cut ones: the body is small, and vector loops may come of it.
    pub(crate) written_out: bool,
    /// Fields with two own views that overlap, or accessed without a check: their values are never held back.
    pub(crate) overlapping: Vec<usize>,
    /// The offsets to check once a launch.
    pub(crate) reach: Reach,
    /// The multiples of the loop's variables to check once a launch, and their fields.
    pub(crate) boxes: Vec<(usize, Vec<Linear>)>,
    /// The box of each access that has one, by node.
    pub(crate) box_of: BTreeMap<usize, usize>,
    /// The largest offset along each axis.
    pub(crate) halo: Option<Vec<i32>>,
    /// The fields accumulated into, in the order of their slots, with their members.
    pub(crate) targets: Vec<(usize, Vec<Accumulated>)>,
}

/// A member, and the group of operators that accumulates into it.
pub(crate) type Accumulated = (Vec<Ident>, Group);

/// Plans a loop without clashes.
pub(crate) fn plan(kernel: &Kernel, number: usize) -> Plan {
    let parallel = &kernel.loops[number];
    let mut plan = Plan {
        views: Vec::new(),
        view_of: BTreeMap::new(),
        fields: BTreeMap::new(),
        light: !parallel.loops && parallel.topology.is_empty(),
        written_out: false,
        overlapping: Vec::new(),
        reach: BTreeMap::new(),
        boxes: Vec::new(),
        box_of: BTreeMap::new(),
        halo: parallel.rank.map(|rank| vec![0; rank]),
        targets: Vec::new(),
    };
    for field in &parallel.shapes {
        plan.fields.insert(*field, false);
    }
    for topology in &parallel.topology {
        *plan.fields.entry(topology.field).or_default() |= topology.call.changes();
    }
    for (field, changes) in &parallel.unchecked {
        *plan.fields.entry(*field).or_default() |= changes;
        plan.overlapping.push(*field);
    }
    if let Some(field) = parallel.head.field() {
        plan.fields.entry(field).or_default();
    }
    let shared = if parallel.relaxed { shared(kernel, number) } else { BTreeSet::new() };
    for &node in &parallel.accesses {
        let access = kernel.access(node);
        *plan.fields.entry(access.field).or_default() |= access.changes();
        let view = match access.usage() {
            Use::Update(..) if shared.contains(&node) => View::AccumulateTogether,
            Use::Exchange => View::Together,
            _ if shared.contains(&node) => View::Together,
            _ => view(kernel, number, access),
        };
        plan.note_reach(parallel.head.field(), parallel.rank, access, &view);
        if matches!(view, View::Any | View::OwnFree) && !parallel.jumps && !kernel.unchecked {
            plan.note_box(kernel.fields[access.field].rank, node, access);
        }
        plan.light &= matches!(view, View::Own | View::Row(_));
        if view == View::Accumulate {
            plan.note_target(access);
        }
        let same =
            |planned: &Planned| planned.field == access.field && planned.path == access.path && planned.view == view;
        let place = plan.views.iter().position(same).unwrap_or_else(|| {
            plan.views.push(Planned { field: access.field, path: access.path.clone(), view });
            plan.views.len() - 1
        });
        plan.view_of.insert(node, place);
    }
    plan.note_overlaps();
    plan.written_out = plan.light && !calls_behind_branches(kernel, &parallel.body);
    plan
}

/// The first row of the language's table that fits.
fn view(kernel: &Kernel, number: usize, access: &Access) -> View {
    let others =
        || kernel.loops[number].accesses.iter().map(|node| kernel.access(*node)).filter(|other| access.overlaps(other));
    if !others().any(Access::changes) {
        return match &access.place {
            Place::Own => View::Row(kernel.loops[number].rank.map_or(Vec::new(), |rank| vec![0; rank])),
            Place::Offset(_) if !matches!(access.boundary, Boundary::Checked) => View::Any,
            Place::Offset(offset) => View::Row(offset.clone()),
            Place::Places(_) | Place::Computed => View::Any,
        };
    }
    // What stands beside own writes without a clash is of the other colour.
    let foreign = |other: &Access| !other.is_own() && other.changes();
    let beside = |other: &Access| !other.changes() && across(kernel, number, other) == Across::Yes;
    if let (Place::Offset(offset), Action::Read) = (&access.place, &access.action) {
        return View::Beside(offset.clone());
    }
    let owned = others().all(|other| !foreign(other) && (other.is_own() || !access.changes() || beside(other)));
    match (&access.place, owned) {
        (Place::Own, true) => View::Own,
        (Place::Places(_), true) => View::OwnFree,
        _ => View::Accumulate,
    }
}

impl Plan {
    /// Offsets that the launch checks once, box against box.
    fn note_reach(&mut self, own: Option<usize>, rank: Option<usize>, access: &Access, view: &View) {
        let offset = match view {
            View::Row(offset) => offset.clone(),
            View::Own => rank.map_or(Vec::new(), |rank| vec![0; rank]),
            _ => return,
        };
        if let Some(halo) = &mut self.halo {
            halo.iter_mut().zip(&offset).for_each(|(halo, offset)| *halo = (*halo).max(offset.saturating_abs()));
        }
        if own == Some(access.field) && offset.iter().all(|offset| *offset == 0) {
            return;
        }
        let (low, high) = self.reach.entry(access.field).or_insert_with(|| (offset.clone(), offset.clone()));
        low.iter_mut().zip(&offset).for_each(|(low, offset)| *low = (*low).min(*offset));
        high.iter_mut().zip(&offset).for_each(|(high, offset)| *high = (*high).max(*offset));
    }

    /// An index that is checked once a launch.
    fn note_box(&mut self, rank: Option<usize>, node: usize, access: &Access) {
        let Some(places) = access.linear.as_ref().filter(|places| !places.is_empty() && rank == Some(places.len()))
        else {
            return;
        };
        let same = |known: &(usize, Vec<Linear>)| known.0 == access.field && known.1 == *places;
        let number = self.boxes.iter().position(same).unwrap_or_else(|| {
            self.boxes.push((access.field, places.clone()));
            self.boxes.len() - 1
        });
        self.box_of.insert(node, number);
    }

    fn note_target(&mut self, access: &Access) {
        let Some(group) = access.accumulates() else { return };
        let slot = self.targets.iter().position(|(field, _)| *field == access.field).unwrap_or_else(|| {
            self.targets.push((access.field, Vec::new()));
            self.targets.len() - 1
        });
        let members = &mut self.targets[slot].1;
        if !members.iter().any(|(path, _)| *path == access.path) {
            members.push((access.path.clone(), group));
        }
    }

    fn note_overlaps(&mut self) {
        let own: Vec<&Planned> = self.views.iter().filter(|planned| planned.view == View::Own).collect();
        for (place, a) in own.iter().enumerate() {
            for b in &own[..place] {
                let shorter = a.path.len().min(b.path.len());
                if a.field == b.field && a.path[..shorter] == b.path[..shorter] {
                    self.overlapping.push(a.field);
                }
            }
        }
    }
}
