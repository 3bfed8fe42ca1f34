//! Of which states the solution is known, and what is said where it is not.

use super::*;
use crate::linear::Exact;

/// A ring, or a square with `dimension = 2`, with these lines in `[system]` and `[initial]`.
fn scenario(sides: &str, system: &str, initial: &str) -> String {
    let dimension = 1 + sides.matches(',').count();
    let corner = |x: f64| format!("{:?}", vec![x; dimension]);
    format!(
        "name = \"s\"\ndimension = {dimension}\n[domain]\nlower = {}\nupper = {}\n\
         sides = [{sides}]\n[initial]\n{initial}\n[resolution]\nparticles = 100\n\
         [time]\nend = 0.5\n[output]\nexact = \"initial\"\n\
         [system]\nkind = \"convection-diffusion\"\ndiffusivity = 0.1\n{system}\n",
        corner(-1.0),
        corner(1.0)
    )
}

const RING: &str = "\"periodic\"";
const WALLS: &str = "\"mirror\"";
const SQUARE: &str = "\"periodic\", \"periodic\"";
const OPEN: &str = "\"free\", \"free\"";
const CHANNEL: &str = "\"periodic\", \"mirror\"";

const GAUSSIAN: &str = "kind = \"gaussian\"\nwidth = 0.1";
const MODE: &str = "kind = \"modes\"\nwave = [1]\nstate = [1.0]";
const OBLIQUE: &str = "kind = \"modes\"\nwave = [1, 1]\nstate = [1.0]";
const ALONG: &str = "kind = \"modes\"\nwave = [0, 2]\nstate = [1.0]";
const UNIFORM: &str = "kind = \"uniform\"\nstate = [1.0]";
const BAND: &str = "kind = \"band\"\nlength = 0.5\nwidth = 0.1";
const LEGENDRE: &str = "kind = \"legendre\"\ndegree = 3";

const SHIFT: &str = "velocity = { kind = \"uniform\", velocity = [1.0] }";
const SLIDE: &str = "velocity = { kind = \"uniform\", velocity = [1.0, 0.0] }";
const TURN: &str = "velocity = { kind = \"rotation\", rate = 1.0 }";
const SHEAR: &str = "velocity = { kind = \"shear\", rate = 1.0 }";
const WAVE: &str = "velocity = { kind = \"wave\", amplitude = 0.1 }";
const LAYERS: &str = "profile = { kind = \"layers\", bounds = [0.0], factors = [1.0, 2.0] }";
const PARABOLA: &str = "profile = { kind = \"parabola\" }";
const SWING: &str = "modulation = { amplitude = 0.5, rate = 1.0 }";
const TENSOR: &str = "tensor = [[1.0, 0.3], [0.3, 0.5]]";
const DIAGONAL: &str = "tensor = [[1.0, 0.0], [0.0, 0.5]]";
const DECAY: &str = "reaction = { kind = \"linear\", matrix = [[-1.0]] }";
const SOURCE: &str = "reaction = { kind = \"linear\", matrix = [[-1.0]], source = [1.0] }";
const LOGISTIC: &str = "reaction = { kind = \"logistic\", rate = 1.0, capacity = 1.0 }";
const COLD: &str = "[[wall]]\naxis = \"x\"\nend = \"upper\"\nkind = \"value\"\nvalue = 0.0";
const COLD_Y: &str = "[[wall]]\naxis = \"y\"\nend = \"upper\"\nkind = \"value\"\nvalue = 0.0";

#[test]
fn a_known_solution_may_be_compared_with() {
    let both = |a: &str, b: &str| format!("{a}\n{b}");
    for (sides, system, initial) in [
        (RING, "", GAUSSIAN),
        (RING, SHIFT, GAUSSIAN),
        (RING, DECAY, GAUSSIAN),
        (SQUARE, &both(TENSOR, SLIDE), GAUSSIAN),
        (SQUARE, &both(SWING, SLIDE), GAUSSIAN),
        (OPEN, &both(SWING, TURN), GAUSSIAN),
        (OPEN, SHEAR, GAUSSIAN),
        (RING, DECAY, MODE),
        (WALLS, "", MODE),
        (SQUARE, TENSOR, OBLIQUE),
        (CHANNEL, DIAGONAL, ALONG),
        (RING, SHIFT, BAND),
        (CHANNEL, SLIDE, BAND),
        (OPEN, "", BAND),
        (WALLS, &both(PARABOLA, SWING), LEGENDRE),
        (WALLS, COLD, UNIFORM),
        (WALLS, &both(LAYERS, COLD), UNIFORM),
    ] {
        let text = scenario(sides, system, initial);
        assert_eq!(read(&text).output.exact, Some(Exact::Initial));
    }
}

