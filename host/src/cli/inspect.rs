//! `motes inspect`.

use miette::IntoDiagnostic;

use super::Failure;
use super::arguments::InspectArguments;
use super::run::passed_over;
use crate::checkpoints::Resumption;
use crate::io::{Header, Origin};

/// Prints what a checkpoint is of.
pub(super) fn inspect(arguments: &InspectArguments) -> Result<(), Failure> {
    let found = Resumption::find(&arguments.from).map_err(Failure::input)?;
    passed_over(&found);
    let header = &found.checkpoint.header;
    if arguments.json {
        let json = serde_json::to_string(header).into_diagnostic();
        return super::print(&format!("{}\n", json.map_err(Failure::Run)?));
    }
    let Header {
        motes,
        scenario,
        origin,
        scalar,
        particles,
        step,
        time,
        end,
        digest,
        ..
    } = header;
    let origin = match origin {
        Origin::BuiltIn(_) => "built in".to_owned(),
        Origin::File(path) => path.display().to_string(),
    };
    let size = indicatif::HumanBytes(found.checkpoint.size() as u64);
    super::print(&format!(
        "checkpoint {} ({size}, motes {motes})\n\
         scenario   {scenario} ({origin})\n\
         scalar     {scalar}\n\
         particles  {particles}\n\
         steps      {step}\n\
         time       {time} of {end}\n\
         digest     {digest}\n",
        found.file.display()
    ))
}
