//! After which steps a run does what: pictures and checkpoints.

/// After which steps a run does what. Frames are numbered from zero at the start, and the end is one too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calendar {
    /// Steps that the run takes.
    pub steps: u64,
    /// Steps from one frame to the next; none are made without.
    pub every: Option<u64>,
    /// Steps from one checkpoint to the next.
    pub checkpoint_every: Option<u64>,
}

impl Calendar {
    /// The first step after `done` after which there is something to do.
    pub fn next(&self, done: u64) -> u64 {
        let due = |every: Option<u64>| every.and_then(|every| (done / every + 1).checked_mul(every));
        [due(self.every), due(self.checkpoint_every)].into_iter().flatten().fold(self.steps, u64::min)
    }

    /// The number of the frame after that step, if there is one.
    pub fn frame(&self, step: u64) -> Option<u64> {
        let every = self.every?;
        (step.is_multiple_of(every) || step == self.steps).then(|| step.div_ceil(every))
    }

    /// How many frames there are once that step is done.
    pub fn frames(&self, step: u64) -> u64 {
        self.every.map_or(0, |every| step / every + 1 + u64::from(step == self.steps && !step.is_multiple_of(every)))
    }

    /// The step after which a frame is made.
    pub fn step(&self, frame: u64) -> u64 {
        self.every.map_or(0, |every| frame.saturating_mul(every).min(self.steps))
    }

    /// Whether a checkpoint is due after that step.
    pub fn checkpoint(&self, step: u64) -> bool {
        self.checkpoint_every.is_some_and(|every| step.is_multiple_of(every) || step == self.steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_and_checkpoints_come_when_they_are_due() {
        let calendar = Calendar { steps: 100, every: Some(30), checkpoint_every: Some(40) };
        let mut stops = vec![0];
        while stops[stops.len() - 1] < 100 {
            stops.push(calendar.next(stops[stops.len() - 1]));
        }
        assert_eq!(stops, [0, 30, 40, 60, 80, 90, 100]);
        let frames: Vec<_> = stops.iter().filter_map(|&step| calendar.frame(step)).collect();
        assert_eq!(frames, [0, 1, 2, 3, 4]);
        for frame in frames {
            assert_eq!(calendar.frame(calendar.step(frame)), Some(frame));
            assert_eq!(calendar.frames(calendar.step(frame)), frame + 1);
        }
        let saved: Vec<_> = stops.iter().copied().filter(|&step| step > 0 && calendar.checkpoint(step)).collect();
        assert_eq!(saved, [40, 80, 100]);
        assert_eq!(calendar.frames(95), 4);
    }

    #[test]
    fn a_longer_run_goes_on_as_if_it_had_been_asked_for_at_once() {
        let short = Calendar { steps: 100, every: Some(30), checkpoint_every: None };
        let long = Calendar { steps: 200, ..short };
        assert_eq!(short.frames(100), 5);
        // The frame at the end of the shorter run was out of turn: its number is given to the next one.
        assert_eq!((long.frames(100), long.next(100), long.frame(120)), (4, 120, Some(4)));
    }

    #[test]
    fn a_run_may_have_no_frames() {
        let none = Calendar { steps: 10, every: None, checkpoint_every: None };
        assert_eq!((none.next(0), none.frame(0), none.frames(10)), (10, None, 0));
        assert!(!none.checkpoint(10));
    }
}