#[test]
fn an_unknown_solution_is_refused_with_the_reason() {
    let both = |a: &str, b: &str| format!("{a}\n{b}");
    let two = "species = [\"u\", \"v\"]";
    let pair = |initial: &str| initial.replace("[1.0]", "[1.0, 1.0]");
    let unlike = both(two, "").replace('\n', "");
    let spots =
        "kind = \"spots\"\nbackground = [0.0]\nspot = [1.0]\ncenters = [[0.0]]\nwidth = 0.1";
    let narrow = "profile = { kind = \"parabola\", radius = 0.5 }";
    for (sides, system, initial, reason) in [
        (RING, LAYERS, GAUSSIAN, "the profile is layers, not uniform"),
        (WALLS, "", GAUSSIAN, "a wall throws it back"),
        (RING, SOURCE, GAUSSIAN, "the linear reaction has a source"),
        (RING, LOGISTIC, GAUSSIAN, "the reaction is logistic"),
        (RING, WAVE, GAUSSIAN, "the velocity is wave"),
        (
            OPEN,
            &both(TENSOR, TURN),
            GAUSSIAN,
            "the tensor's directions",
        ),
        (
            OPEN,
            &both(SWING, SHEAR),
            GAUSSIAN,
            "is shear, and there is a modulation",
        ),
        (RING, LAYERS, MODE, "the profile is layers"),
        (RING, SHIFT, MODE, "the velocity is uniform, not still"),
        (RING, SWING, MODE, "changes in time"),
        (RING, SOURCE, MODE, "has a source"),
        (CHANNEL, "", OBLIQUE, "meets a wall at an angle"),
        (RING, LAYERS, BAND, "the profile is layers"),
        (OPEN, SHEAR, BAND, "neither still nor uniform"),
        (RING, two, BAND, "there are 2 species"),
        (SQUARE, TENSOR, BAND, "there is a tensor"),
        (RING, SWING, BAND, "changes in time"),
        (RING, DECAY, BAND, "the reaction is linear, not none"),
        (WALLS, "", BAND, "there is a wall along x"),
        (CHANNEL, COLD_Y, BAND, "something passes a [[wall]]"),
        (RING, &both(PARABOLA, SHIFT), LEGENDRE, "not still"),
        (WALLS, &both(PARABOLA, two), LEGENDRE, "there are 2 species"),
        (WALLS, &both(PARABOLA, DECAY), LEGENDRE, "not none"),
        (RING, PARABOLA, LEGENDRE, "a side along x is no wall"),
        (WALLS, &both(PARABOLA, COLD), LEGENDRE, "something passes"),
        (
            WALLS,
            narrow,
            LEGENDRE,
            "falls to 0 at -0.5 and 0.5, not at the sides",
        ),
        (CHANNEL, "", UNIFORM, "dimension = 2, not 1"),
        (RING, "", UNIFORM, "a side along x is no wall"),
        (WALLS, WAVE, UNIFORM, "not still"),
        (WALLS, DECAY, UNIFORM, "not none"),
        (WALLS, SWING, UNIFORM, "changes in time"),
        (WALLS, PARABOLA, UNIFORM, "the profile is parabola"),
        (WALLS, two, &pair(UNIFORM), "there are 2 species"),
        (RING, "", spots, "no solution is known"),
    ] {
        let text = scenario(sides, system, initial);
        let error = linear(&text, &[]).expect_err(reason);
        let kind = initial.split('"').nth(1).unwrap();
        let start = format!("output.exact = \"initial\" does not fit: the solution of {kind}");
        assert_report_holds(&error, &[&start, reason, "leave `exact` out"]);
        let without = text.replace("exact = \"initial\"", "");
        assert_eq!(read(&without).output.exact, None, "the run itself is fine");
    }
    let text = scenario(RING, &unlike, GAUSSIAN).replace("= 0.1\nspecies", "= [0.1, 0.2]\nspecies");
    let error = linear(&text, &[]).unwrap_err();
    assert_report_holds(&error, &["the diffusivities of the species differ"]);
    let tube = scenario("\"free\", \"free\", \"periodic\"", TURN, GAUSSIAN);
    let error = linear(&tube, &[]).unwrap_err();
    assert_report_holds(&error, &["is rotation, and a direction is periodic"]);
}
