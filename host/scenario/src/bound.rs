//! The ranges of numbers that several keys share.

use crate::entry::Bound;

pub(super) const POSITIVE: Bound = Bound {
    need: "> 0",
    holds: |value| value > 0.0,
    cure: "give a number larger than 0",
};

pub(super) const NOT_NEGATIVE: Bound = Bound {
    need: ">= 0",
    holds: |value| value >= 0.0,
    cure: "give 0 or a positive number",
};

pub(super) const DAMPING: Bound = Bound {
    need: ">= 0",
    holds: |value| value >= 0.0,
    cure: "give 0 or a positive number: a negative one would feed shocks instead of damping them",
};

pub(super) const GAMMA: Bound = Bound {
    need: "> 1",
    holds: |value| value > 1.0,
    cure: "give the ratio of the specific heats, for example 1.4 for air or 1.6667 for argon",
};

pub(super) const COURANT: Bound = Bound {
    need: "> 0 and at most 1",
    holds: |value| value > 0.0 && value <= 1.0,
    cure: "0.3 is safe; larger steps are faster and less stable",
};

pub(super) const FRACTION: Bound = Bound {
    need: ">= 0 and < 0.5",
    holds: |value| (0.0..0.5).contains(&value),
    cure: "give the fraction of a spacing by which a particle may be moved: from 0.5 on two \
           particles could meet",
};

pub(super) const AMPLITUDE: Bound = Bound {
    need: "> -1 and < 1",
    holds: |value| value > -1.0 && value < 1.0,
    cure: "give the relative change of the density, for example 1e-3: from 1 on the density \
           would fall to 0",
};

pub(super) const PART: Bound = Bound {
    need: "> -1 and below 1",
    holds: |value| value.abs() < 1.0,
    cure: "give a part, for example 0.5: at 1 the diffusivity falls to 0, beyond it below 0",
};

pub(super) const THETA: Bound = Bound {
    need: "> 0 and at most 1",
    holds: |value| value > 0.0 && value <= 1.0,
    cure: "1 keeps the number of neighbours; 0.75 lets it grow as the spacing falls",
};

pub(super) const DISTORTION: Bound = Bound {
    need: "> 0 and at most 0.15",
    holds: |value| value > 0.0 && value <= 0.15,
    cure: "give the largest displacement in lengths of the domain, for example 0.05: near 0.159 \
           particles would meet",
};
